#include "launcher/operate/reach_progress.h"

#include <algorithm>

namespace twinbus::inline launcher {

namespace {

constexpr double kStartTimeout = 2.0;  // from the last piece of the path to the first move [s]
constexpr double kLate = 20.0;         // later than planned, when the guard slows the arm [s]
constexpr double kHeld = 3.0;          // by the guard, without going on [s]
constexpr std::int8_t kFollowing = 1, kDone = 2, kStoppedByGuard = 3;  // arm_state

}  // namespace

bool ReachProgress::ends(const char* failure) noexcept {
  failure_ = failure;
  return false;
}

bool ReachProgress::goes_on(double now, StopKind stop, const ControllerStatus* status) noexcept {
  if (stop != StopKind::kNone)
    return ends("the robot was stopped; ./twinbus clear, then ask again");
  if (!(now < duration_ + kLate)) return ends("the arm did not arrive in time");
  if (status != nullptr) {
    const bool ours = status->arm_path_id == path_id_;
    if (moving_ && status->arm_state == kDone) {
      arrived_ = true;
      return false;
    }
    if (!ours || status->arm_state != kStoppedByGuard) {
      held_since_ = -1.0;  // or let go again: the arm goes on by itself
    } else if (held_since_ < 0.0) {
      held_since_ = now;
    } else if (now - held_since_ > kHeld) {
      must_cancel_ = true;
      return ends("the guard holds the arm before something would touch; the arm stays there");
    }
    if (moving_ && !ours && status->arm_state == kStoppedByGuard)
      return ends("the guard stopped the arm again and again, and the path was given up");
    moving_ = moving_ ||
              (ours && (status->arm_state == kFollowing || status->arm_state == kStoppedByGuard));
  }
  if (!moving_ && now > kStartTimeout) {
    return ends(
        status == nullptr
            ? "no controller is running"
            : "the controller does not follow the path, and says no reason (./twinbus status, ./twinbus mode)");
  }
  return true;
}

double ReachProgress::share(double now) const noexcept {
  return std::min(1.0, now / std::max(0.1, duration_));
}

}  // namespace twinbus::launcher
