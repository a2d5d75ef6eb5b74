#include "bridge/gate/masked_brake.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "robot/kinematics/brake.h"

namespace twinbus {

MaskedBrake::Released MaskedBrake::hold(std::int64_t mask, const GateLimits& limits, const JointCommand& client,
                                        const MeasuredJoints& measured, JointCommand& effective) noexcept {
  const std::int64_t begin = mask & ~joints_, end = joints_ & ~mask;
  Released released;
  for (int j = 0; j < limits.joint_count && (begin | end) != 0; ++j) {
    const std::size_t i = at(j);
    const Joint& joint = limits.robot->joints[at(limits.robot->bus_joints[i])];
    if ((end & bit(j)) != 0)
      (is_soft(static_cast<double>(client.kp[i]), joint) ? released.at_once : released.faded) |= bit(j);
    const bool stays =
        !is_soft(static_cast<double>(effective.kp[i]), joint) && std::abs(effective.q[i] - measured.q[i]) <= kFarSetPoint;
    if (!measured.known || stays || (begin & bit(j)) == 0) continue;
    const auto fastest = static_cast<float>(limits.velocity[i]);
    effective.q[i] = measured.q[i];
    effective.qd[i] = std::clamp(measured.qd[i], -fastest, fastest);
    effective.tau[i] = 0.0F;
    effective.kp[i] = std::max(effective.kp[i], limits.stop_kp[i]);
    effective.kd[i] = std::max(effective.kd[i], limits.stop_kd[i]);
  }
  joints_ = mask;
  return released;
}

void MaskedBrake::apply(const GateLimits& limits, const JointCommand& effective, JointCommand& command) const noexcept {
  for (int j = 0; j < limits.joint_count; ++j) {
    if ((joints_ & bit(j)) == 0) continue;
    const std::size_t i = at(j);
    command.q[i] = effective.q[i];
    command.qd[i] = effective.qd[i];
    brake_step(limits.brake[i], limits.period, command.q[i], command.qd[i]);
    command.tau[i] = effective.tau[i];
    command.kp[i] = effective.kp[i];
    command.kd[i] = effective.kd[i];
  }
}

}  // namespace twinbus
