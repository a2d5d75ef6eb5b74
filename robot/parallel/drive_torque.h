// Torque and servos of two joints that two motors turn over rods.

#pragma once

#include <algorithm>
#include <cmath>

#include "robot/parallel/rod_drive.h"

namespace twinbus::inline robot {

// What is left of the torques that two joints are asked for when each motor gives no more than its limit.
struct LimitedTorque {
  Eigen::Vector2d tau = Eigen::Vector2d::Zero();     // of the joints [N m]
  Eigen::Vector2d motors = Eigen::Vector2d::Zero();  // within their limits [N m]
  bool limited = false;
};

// jacobian: d motors / d joints, invertible; limit: of the motors [N m]; asked: of the joints [N m].
inline LimitedTorque limit_at_motors(const Eigen::Matrix2d& jacobian, const Eigen::Vector2d& limit,
                                     const Eigen::Vector2d& asked) noexcept {
  const Eigen::Matrix2d to_motors = jacobian.transpose().inverse();
  LimitedTorque out;
  const Eigen::Vector2d wanted = to_motors * asked;
  out.motors = wanted.cwiseMax(-limit).cwiseMin(limit);
  if (out.motors == wanted) {
    out.tau = asked;
    return out;
  }
  out.limited = true;
  out.tau = jacobian.transpose() * out.motors;
  return out;
}

// A servo of two axes, of the joints or of the motors: kp (q - q_now) + kd (qd - qd_now) + tau.
struct PairServo {
  Eigen::Vector2d q = Eigen::Vector2d::Zero(), qd = Eigen::Vector2d::Zero(), tau = Eigen::Vector2d::Zero();
  Eigen::Vector2d kp = Eigen::Vector2d::Zero(), kd = Eigen::Vector2d::Zero();
};

// Servos of the motors that do what servos of the joints would.  A drive has one gain a motor, so the stiffness of the joints,
// J^-T K J^-1, is not theirs to the full: gains are those whose stiffness of the joints, the diagonal of J^T K_m J, is nearest to
// what was asked for (relative least squares, none below 0); the feed-forward torque adds what is missing of the stiffness at
// q_now.  Of the damping nothing is added: a tick later it would drive what it is to damp.  posture: at q_now.  False: the target
// cannot be reached over the rods.
[[nodiscard]] bool servo_of_motors(const RodDrive& drive, const PairServo& joints, const Eigen::Vector2d& q_now,
                                   const RodPosture& posture, PairServo& motors) noexcept;
// Servos of the joints that do what servos of the motors do at q_now, as stiff as the diagonal of J^T K_m J.
[[nodiscard]] bool servo_of_joints(const RodDrive& drive, const PairServo& motors, const Eigen::Vector2d& q_now,
                                   const Eigen::Vector2d& qd_now, const RodPosture& posture, PairServo& joints) noexcept;

}  // namespace twinbus::robot
