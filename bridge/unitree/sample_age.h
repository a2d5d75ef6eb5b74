// How old a sample of one writer is, though its machine's clock is not ours.
//
// The least difference between arrival and time stamp over the last seconds is taken for a sample without delay:
//
//     age = (arrival - stamp) - min over the last two windows of (arrival - stamp)

#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace twinbus::inline bridge {

class SampleAge {
 public:
  static constexpr std::int64_t kWindow = 5'000'000'000;  // [ns]

  // stamp_ns: the writer's clock, arrival_ns: ours; any origin.  Age [ns], 0 or more.
  std::int64_t of(std::int64_t stamp_ns, std::int64_t arrival_ns) noexcept {
    // Whatever the other clock says: unsigned, so that nothing overflows.
    const std::int64_t difference = minus(arrival_ns, stamp_ns);
    if (arrival_ns - window_ns_ >= kWindow || arrival_ns < window_ns_) {
      before_ = arrival_ns - window_ns_ < 2 * kWindow && arrival_ns >= window_ns_ ? least_ : kNothing;
      least_ = kNothing;
      window_ns_ = arrival_ns;
    }
    least_ = std::min(least_, difference);
    const std::int64_t base = std::min(least_, before_);
    return minus(difference, base);
  }

 private:
  static std::int64_t minus(std::int64_t a, std::int64_t b) noexcept {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
  }
  static constexpr std::int64_t kNothing = std::numeric_limits<std::int64_t>::max();
  std::int64_t window_ns_ = std::numeric_limits<std::int64_t>::min() / 2;
  std::int64_t least_ = kNothing, before_ = kNothing;
};

}  // namespace twinbus::bridge
