#include "viewer_log/view/stack_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "common/math/pose_math.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr std::size_t kMaxSenders =
    64;  // of heartbeats, source status and events: more are strangers
constexpr std::size_t kMaxEvents = 60;
constexpr std::int64_t kAgain = 30'000'000;  // the same event within this is counted [us]
constexpr double kSilent = 10.0;      // [s]
constexpr double kTruthFresh = 0.25;  // [s]
constexpr double kStateFresh = 0.25;  // [s]

Eigen::Isometry3d truth_base(const SimTruth& truth) {
  const auto& w = truth.base_attitude;
  Eigen::Quaterniond attitude(w[0], w[1], w[2], w[3]);
  if (!(attitude.norm() > 0.5)) attitude.setIdentity();
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.linear() = attitude.normalized().toRotationMatrix();
  base.translation() =
      Eigen::Vector3d(truth.base_position[0], truth.base_position[1], truth.base_position[2]);
  return base;
}

template <class T, class Same>
void keep(std::vector<Heard<T>>& list, const T& value, std::int64_t now_ns, Same same) {
  for (Heard<T>& slot : list) {
    if (same(slot.value)) {
      slot = {value, now_ns};
      return;
    }
  }
  if (list.size() < kMaxSenders) list.push_back({value, now_ns});
}

// A zero-terminated text that may not be terminated.
template <std::size_t N>
std::string text_of(const std::array<char, N>& text) {
  return std::string(text.data(), strnlen(text.data(), N));
}

}  // namespace

StackView::StackView(const Model& model) : model_(&model), estimator_(model), margins_(model) {}

void StackView::on_state(const RobotState& state, std::int64_t now_ns) {
  if (state.joint_count != model_->bus_count()) return;
  if (state.run_id != state_.value.run_id) ++anchors_;
  if (!state_.fresh(now_ns, kStateFresh)) state_since_ns_ = now_ns;
  state_ = {state, now_ns};
  estimator_.update(state);
}

void StackView::on_standby_state(const RobotState& state, std::int64_t now_ns) {
  if (state.joint_count != model_->bus_count()) return;
  standby_ = {state, now_ns};
  if (!state_.fresh(now_ns, kStateFresh)) estimator_.update(state);
}

void StackView::on_command(const JointCommand& command, std::int64_t now_ns) {
  if (command.joint_count == model_->bus_count()) command_ = {command, now_ns};
}

void StackView::on_controller_status(const ControllerStatus& status, std::int64_t now_ns) {
  controller_ = {status, now_ns};
}

void StackView::on_truth(const SimTruth& truth, std::int64_t now_ns) {
  // A standby simulator publishes TRUTH too; the active one's is not to be hidden by it.
  if (truth.run_id != state_.value.run_id && truth_applies(now_ns)) return;
  truth_ = {truth, now_ns};
  if (truth.run_id == state_.value.run_id && truth.run_id != anchored_run_) anchor_truth();
}

// The simulated robot is drawn where the estimate is now: a plane motion, because height and tilt
// are true in both.
void StackView::anchor_truth() {
  const Eigen::Isometry3d sim = truth_base(truth_.value);
  const Eigen::Isometry3d& estimate = estimator_.configuration().base;
  const Eigen::AngleAxisd turn(yaw_of(estimate.linear()) - yaw_of(sim.linear()), Eigen::Vector3d::UnitZ());
  world_from_sim_ = Eigen::Isometry3d::Identity();
  world_from_sim_.linear() = turn.toRotationMatrix();
  Eigen::Vector3d shift = estimate.translation() - world_from_sim_.linear() * sim.translation();
  shift.z() = 0.0;
  world_from_sim_.translation() = shift;
  anchored_run_ = truth_.value.run_id;
  ++anchors_;
}

void StackView::on_guard(const GuardReport& report, std::int64_t now_ns) {
  guard_ = {report, now_ns};
}

void StackView::on_source_status(const SourceStatus& status, std::int64_t now_ns) {
  keep(sources_, status, now_ns,
       [&](const SourceStatus& other) { return other.run_id == status.run_id; });
}

void StackView::on_heartbeat(const Heartbeat& heartbeat, std::int64_t now_ns) {
  keep(processes_, heartbeat, now_ns,
       [&](const Heartbeat& other) { return other.process_id == heartbeat.process_id; });
}

