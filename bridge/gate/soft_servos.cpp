#include "bridge/gate/soft_servos.h"

#include "common/math/index.h"

namespace twinbus::inline bridge {

namespace {
constexpr float kSoft = 0.5F;  // of the stiffness of a stop
}

std::int64_t soft_joints(const JointCommand& command, const PerJoint<float>& kp, int joint_count) noexcept {
  std::int64_t mask = 0;
  for (int j = 0; j < joint_count; ++j) {
    if (command.kp[at(j)] < kSoft * kp[at(j)]) mask |= bit(j);
  }
  return mask;
}

void stiffen(const MeasuredJoints& measured, const PerJoint<float>& kp, const PerJoint<float>& kd, std::int64_t mask,
             JointCommand& command) noexcept {
  if (!measured.known) return;
  for (int j = 0; j < command.joint_count; ++j) {
    const std::size_t i = at(j);
    if ((mask & bit(j)) == 0 || !(kp[i] > 0.0F)) continue;
    const double rate = static_cast<double>(command.qd[i] - measured.qd[i]);
    const double torque = static_cast<double>(command.kp[i]) * (command.q[i] - measured.q[i]) +
                          static_cast<double>(command.kd[i] - kd[i]) * rate;
    command.q[i] = measured.q[i] + torque / static_cast<double>(kp[i]);
    command.kp[i] = kp[i];
    command.kd[i] = kd[i];
  }
}

}  // namespace twinbus::bridge
