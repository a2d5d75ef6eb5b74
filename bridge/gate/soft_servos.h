// Controllers whose servos are far softer than those of a stop, as of a learned policy: their set-points are not where the
// joints go but what asks for torque, so a hold with stiffer servos must begin where the joints are.
//
//     kp' (q' - q) + kd' (qd_set - qd) = kp (q_set - q) + kd (qd_set - qd)

#pragma once

#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

// What was measured last, per joint on the bus.
struct MeasuredJoints {
  bool known = false;
  PerJoint<double> q{};  // [rad or m]
  PerJoint<float> qd{};  // [rad/s or m/s]
};

// Bit per joint whose kp in the command is less than half of the stiffness given.
std::int64_t soft_joints(const JointCommand& command, const PerJoint<float>& kp, int joint_count) noexcept;

// Gives the joints of the mask other gains and the set-point q' that asks for the torque they give now.
void stiffen(const MeasuredJoints& measured, const PerJoint<float>& kp, const PerJoint<float>& kd, std::int64_t mask,
             JointCommand& command) noexcept;

}  // namespace twinbus::bridge
