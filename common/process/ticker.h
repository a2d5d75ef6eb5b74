// Instants one period apart on the steady clock.

#pragma once

#include <cstdint>

#include "common/process/process.h"

namespace twinbus::inline common {

class Ticker {
 public:
  // more than `late` periods behind, as after a machine was suspended, it begins anew.
  explicit Ticker(std::int64_t period_ns, std::int64_t late = 10) noexcept : period_(period_ns), late_(late * period_ns) {}

  // Until the next one.
  void wait() noexcept {
    due_ += period_;
    if (const std::int64_t now = monotonic_ns(); now - due_ > late_) due_ = now;
    sleep_until_ns(due_);
  }

 private:
  std::int64_t period_, late_;
  std::int64_t due_ = monotonic_ns();
};

}  // namespace twinbus::common
