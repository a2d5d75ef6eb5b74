#include "viewer_log/view/gap_meter.h"

#include <algorithm>
#include <cmath>

namespace twinbus::inline viewer_log {

namespace {

// Roll and pitch of a w x y z quaternion [rad].
std::array<float, 2> tilt_of(const std::array<float, 4>& a) noexcept {
  const double w = static_cast<double>(a[0]), x = static_cast<double>(a[1]);
  const double y = static_cast<double>(a[2]), z = static_cast<double>(a[3]);
  const double roll = std::atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y));
  const double pitch = std::asin(std::clamp(2.0 * (w * y - z * x), -1.0, 1.0));
  return {static_cast<float>(roll), static_cast<float>(pitch)};
}

}  // namespace

Gap gap_between(const RobotState& active, const RobotState& other) noexcept {
  Gap gap;
  gap.run_id = active.run_id;
  gap.other_run_id = other.run_id;
  gap.tick = active.tick;
  gap.joint_count = active.joint_count;
  for (std::size_t k = 0; k < static_cast<std::size_t>(active.joint_count); ++k) {
    gap.q[k] = static_cast<float>(other.q[k] - active.q[k]);
    gap.tau[k] = other.tau[k] - active.tau[k];
  }
  for (std::size_t foot = 0; foot < kMaxFeet; ++foot) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      gap.foot_force[foot][axis] = other.wrench[foot][axis] - active.wrench[foot][axis];
    }
  }
  const std::array<float, 2> mine = tilt_of(active.attitude), its = tilt_of(other.attitude);
  gap.tilt = {its[0] - mine[0], its[1] - mine[1]};
  return gap;
}

void GapMeter::on_active(const RobotState& state) noexcept {
  active_[slot_of(state)] = state;
  compare(state, others_[slot_of(state)]);
}

void GapMeter::on_other(const RobotState& state) noexcept {
  if (state.role != Role::kStandbyShadow && state.role != Role::kStandbyTrack) return;
  others_[slot_of(state)] = state;
  compare(active_[slot_of(state)], state);
}

void GapMeter::compare(const RobotState& active, const RobotState& other) noexcept {
  if (active.run_id == 0 || other.run_id == 0 || active.tick != other.tick || active.run_id == other.run_id ||
      active.model_hash != other.model_hash || active.joint_count != other.joint_count) {
    return;
  }
  gap_ = gap_between(active, other);
  fresh_ = true;
}

bool GapMeter::take(Gap& gap) noexcept {
  if (!fresh_) return false;
  fresh_ = false;
  gap = gap_;
  return true;
}

}  // namespace twinbus::viewer_log
