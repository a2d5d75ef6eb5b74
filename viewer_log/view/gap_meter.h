// The difference between the active source and one that shadows it, tick by tick: the paper's Figs. 12 and 13, live.

#pragma once

#include <array>

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline viewer_log {

// Other minus active; two states of one tick.
Gap gap_between(const RobotState& active, const RobotState& other) noexcept;

class GapMeter {
 public:
  void on_active(const RobotState& state) noexcept;
  // A source on a channel of its own; only one in standby is compared.
  void on_other(const RobotState& state) noexcept;
  // The newest difference of any standby that has not been taken; false when there is none.
  bool take(Gap& gap) noexcept;

 private:
  static constexpr std::size_t kKept = 64;  // ticks: how far one may be behind the other

  static std::size_t slot_of(const RobotState& state) noexcept { return static_cast<std::size_t>(state.tick) % kKept; }
  void compare(const RobotState& active, const RobotState& other) noexcept;

  // A standby that has heard tick n numbers its next state n + 1 and may send it first, so both are kept.
  std::array<RobotState, kKept> active_{}, others_{};
  Gap gap_;
  bool fresh_ = false;
};

}  // namespace twinbus::viewer_log
