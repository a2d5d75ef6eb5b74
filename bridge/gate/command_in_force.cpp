#include "bridge/gate/command_in_force.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline bridge {

namespace {

constexpr float kTorqueJump = 0.02F;  // of the limit; a larger one is of the switch

float servo(const JointCommand& command, const RobotState& measured, std::size_t i) noexcept {
  return command.kp[i] * static_cast<float>(command.q[i] - measured.q[i]) + command.kd[i] * (command.qd[i] - measured.qd[i]);
}

// Of all joints, as the servos give it.
PerJoint<float> torques_of(const JointCommand& command, const RobotState& measured, const GateLimits& limits) noexcept {
  PerJoint<float> tau{};
  for (int j = 0; j < limits.joint_count; ++j) {
    const std::size_t i = at(j);
    const auto effort = static_cast<float>(limits.effort[i]);
    const float asked = servo(command, measured, i) + command.tau[i];
    const bool pair = limits.pairs.with(limits.robot->bus_joints[i]) != nullptr;  // limited at its motors
    tau[i] = pair ? asked : std::clamp(asked, -effort, effort);
  }
  limits.pairs.limit(measured.q, tau);
  return tau;
}

template <class T>
T between(T before, T newest, float share) noexcept {
  return before + static_cast<T>(share) * (newest - before);
}

}  // namespace

bool find_command_in_force(const RobotState& measured, const JointCommand& before, const JointCommand& newest,
                           const GateLimits& limits, JointCommand& in_force) noexcept {
  in_force = newest;
  const PerJoint<float> firsts = torques_of(before, measured, limits), lasts = torques_of(newest, measured, limits);
  bool explained = true;
  for (int j = 0; j < limits.joint_count && explained; ++j) {
    const std::size_t i = at(j);
    const auto effort = static_cast<float>(limits.effort[i]), near = kTorqueJump * effort;
    const float tau = measured.tau[i];
    const float first = firsts[i], last = lasts[i];
    if (std::abs(tau - last) <= near) continue;  // it acts
    const bool one_servo = before.kp[i] == newest.kp[i] && before.kd[i] == newest.kd[i];
    if (!one_servo && std::abs(tau - first) <= near) {
      in_force.q[i] = before.q[i], in_force.qd[i] = before.qd[i], in_force.tau[i] = before.tau[i];
      in_force.kp[i] = before.kp[i], in_force.kd[i] = before.kd[i];
      continue;
    }
    explained = one_servo && tau >= std::min(first, last) - near && tau <= std::max(first, last) + near;
    const float share = std::clamp((tau - first) / (last - first), 0.0F, 1.0F);
    in_force.q[i] = between(before.q[i], newest.q[i], share);
    in_force.qd[i] = between(before.qd[i], newest.qd[i], share);
    in_force.tau[i] = between(before.tau[i], newest.tau[i], share);
  }
  if (explained) return true;
  in_force = newest;
  for (int j = 0; j < limits.joint_count; ++j) in_force.tau[at(j)] = measured.tau[at(j)] - servo(newest, measured, at(j));
  return false;
}

}  // namespace twinbus::bridge
