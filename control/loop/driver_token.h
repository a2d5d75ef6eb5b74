// Who drives: of several gamepads the first that holds its dead-man button, until it lets go.
//
// Whoever held the button while another drove has to press it anew: the robot is handed over by two deliberate acts.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

class DriverToken {
 public:
  // Does this pad's message count?  Real-time safe.
  bool admits(const Gamepad& pad, std::int64_t now_ns) noexcept {
    const bool holds = pad.connected && pad.deadman;
    const bool free = driver_ == 0 || now_ns - heard_ns_ > kSilence;
    if (pad.sender_id != driver_ && !free) {
      if (holds) remember(pad.sender_id);
      return false;
    }
    if (!holds) {
      forget(pad.sender_id);
      if (pad.sender_id == driver_) driver_ = 0;
      return true;  // hands off: zeros for everybody
    }
    if (pad.sender_id != driver_ && waits(pad.sender_id)) return false;
    driver_ = pad.sender_id;
    heard_ns_ = now_ns;
    return true;
  }
  std::int64_t driver() const noexcept { return driver_; }

 private:
  static constexpr std::int64_t kSilence = 250'000'000;  // then a driver has let go [ns]

  bool waits(std::int64_t id) const noexcept {
    for (const std::int64_t other : pressing_) {
      if (other == id) return true;
    }
    return false;
  }
  void remember(std::int64_t id) noexcept {
    if (waits(id)) return;
    pressing_[next_] = id;
    next_ = (next_ + 1) % pressing_.size();
  }
  void forget(std::int64_t id) noexcept {
    for (std::int64_t& other : pressing_) {
      if (other == id) other = 0;
    }
  }

  std::int64_t driver_ = 0, heard_ns_ = 0;
  std::array<std::int64_t, 8> pressing_{};  // held the button while another drove
  std::size_t next_ = 0;
};

}  // namespace twinbus::control
