// Where one motion of `reach` stands, from what the controller says of it.
//
// Knows neither bus nor clock: `twinbus reach` feeds it from the one, `bench reach` from simulated time.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline launcher {

// A balancing body gives way to a moving arm: what is then left of the way is planned again.
inline constexpr int kReachCorrections = 3;        // plans after the first
inline constexpr double kReachNearEnough = 0.002;  // needs no correction [m]
inline constexpr double kReachFar = 0.010;         // is not there [m]
inline constexpr double kReachSettle = 0.4;        // until the servos have come to rest [s]

class ReachProgress {
 public:
  // duration: of the path as planned [s].
  ReachProgress(std::int64_t path_id, double duration) : path_id_(path_id), duration_(duration) {}

  // now: seconds since the whole path was sent.  status: the newest, null when no controller was ever
  // heard.  False when it has come to an end.
  bool goes_on(double now, StopKind stop, const ControllerStatus* status) noexcept;

  bool moving() const noexcept { return moving_; }
  bool arrived() const noexcept { return arrived_; }
  const char* failure() const noexcept { return failure_; }  // null: none
  // The arm would go on by itself when what holds it goes away; who gives up must cancel.
  bool must_cancel() const noexcept { return must_cancel_; }
  double share(double now) const noexcept;  // of the way, by time alone

 private:
  bool ends(const char* failure) noexcept;

  std::int64_t path_id_;
  double duration_;
  double held_since_ = -1.0;  // by the guard
  bool moving_ = false, arrived_ = false, must_cancel_ = false;
  const char* failure_ = nullptr;
};

}  // namespace twinbus::launcher
