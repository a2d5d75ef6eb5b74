// The energy of a robot in a world, link by link.

#pragma once

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/kinematics.h"
#include "sim/world/world.h"

namespace twinbus::test {

// Kinetic and potential [J].
inline double energy(const Model& model, const World& world, Kinematics& kinematics) {
  kinematics.update(world.configuration());
  double e = 0.0;
  for (int i = 0; i < model.link_count(); ++i) {
    const Link& link = model.links[static_cast<std::size_t>(i)];
    const Eigen::Vector3d at = kinematics.link_in_world(i) * link.com;
    const Eigen::Matrix3d& r = kinematics.link_in_world(i).linear();
    const Eigen::Vector3d w = r.transpose() * kinematics.angular_velocity(i);
    e += link.mass * (0.5 * kinematics.point_velocity(i, at).squaredNorm() + kGravity * at.z());
    e += 0.5 * w.dot(link.inertia * w);
  }
  return e;
}

}  // namespace twinbus::test
