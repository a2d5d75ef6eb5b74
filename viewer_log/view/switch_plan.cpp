#include "viewer_log/view/switch_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace twinbus::inline viewer_log {

namespace {

constexpr double kActiveFresh = 0.1;    // [s]
constexpr double kStandbyWait = 6.0;    // a shadow needs a fresh anchor [s]
constexpr double kPostureWait = 4.0;    // for a shadow to get there [s]
constexpr double kNearFor = 1.0;        // it has faded in and swings along by then [s]
constexpr double kNearPosture = 0.045;  // the source itself refuses 0.05 [rad]

double since(std::int64_t then_ns, std::int64_t now_ns) {
  return 1e-9 * static_cast<double>(now_ns - then_ns);
}

const SourceStatus* status_of(const StackView& view, std::int64_t run_id) {
  for (const Heard<SourceStatus>& source : view.sources()) {
    if (source.value.run_id == run_id) return &source.value;
  }
  return nullptr;
}

bool near_posture(const StackView& view, std::int64_t run_id) {
  const RobotState& standby = view.standby().value;
  const RobotState& active = view.state().value;
  if (standby.run_id != run_id) return false;
  double gap = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(view.model().bus_count()); ++k) {
    gap = std::max(gap, std::abs(standby.q[k] - active.q[k]));
  }
  return gap <= kNearPosture;
}

}  // namespace

void SwitchPlan::start(std::int64_t target_run_id, std::int64_t now_ns) {
  phase_ = Phase::kBegin;
  target_ = target_run_id;
  since_ns_ = now_ns;
}

bool SwitchPlan::next(const StackView& view, std::int64_t now_ns, SourceRequest& request) {
  if (phase_ == Phase::kDone) return false;
  const SourceStatus* target = status_of(view, target_);
  const bool can_be_set = target != nullptr && target->can_be_set;
  const SourceRequest fresh;
  if (phase_ == Phase::kBegin) {
    request = fresh;
    if (!view.state().fresh(now_ns, kActiveFresh)) {
      phase_ = Phase::kDone;
      request.action = SourceAction::kActivate;
      request.policy = SwitchPolicy::kWhenSafe;
      request.run_id = request.target_run_id = target_;
      return true;
    }
    phase_ = Phase::kStandby;
    since_ns_ = now_ns;
    request.action = can_be_set ? SourceAction::kStandbyTrack : SourceAction::kStandbyShadow;
    request.run_id = request.target_run_id = target_;
    return true;
  }
  const bool standby = target != nullptr && (target->role == Role::kStandbyTrack ||
                                             target->role == Role::kStandbyShadow);
  if (phase_ == Phase::kStandby) {
    if (standby) {
      phase_ = Phase::kNear;
      since_ns_ = near_ns_ = now_ns;
    } else if (since(since_ns_, now_ns) > kStandbyWait) {
      ask_takeover(view, request);  // the active source says why it is refused
      return true;
    }
    return false;
  }
  if (!near_posture(view, target_)) near_ns_ = now_ns;
  const double lasting = can_be_set ? 0.0 : kNearFor;
  const bool near = near_ns_ != now_ns && since(near_ns_, now_ns) >= lasting;
  if (!near && since(since_ns_, now_ns) < kPostureWait) return false;
  ask_takeover(view, request);
  return true;
}

void SwitchPlan::ask_takeover(const StackView& view, SourceRequest& request) {
  phase_ = Phase::kDone;
  request = SourceRequest{};
  request.action = SourceAction::kSwitch;
  request.policy = SwitchPolicy::kWhenSafe;
  request.run_id = view.state().value.run_id;
  request.target_run_id = target_;
}

}  // namespace twinbus::viewer_log
