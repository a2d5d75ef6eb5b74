#include "control/legs/leg_reach.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "robot/kinematics/leg_motion.h"
#include "common/math/index.h"
#include "robot/dynamics/joint_inertia.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline control {

namespace {
constexpr int kAngles = 400;
constexpr double kAlong = 0.7;  // cosine: an axis so nearly along another

double leg_length(const Kinematics& k, const LegChain& leg) {
  return (k.link_in_world(leg.ankle() + 1).translation() -
          k.link_in_world(leg.joint[0] + 1).translation())
      .norm();
}
}  // namespace

LegReach leg_reach(const Model& model, int foot) {
  const LegChain leg = leg_chain(model, foot);
  Configuration configuration(model);
  Kinematics kinematics(model);
  LegReach reach;
  double most = 0.0;
  for (const int joint : leg) {
    const Joint& j = model.joints[at(joint)];
    const double low = std::max(j.lower, -3.0), high = std::min(j.upper, 3.0);
    double shortest = 1e9, longest = 0.0, best = 0.0, bent = 0.0;
    for (int i = 0; i <= kAngles; ++i) {
      const double angle = low + (high - low) * i / kAngles;
      configuration.q.setZero();
      configuration.q[joint] = angle;
      kinematics.update(configuration);
      const double length = leg_length(kinematics, leg);
      if (length > longest) {
        longest = length;
        best = angle;
      }
      if (length < shortest) {
        shortest = length;
        bent = angle;
      }
    }
    if (longest - shortest > most) {
      most = longest - shortest;
      reach.knee = joint;
      reach.straight = best;
      reach.bends = bent > best ? 1.0 : -1.0;
      reach.longest = longest;
    }
  }
  if (!(most > 0.1 * reach.longest))
    throw std::runtime_error("robot " + model.name + ": no joint of a leg bends it like a knee");
  configuration.q.setZero();
  configuration.q[reach.knee] = reach.straight;
  kinematics.update(configuration);
  const Sole& sole = model.soles[at(foot)];
  const Eigen::Vector3d ankle = kinematics.link_in_world(leg.ankle() + 1).translation();
  const Eigen::Vector3d hip = kinematics.link_in_world(leg.joint[0] + 1).translation();
  const Eigen::Vector3d ground = (kinematics.link_in_world(sole.link) * sole.frame).translation();
  reach.ankle_height = std::abs(ankle.z() - ground.z());
  const Eigen::Vector3d other =
      kinematics.link_in_world(leg_chain(model, 1 - foot).joint[0] + 1).translation();
  reach.hip_width = (hip - other).norm();
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(kinematics.axis_in_world(leg.joint[k]).z()) < 0.9) continue;
    const Joint& j = model.joints[at(leg.joint[k])];
    reach.turn = std::min({-j.lower, j.upper, 1.5});
  }
  if (free_axis(model, foot) == 2) reach.turn = 0.0;
  JointInertia inertia(model);
  const auto hips = std::span(leg.begin(), std::find(leg.begin(), leg.end(), reach.knee));
  inertia.update(kinematics, hips);
  for (int k = 0; k < inertia.size(); ++k) {
    const int hip_joint = hips[at(k)];
    const Eigen::Vector3d axis = kinematics.axis_in_world(hip_joint);
    const Eigen::Vector3d way = axis.cross(ground - kinematics.link_in_world(hip_joint + 1).translation());  // [m/rad]
    const double thrown = model.joints[at(hip_joint)].effort / inertia(k, k);                                  // [rad/s^2]
    if (std::abs(axis.y()) > kAlong) reach.swing.x() = std::abs(way.x()) * thrown;
    if (std::abs(axis.x()) > kAlong) reach.swing.y() = std::abs(way.y()) * thrown;
  }
  return reach;
}

}  // namespace twinbus::control
