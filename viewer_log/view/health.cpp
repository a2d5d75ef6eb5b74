#include "viewer_log/view/health.h"

#include <cmath>
#include <cstdio>

namespace twinbus {

namespace {

constexpr double kStateSilent = 0.25;  // [s]
constexpr double kSenderSilent = 0.5;  // [s]
constexpr double kThinMargin = 0.010;  // ZMP to the edge of the soles [m]
constexpr double kSlow = 0.95;         // real-time factor

std::string one_decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

bool any_source(const StackView& view, std::int64_t now_ns) {
  for (const auto& source : view.sources()) {
    if (source.fresh(now_ns, 1.0)) return true;
  }
  return false;
}

Health without_state(const StackView& view, std::int64_t now_ns) {
  if (any_source(view, now_ns)) {
    return {HealthLevel::kBad, "No source is active: choose one with its Activate button."};
  }
  if (view.state().at_ns == 0) {
    return {HealthLevel::kWaiting, "Nothing on the bus yet: start the stack with ./twinbus up."};
  }
  return {HealthLevel::kBad, "The source has been silent for " +
                                 one_decimal(view.state().age(now_ns)) +
                                 " s: its process has ended or hangs."};
}

// The real-time factor says something only where time is meant to be real.
bool paced(const StackView& view) {
  for (const auto& source : view.sources()) {
    if (source.value.run_id == view.state().value.run_id) return source.value.pace == 1;
  }
  return false;
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
  if (view.truth_applies(now_ns) && view.truth().value.fell) {
    return {HealthLevel::kBad, "The robot has fallen: press STOP, then restart the scene."};
  }
  if (state.role == Role::kStopped || state.stop_kind != StopKind::kNone) {
    std::string why;
    for (const auto& source : view.sources()) {
      if (source.value.run_id == state.run_id && source.value.stop_reason != StopReason::kNone) {
        why = std::string(", by ") + label(source.value.stop_reason);
      }
    }
    return {HealthLevel::kStopped,
            std::string("Stopped (") + label(state.stop_kind) + why + "): press Clear to go on."};
  }
  if (!view.controller().fresh(now_ns, kSenderSilent)) {
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
  if (paced(view) && view.realtime_factor() > 0.0 && view.realtime_factor() < kSlow) {
    return {HealthLevel::kWarning,
            "Slower than real time: factor " + one_decimal(view.realtime_factor()) + "."};
  }
  const ControllerStatus& controller = view.controller().value;
  const char* doing = controller.motion != Motion::kNone ? label(controller.motion) : label(mode);
  return {HealthLevel::kGood, std::string("Running well: ") + doing + "."};
}

const char* label(HealthLevel level) noexcept {
  switch (level) {
    case HealthLevel::kWaiting:
      return "waiting";
    case HealthLevel::kGood:
      return "good";
    case HealthLevel::kWarning:
      return "warning";
    case HealthLevel::kStopped:
      return "stopped";
    case HealthLevel::kBad:
      return "bad";
  }
  return "bad";
}

const char* label(SourceKind kind) noexcept {
  switch (kind) {
    case SourceKind::kNone:
      return "none";
    case SourceKind::kSimulator:
      return "simulator";
    case SourceKind::kBridge:
      return "robot";
    case SourceKind::kReplay:
      return "replay";
  }
  return "unknown";
}

const char* label(Role role) noexcept {
  switch (role) {
    case Role::kNone:
      return "none";
    case Role::kParked:
      return "parked";
    case Role::kActive:
      return "active";
    case Role::kReleasing:
      return "releasing";
    case Role::kStandbyTrack:
      return "track";
    case Role::kStandbyShadow:
      return "shadow";
    case Role::kStopped:
      return "stopped";
  }
  return "unknown";
}

const char* label(StopKind kind) noexcept {
  switch (kind) {
    case StopKind::kNone:
      return "none";
    case StopKind::kBalanced:
      return "balanced";
    case StopKind::kHold:
      return "hold";
    case StopKind::kOff:
      return "off";
  }
  return "unknown";
}

const char* label(StopReason reason) noexcept {
  switch (reason) {
    case StopReason::kNone:
      return "none";
    case StopReason::kOperator:
      return "the operator";
    case StopReason::kGamepad:
      return "the gamepad";
    case StopReason::kViewer:
      return "the viewer";
    case StopReason::kGuard:
      return "the guard";
    case StopReason::kLauncher:
      return "the launcher";
    case StopReason::kController:
      return "the controller";
    case StopReason::kCommandTimeout:
      return "missing commands";
    case StopReason::kDevice:
      return "a device error";
    case StopReason::kSwitch:
      return "a switch";
  }
  return "unknown";
}

const char* label(Mode mode) noexcept {
  switch (mode) {
    case Mode::kNone:
      return "none";
    case Mode::kIdle:
      return "idle";
    case Mode::kHold:
      return "hold";
    case Mode::kPose:
      return "pose";
    case Mode::kBalance:
      return "balance";
    case Mode::kWalk:
      return "walk";
    case Mode::kStop:
      return "stop";
  }
  return "unknown";
}

const char* label(Motion motion) noexcept {
  switch (motion) {
    case Motion::kNone:
      return "none";
    case Motion::kSway:
      return "sway";
    case Motion::kSquat:
      return "squat";
  }
  return "unknown";
}

const char* label(ProcessKind kind) noexcept {
  switch (kind) {
    case ProcessKind::kNone:
      return "unknown";
    case ProcessKind::kSimulator:
      return "simulator";
    case ProcessKind::kBridge:
      return "bridge";
    case ProcessKind::kReplay:
      return "replay";
    case ProcessKind::kController:
      return "controller";
    case ProcessKind::kGuard:
      return "guard";
    case ProcessKind::kPlanner:
      return "planner";
    case ProcessKind::kViewer:
      return "viewer";
    case ProcessKind::kGamepad:
      return "gamepad";
    case ProcessKind::kLog:
      return "log";
    case ProcessKind::kLauncher:
      return "launcher";
    case ProcessKind::kUser:
      return "user";
  }
  return "unknown";
}

const char* label(GuardVerdict verdict) noexcept {
  switch (verdict) {
    case GuardVerdict::kClear:
      return "clear";
    case GuardVerdict::kNear:
      return "near";
    case GuardVerdict::kWillCollide:
      return "will collide";
    case GuardVerdict::kInCollision:
      return "in collision";
  }
  return "unknown";
}

}  // namespace twinbus
