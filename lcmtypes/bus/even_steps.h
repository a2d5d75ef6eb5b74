// How many messages of a counted stream are missing.  Who sends every tenth number, evenly, as a controller of 50 Hz answers
// the ticks of 500 Hz, has lost nothing.

#pragma once

#include <cstdint>

namespace twinbus {

class EvenSteps {
 public:
  // step: from the last number of this sender to this one; 0 or less: repeated or late, nothing is missing.
  std::int64_t missing(std::int64_t step) noexcept {
    if (step <= 0) return 0;
    alike_ = step == step_ ? alike_ + (alike_ < kEven) : 0;
    step_ = step;
    return alike_ < kEven ? step - 1 : 0;
  }

 private:
  static constexpr int kEven = 3;  // equal steps after the first are a rate of their own

  std::int64_t step_ = 0;
  int alike_ = 0;
};

}  // namespace twinbus
