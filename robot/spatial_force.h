// Spatial vectors in world axes about one common point, the origin of link 0: angular part first.
//
// About a common point inertias of links add up without being moved (Featherstone 2008, section
// 2.13), which is what makes the algorithms that include this file short.

#pragma once

#include <Eigen/Geometry>

#include "robot/kinematics.h"

namespace twinbus {

using Spatial = Eigen::Matrix<double, 6, 1>;
using SpatialMatrix = Eigen::Matrix<double, 6, 6>;

// Of a link and what moves with it rigidly.
struct RigidInertia {
  double mass = 0.0;                                  // [kg]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();   // mass times centre of mass [kg m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the common point [kg m^2]

  void add(const RigidInertia& other) noexcept {
    mass += other.mass;
    moment += other.moment;
    inertia += other.inertia;
  }
  // Momentum of the motion (omega, v).
  Spatial times(const Spatial& motion) const noexcept {
    const Eigen::Vector3d omega = motion.head<3>();
    const Eigen::Vector3d v = motion.tail<3>();
    Spatial momentum;
    momentum.head<3>().noalias() = inertia * omega;
    momentum.head<3>() += moment.cross(v);
    momentum.tail<3>() = mass * v + omega.cross(moment);
    return momentum;
  }
};

inline RigidInertia rigid_inertia(const Model& model, const Kinematics& k, int link) noexcept {
  const Link& of = model.links[static_cast<std::size_t>(link)];
  const Eigen::Vector3d c = k.com_of_link(link) - k.link_in_world(0).translation();
  const Eigen::Matrix3d& r = k.link_in_world(link).linear();
  RigidInertia result;
  result.mass = of.mass;
  result.moment = of.mass * c;
  Eigen::Matrix3d turned;
  turned.noalias() = r * of.inertia;
  result.inertia.noalias() = turned * r.transpose();
  result.inertia.noalias() -= result.moment * c.transpose();
  const double square = result.moment.dot(c);
  result.inertia.diagonal().array() += square;
  return result;
}

// Motion of joint j at unit speed.
inline Spatial joint_motion(const Model& model, const Kinematics& k, int joint) noexcept {
  const Eigen::Vector3d& axis = k.axis_in_world(joint);
  Spatial motion;
  if (model.joints[static_cast<std::size_t>(joint)].kind == JointKind::kPrismatic) {
    motion << Eigen::Vector3d::Zero(), axis;
  } else {
    const Eigen::Vector3d arm =
        k.link_in_world(joint + 1).translation() - k.link_in_world(0).translation();
    motion << axis, arm.cross(axis);
  }
  return motion;
}

// v x m: change of the motion m that moves with v.
inline Spatial cross_motion(const Spatial& v, const Spatial& m) noexcept {
  const Eigen::Vector3d w = v.head<3>();
  const Eigen::Vector3d mw = m.head<3>();
  Spatial result;
  result << w.cross(mw),
      w.cross(Eigen::Vector3d(m.tail<3>())) + Eigen::Vector3d(v.tail<3>()).cross(mw);
  return result;
}

// v x* f: change of the force or momentum f that moves with v.
inline Spatial cross_force(const Spatial& v, const Spatial& f) noexcept {
  const Eigen::Vector3d w = v.head<3>();
  const Eigen::Vector3d ff = f.tail<3>();
  Spatial result;
  result << w.cross(Eigen::Vector3d(f.head<3>())) + Eigen::Vector3d(v.tail<3>()).cross(ff),
      w.cross(ff);
  return result;
}

}  // namespace twinbus
