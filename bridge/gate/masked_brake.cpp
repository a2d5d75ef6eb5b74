#include "bridge/gate/masked_brake.h"

#include <algorithm>

#include "common/math/index.h"
#include "robot/kinematics/brake.h"

namespace twinbus::inline bridge {

MaskedBrake::Released MaskedBrake::hold(std::int64_t mask, const GateLimits& limits, const JointCommand& client,
                                        const MeasuredJoints& measured, JointCommand& effective) noexcept {
  const std::int64_t begin = mask & ~joints_, end = joints_ & ~mask;
  Released released;
  for (int j = 0; j < limits.joint_count && (begin | end) != 0; ++j) {
    const std::size_t i = at(j);
    const Joint& joint = limits.robot->joints[at(limits.robot->bus_joints[i])];
    if ((end & bit(j)) != 0)
      (is_soft(static_cast<double>(client.kp[i]), joint) ? released.at_once : released.faded) |= bit(j);
    if (!measured.known || (begin & bit(j)) == 0) continue;
    const BrakeStart start = brake_start(effective.q[i], static_cast<double>(effective.qd[i]), measured.q[i],
                                         static_cast<double>(measured.qd[i]), limits.velocity[i],
                                         is_soft(static_cast<double>(effective.kp[i]), joint));
    effective.q[i] = start.q;
    effective.qd[i] = static_cast<float>(start.v);
    effective.tau[i] *= static_cast<float>(start.share);
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

}  // namespace twinbus::bridge