void StackView::on_event(const Event& event) {
  const auto known =
      std::find_if(event_sequences_.begin(), event_sequences_.end(),
                   [&](const auto& entry) { return entry.first == event.sender_id; });
  if (known == event_sequences_.end()) {
    if (event_sequences_.size() >= kMaxSenders) event_sequences_.erase(event_sequences_.begin());
    event_sequences_.emplace_back(event.sender_id, event.sequence);
  } else if (event.sequence == known->second) {
    return;  // said again
  } else {
    known->second = event.sequence;
  }
  ShownEvent shown{++events_seen_, event.utime, event.kind, event.severity, text_of(event.text)};
  const auto before = std::find_if(events_.begin(), events_.end(), [&](const ShownEvent& e) {
    return e.kind == shown.kind && e.severity == shown.severity && e.text == shown.text &&
           std::abs(shown.utime - e.utime) < kAgain;
  });
  if (before != events_.end()) {
    shown.count = before->count + 1;
    events_.erase(before);
  }
  events_.push_back(std::move(shown));
  if (events_.size() > kMaxEvents) events_.pop_front();
}

void StackView::on_terrain(const ObstaclesPiece& piece) {
  if (piece.scene_id == state_.value.run_id) terrain_.add(piece);
}

void StackView::on_loose(const ObstaclesPiece& piece, std::int64_t now_ns) {
  if (piece.scene_id != state_.value.run_id) return;
  loose_.add(piece);
  loose_ns_ = now_ns;
}

void StackView::on_footsteps(const ObstaclesPiece& piece, std::int64_t now_ns) {
  if (piece.scene_id == state_.value.run_id) footsteps_ = {piece, now_ns};
}

bool StackView::loose_applies(std::int64_t now_ns) const {
  return loose_ns_ != 0 && 1e-9 * static_cast<double>(now_ns - loose_ns_) < kTruthFresh &&
         loose_.scene_id() == state_.value.run_id;
}

bool StackView::footsteps_apply(std::int64_t now_ns) const {
  return footsteps_.fresh(now_ns, kTruthFresh) && footsteps_.value.count > 0 &&
         footsteps_.value.scene_id == state_.value.run_id;
}

void StackView::on_totals(std::int64_t states, std::int64_t commands, std::int64_t guards,
                          std::int64_t now_ns, Receiver receiver) {
  const RobotState& state = state_.value;
  const BusTotals totals{.states = states, .commands = commands, .guards = guards, .run_id = state.run_id,
                         .tick = state.tick, .time_ns = state.time_ns, .state_at_ns = state_.at_ns};
  rates_.update(totals, now_ns, receiver);
}

bool StackView::truth_applies(std::int64_t now_ns) const {
  return truth_.fresh(now_ns, kTruthFresh) && truth_.value.run_id == state_.value.run_id;
}

bool StackView::command_applies(std::int64_t now_ns) const {
  return command_.fresh(now_ns, kStateFresh) && command_.value.run_id == shown(now_ns).run_id;
}

bool StackView::standby_applies(std::int64_t now_ns) const {
  return standby_.fresh(now_ns, kStateFresh) && standby_.value.run_id != shown(now_ns).run_id;
}

const RobotState& StackView::shown(std::int64_t now_ns) const {
  if (!state_.fresh(now_ns, kStateFresh) && standby_.at_ns > state_.at_ns) return standby_.value;
  return state_.value;
}

Eigen::Isometry3d StackView::base(std::int64_t now_ns) const {
  if (truth_applies(now_ns) && anchored_run_ == truth_.value.run_id) {
    return world_from_sim_ * truth_base(truth_.value);
  }
  return estimator_.configuration().base;
}

Eigen::Isometry3d StackView::drawn_from_estimated(std::int64_t now_ns) const {
  return base(now_ns) * estimator_.configuration().base.inverse();
}

void StackView::forget_silent(std::int64_t now_ns) {
  const auto silent = [&](const auto& heard) { return !heard.fresh(now_ns, kSilent); };
  std::erase_if(sources_, silent);
  std::erase_if(processes_, silent);
}

}  // namespace twinbus::viewer_log
