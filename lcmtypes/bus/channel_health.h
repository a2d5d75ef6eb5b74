// How one channel does as one process hears it: gaps, repetitions, age and jitter.

#pragma once

#include <cmath>
#include <cstdint>

#include "lcmtypes/bus/missing_messages.h"

namespace twinbus::inline lcmtypes {

struct BusCounters {
  std::int64_t received = 0;  // admitted messages
  std::int64_t rejected = 0;  // wrong size, type or numbers, or not admitted
  std::int64_t lost = 0;      // gaps in ticks and sequences
  std::int64_t repeated = 0;  // the same tick or sequence again
  std::int64_t sent = 0;
  std::int64_t send_failures = 0;  // no route, no room, or a number that is not fit to send
};

class ChannelHealth {
 public:
  BusCounters counters;

  // A message was admitted.
  void arrived(std::int64_t now_ns) noexcept {
    if (last_ns_ != 0) {
      const auto interval = static_cast<double>(now_ns - last_ns_);
      if (!(mean_ns_ > 0.0)) mean_ns_ = interval;
      jitter_ns_ += kShare * (std::abs(interval - mean_ns_) - jitter_ns_);
      mean_ns_ += kShare * (interval - mean_ns_);
    }
    last_ns_ = now_ns;
  }

  // Its sender and what it counts up; for channels whose handler judges for itself.
  void follow(std::int64_t sender, std::int64_t count) noexcept {
    const std::int64_t step = count - count_;
    if (known_ && sender == sender_) {
      if (step == 0) ++counters.repeated;
      counters.lost += missing_.after(step);
    }
    if (!known_ || sender != sender_ || step > 0) count_ = count;
    sender_ = sender;
    known_ = true;
  }

  // [ns] since the newest; -1: nothing was heard.
  std::int64_t age_ns(std::int64_t now_ns) const noexcept {
    return last_ns_ == 0 ? -1 : now_ns - last_ns_;
  }
  double jitter_ns() const noexcept { return jitter_ns_; }

 private:
  static constexpr double kShare = 1.0 / 64.0;  // of the newest interval in the mean

  std::int64_t last_ns_ = 0, sender_ = 0, count_ = 0;
  MissingMessages missing_;
  double mean_ns_ = 0.0, jitter_ns_ = 0.0;
  bool known_ = false;
};

}  // namespace twinbus::lcmtypes
