// Rate, age and gaps of one stream of ticks, as its receiver sees them.

#pragma once

#include <cstdint>

#include "lcmtypes/bus/missing_messages.h"

namespace twinbus::inline launcher {

class Meter {
 public:
  // A message of this tick came.  Ticks that do not count up are counted as repeated and change nothing else.
  void add(std::int64_t tick, std::int64_t now_ns) noexcept {
    if (received_ > 0 && tick <= last_tick_) {
      ++repeated_;
      last_ns_ = now_ns;
      return;
    }
    if (received_ == 0) {
      first_ns_ = window_ns_ = now_ns;
    } else {
      lost_ += missing_.after(tick - last_tick_);
    }
    ++received_;
    ++in_window_;
    last_tick_ = tick;
    last_ns_ = now_ns;
    if (now_ns - window_ns_ >= kWindow_ns) {
      rate_ = 1e9 * static_cast<double>(in_window_) / static_cast<double>(now_ns - window_ns_);
      in_window_ = 0;
      window_ns_ = now_ns;
    }
  }
  // A message without a tick number.
  void add(std::int64_t now_ns) noexcept { add(last_tick_ + 1, now_ns); }

  void restart() noexcept { *this = Meter(); }

  std::int64_t received() const noexcept { return received_; }
  std::int64_t lost() const noexcept { return lost_; }
  std::int64_t repeated() const noexcept { return repeated_; }
  std::int64_t last_tick() const noexcept { return last_tick_; }
  std::int64_t last_ns() const noexcept { return last_ns_; }
  // [s]; infinite before the first message.
  double age(std::int64_t now_ns) const noexcept {
    return received_ == 0 ? kNever : 1e-9 * static_cast<double>(now_ns - last_ns_);
  }
  // Of the last whole window; zero once nothing has come for two windows [Hz].
  double rate(std::int64_t now_ns) const noexcept {
    return received_ == 0 || now_ns - last_ns_ > 2 * kWindow_ns ? 0.0 : rate_;
  }
  // Over everything received since the first message [Hz].
  double mean_rate() const noexcept {
    const double span = 1e-9 * static_cast<double>(last_ns_ - first_ns_);
    return received_ < 2 || !(span > 0.0) ? 0.0 : static_cast<double>(received_ - 1) / span;
  }

 private:
  static constexpr std::int64_t kWindow_ns = 500'000'000;
  static constexpr double kNever = 1e9;

  std::int64_t received_ = 0, lost_ = 0, repeated_ = 0;
  std::int64_t last_tick_ = 0;
  std::int64_t first_ns_ = 0, last_ns_ = 0;
  std::int64_t window_ns_ = 0, in_window_ = 0;
  MissingMessages missing_;
  double rate_ = 0.0;
};

}  // namespace twinbus::launcher
