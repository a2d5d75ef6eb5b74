// How many messages of a counted stream are missing.  Who sends every tenth number, as a controller of 50 Hz answers the ticks
// of 500 Hz, has lost nothing, and neither has one whose turns are early or late now and then: the middle of a sender's last
// steps is its rate.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace twinbus::inline lcmtypes {

class MissingMessages {
 public:
  // step: from the last number of this sender to this one; 0 or less: repeated or late, nothing is missing.
  std::int64_t after(std::int64_t step) noexcept {
    if (step <= 0) return 0;
    steps_[next_] = step;
    next_ = (next_ + 1) % steps_.size();
    seen_ = std::min(seen_ + 1, steps_.size());
    if (seen_ < kFew) return step - 1;
    std::array<std::int64_t, kLast> sorted = steps_;
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(seen_), middle = sorted.begin() + (end - sorted.begin()) / 2;
    std::nth_element(sorted.begin(), middle, end);
    const std::int64_t whole = step / *middle, rest = step % *middle;  // rounded to the nearest, without overflow
    return std::max<std::int64_t>(0, whole + (rest >= *middle - *middle / 2 ? 1 : 0) - 1);
  }

 private:
  static constexpr std::size_t kLast = 15, kFew = 3;

  std::array<std::int64_t, kLast> steps_{};
  std::size_t next_ = 0, seen_ = 0;
};

}  // namespace twinbus::lcmtypes
