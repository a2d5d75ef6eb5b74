#include "control/loop/mask_brake.h"

#include "robot/kinematics/brake.h"

namespace twinbus::inline control {

void MaskBrake::apply(SetPoint& set_point, std::int64_t mask, double dt) noexcept {
  for (int j = 0; j < model_->bus_count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const bool masked = ((mask >> j) & 1) != 0;
    if (masked) {
      if (phase_[k] == Phase::kFree) {
        q_[k] = set_point.q[k];
        qd_[k] = set_point.qd[k];
      }
      phase_[k] = Phase::kHeld;
      const Joint& joint = model_->joints[static_cast<std::size_t>(model_->bus_joints[k])];
      brake_step(brake_deceleration(joint), dt, q_[k], qd_[k]);
      set_point.q[k] = q_[k];
      set_point.qd[k] = qd_[k];
      continue;
    }
    if (phase_[k] == Phase::kHeld) {
      phase_[k] = Phase::kReturning;
      offset_[k].aim_from(q_[k] - set_point.q[k], qd_[k] - set_point.qd[k], 0.0, 0.0, model_->blend_s);
    }
    if (phase_[k] == Phase::kReturning) {
      offset_[k].advance(dt);
      set_point.q[k] += offset_[k].position();
      set_point.qd[k] += offset_[k].velocity();
      if (!offset_[k].moving()) phase_[k] = Phase::kFree;
    }
    q_[k] = set_point.q[k];
    qd_[k] = set_point.qd[k];
  }
}

}  // namespace twinbus::control
