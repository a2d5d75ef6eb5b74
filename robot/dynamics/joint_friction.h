// Torque that overcomes what the robot's description says of a joint's friction and damping, as it moves at a wanted speed.
//
// Coulomb friction and viscous damping of the URDF's <dynamics>: M. W. Spong, S. Hutchinson, M. Vidyasagar, Robot Modeling and
// Control (2006), section 6.2 (feedforward).  The speed is one that is asked for, never one that is measured: near standstill the sign of
// a measured speed is noise, and its feedback makes a joint hunt.

#pragma once

#include <algorithm>

#include <Eigen/Core>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// Slower than this the friction is not reckoned in full, so that the torque has no jump where the joint turns round [rad/s], [m/s].
inline constexpr double kFrictionSpeed = 0.05;
// Of the friction that is stated.  More than there is would push the joint by itself.
inline constexpr double kFrictionShare = 0.9;

// qd [rad/s], [m/s]: wanted.  [N m], [N].  Of Coulomb friction alone, and of both.
inline double coulomb_torque(const Joint& joint, double qd) noexcept {
  return kFrictionShare * joint.friction * std::clamp(qd / kFrictionSpeed, -1.0, 1.0);
}
inline double friction_torque(const Joint& joint, double qd) noexcept {
  return coulomb_torque(joint, qd) + kFrictionShare * joint.damping * qd;
}

// Of all joints of `tau`, [joint_count].
inline void add_friction(const Model& model, const Eigen::VectorXd& qd, Eigen::VectorXd& tau) noexcept {
  for (Eigen::Index j = 0; j < tau.size(); ++j) tau[j] += friction_torque(model.joints[static_cast<std::size_t>(j)], qd[j]);
}

}  // namespace twinbus::robot
