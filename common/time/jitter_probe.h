// A bare timer beside a real-time loop: it sleeps to the loop's ticks at a higher priority and does
// nothing, so where it is late the machine stood still, whatever the loop does.
//
// One thread per CPU, because a virtual machine may stand still on one of them only; each wakes
// four times per tick, because a CPU may stand still in the middle of one.  It takes FIFO priority for
// itself even where the loop has none, so that a loop run without FIFO is judged by the same measure.
// Where the system allows no FIFO priority there is no probe: an ordinary timer proves nothing.

#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace twinbus::inline common {

struct Interval {
  std::int64_t from_ns = 0, to_ns = 0;
};

// How much of from_ns .. to_ns the intervals cover together; sorts them.
std::int64_t covered_ns(std::span<Interval> intervals, std::int64_t from_ns,
                        std::int64_t to_ns) noexcept;

class JitterProbe {
 public:
  // Ticks lie on multiples of period_ns of the steady clock.  Starts its threads at this FIFO
  // priority, where the system allows that.
  JitterProbe(std::int64_t period_ns, int priority);
  ~JitterProbe();
  JitterProbe(const JitterProbe&) = delete;
  JitterProbe& operator=(const JitterProbe&) = delete;

  bool running() const noexcept;

  // For how long between the two instants, as far as the last few times reach, some CPU stood still.
  // Never too much: a standstill shows from the next time the timer is due.
  std::int64_t stood_still_ns(std::int64_t from_ns, std::int64_t to_ns) const noexcept;

  // Ticks for which at least one CPU's timer came more than half a period late.
  std::int64_t missed() const noexcept;

 private:
  struct Shared;
  std::unique_ptr<Shared> shared_;
};

}  // namespace twinbus::common
