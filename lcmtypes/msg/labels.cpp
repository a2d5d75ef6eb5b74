#include "lcmtypes/msg/labels.h"

#include "lcmtypes/msg/fallen.h"

namespace twinbus {

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
  if (reason == kStopFallen) return "a fall";
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
