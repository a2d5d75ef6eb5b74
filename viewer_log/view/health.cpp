#include "viewer_log/view/health.h"

#include "common/text/formatted.h"
#include "common/text/name_of.h"
#include "lcmtypes/msg/labels.h"
#include "lcmtypes/msg/lies_down.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/pace.h"

namespace twinbus::inline viewer_log {

namespace {

constexpr double kStateSilent = 0.25;  // [s]
constexpr double kSenderSilent = 0.5;  // [s]
constexpr double kSourceSilent = 1.0;  // [s]
constexpr double kThinMargin = 0.010;  // ZMP to the edge of the soles [m]
constexpr double kSlow = 0.95;         // real-time factor

bool any_source(const StackView& view, std::int64_t now_ns) {
  for (const auto& source : view.sources()) {
    if (source.fresh(now_ns, 1.0)) return true;
  }
  return false;
}

// Of the source that is shown; none of these when it is not heard.
Pace pace_of(const StackView& view, std::int64_t now_ns) {
  for (const auto& source : view.sources()) {
    if (source.value.run_id == view.state().value.run_id && source.fresh(now_ns, kSourceSilent))
      return static_cast<Pace>(source.value.pace);
  }
  return Pace{};
}

Health without_state(const StackView& view, std::int64_t now_ns) {
  if (view.state().at_ns != 0 && pace_of(view, now_ns) == Pace::kPaused)
    return {HealthLevel::kWaiting, "The simulated world is paused.",
            "Go on, or one tick at a time."};
  if (any_source(view, now_ns)) {
    return {HealthLevel::kBad, "No source is active: choose one with its Activate button."};
  }
  if (view.state().at_ns == 0) {
    return {HealthLevel::kWaiting, "Nothing on the bus yet: start the stack with ./twinbus up."};
  }
  return {HealthLevel::kBad,
          formatted("The source has been silent for %.1f s: its process has ended or hangs.", view.state().age(now_ns))};
}

// A robot that is simulated.
Health fallen(bool stopped) {
  return {HealthLevel::kBad, std::string("The robot has fallen") + (stopped ? " and is stopped." : "."),
          stopped ? "Start anew sets it on its feet." : "Press STOP, then Start anew.", true};
}

// The real-time factor says something only where time is meant to be real.
bool paced(const StackView& view, std::int64_t now_ns) {
  const Pace pace = pace_of(view, now_ns);
  return pace == Pace::kRealTime || pace == Pace::kPatient;
}

}  // namespace

Health assess(const StackView& view, std::int64_t now_ns) {
  const RobotState& state = view.state().value;
  if (!view.state().fresh(now_ns, kStateSilent)) return without_state(view, now_ns);
  if (state.model_hash != view.model().hash) {
    return {HealthLevel::kBad, "The source runs another robot than this viewer (" +
                                   view.model().name +
                                   "): start the viewer with the same --robot."};
  }
  StopReason reason = StopReason::kNone;
  for (const auto& source : view.sources()) {
    if (source.value.run_id == state.run_id) reason = source.value.stop_reason;
  }
  const bool stopped = state.stop_kind != StopKind::kNone;
  const bool lies = view.model().floating_base && view.estimator().tilt() > kLiesTilt;
  if (((stopped && reason == StopReason::kFallen) || lies) && !view.truth_applies(now_ns)) {
    if (view.stand_in() && state.source == SourceKind::kBridge) return fallen(stopped);
    return {HealthLevel::kBad, std::string("The robot has fallen") + (stopped ? " and is stopped." : "."),
            stopped ? "Put it on its feet, then press Clear." : "Put it on its feet, then ask for balance."};
  }
  if (view.truth_applies(now_ns) && view.truth().value.fell) {
    return fallen(stopped);
  }
  if (state.role == Role::kStopped || state.stop_kind != StopKind::kNone) {
    const std::string why = reason != StopReason::kNone ? std::string(", by ") + label(reason) : "";
    return {HealthLevel::kStopped, std::string("Stopped (") + label(state.stop_kind) + why + ").",
            "Press Clear to go on."};
  }
  if (!view.controller().fresh(now_ns, kSenderSilent)) {
    // At the start of a log, or of a stack.
    if (view.listened(now_ns) < kSenderSilent) return {HealthLevel::kWaiting, "Just begun: no controller is heard yet."};
    return {HealthLevel::kBad, "No controller is heard: the source will stop by itself."};
  }
  if (view.guard().at_ns != 0 && !view.guard().fresh(now_ns, kSenderSilent)) {
    return {HealthLevel::kWarning, "The guard is silent: the arms are held until it is back."};
  }
  if (view.guard().fresh(now_ns, kSenderSilent) &&
      view.guard().value.verdict == GuardVerdict::kInCollision) {
    return {HealthLevel::kBad, "The robot touches itself: see the guard pairs."};
  }
  const Mode mode = view.controller().value.mode;
  if (mode == Mode::kBalance && !(view.controller().value.zmp_margin >= float(kThinMargin))) {
    return {HealthLevel::kWarning, "Balance is near its edge: the ZMP is less than 10 mm inside."};
  }
  if (view.guard().fresh(now_ns, kSenderSilent) && view.guard().value.hold_mask != 0) {
    return {HealthLevel::kWarning, "The guard holds joints: a self-collision was ahead."};
  }
  if (paced(view, now_ns) && view.rates().realtime_factor() > 0.0 && view.rates().realtime_factor() < kSlow) {
    return {HealthLevel::kWarning,
            formatted("Slower than real time: factor %.2f", view.rates().realtime_factor()) +
                (pace_of(view, now_ns) == Pace::kPatient ? ": the simulated world waits for late commands." : ".")};
  }
  if (view.truth_applies(now_ns) && view.truth().value.doubted_steps > 0) {
    const SimTruth& truth = view.truth().value;
    return {HealthLevel::kWarning, formatted("The simulator doubts %d of its steps since %.2f s, the last for ", truth.doubted_steps, truth.doubted_since) +
                                       label(truth.last_doubt) + ".",
            "A smaller step mends it: ./twinbus tune."};
  }
  if (pace_of(view, now_ns) == Pace::kSlowed) {
    return {HealthLevel::kGood, formatted("Slowed down on purpose: %.2f times real time.", view.rates().realtime_factor())};
  }
  const ControllerStatus& controller = view.controller().value;
  const char* doing = controller.motion != Motion::kNone ? label(controller.motion) : label(mode);
  return {HealthLevel::kGood, std::string("Running well: ") + doing + "."};
}

const char* label(HealthLevel level) noexcept {
  static constexpr const char* kLabels[] = {"waiting", "good", "warning", "stopped", "bad"};
  return name_of(level, kLabels, "bad");
}

}  // namespace twinbus::viewer_log
