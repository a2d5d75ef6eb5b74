// Missed ticks of a real-time loop, and how many of them would have been in time had the machine
// not stood still.

#pragma once

#include <cstdint>
#include <optional>

#include "common/time/jitter_probe.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

class MissedTicks {
 public:
  // Starts the probe beside a loop that follows the clock, at a FIFO priority above everything of
  // the stack.
  void watch(std::int64_t period_ns, int priority = 80) { probe_.emplace(period_ns, priority); }

  // Ticks were missed between two instants of the steady clock, by being late_ns too late: is it the
  // machine that stood still for so long?
  void add(std::int64_t ticks, std::int64_t late_ns, std::int64_t from_ns,
           std::int64_t to_ns) noexcept {
    missed_ += ticks;
    if (probe_.has_value() && probe_->stood_still_ns(from_ns, to_ns) >= late_ns) {
      stalled_ += ticks;
    }
  }

  std::int64_t count() const noexcept { return missed_; }

  void tell(Heartbeat& beat) const noexcept {
    beat.ticks_missed = missed_;
    beat.ticks_stalled = stalled_;
    beat.timer_missed = probe_.has_value() && probe_->running() ? probe_->missed() : -1;
  }

 private:
  std::optional<JitterProbe> probe_;
  std::int64_t missed_ = 0;
  std::int64_t stalled_ = 0;
};

}  // namespace twinbus::lcmtypes
