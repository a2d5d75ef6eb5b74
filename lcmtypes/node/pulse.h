// The pulse of a process that answers ticks: how many, how fast, how long each took; fills its
// heartbeat.

#pragma once

#include <unistd.h>

#include <cstdint>

#include "common/process/process.h"
#include "common/time/latency_histogram.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

class Pulse {
 public:
  static constexpr std::int64_t kEvery = 100'000'000;   // from heartbeat to heartbeat [ns]
  static constexpr std::int64_t kWindow = 500'000'000;  // over which the rate is measured [ns]

  Pulse(ProcessKind kind, std::int64_t id, RealTime real_time = RealTime::kNone) noexcept {
    beat_.process_id = id;
    beat_.kind = kind;
    beat_.pid = static_cast<std::int32_t>(::getpid());
    beat_.realtime = static_cast<std::int8_t>(real_time);
  }

  // A tick is done, for which so long was computed.
  void tick(std::int64_t now_ns, std::int64_t computed_ns) noexcept {
    compute_.add(computed_ns);
    last_tick_ns_ = now_ns;
    ++ticks_;
    ++window_ticks_;
  }

  // From the question (STATE heard or sent) to its answer.
  void answered(std::int64_t age_ns) noexcept { age_.add(age_ns); }

  std::int64_t ticks() const noexcept { return ticks_; }
  bool due(std::int64_t now_ns) const noexcept { return now_ns - beat_ns_ >= kEvery; }

  // The heartbeat of now; what only the process knows (messages, misses, allocations) is still to
  // be filled in.
  Heartbeat& beat(std::int64_t now_ns) noexcept {
    beat_ns_ = now_ns;
    beat_.utime = wall_us();
    beat_.ticks = ticks_;
    beat_.age_us = static_cast<float>(1e-3 * age_.median_ns());
    beat_.age_p99_us = static_cast<float>(1e-3 * age_.p99_ns());
    beat_.tick_median_us = static_cast<float>(1e-3 * compute_.median_ns());
    beat_.tick_p99_us = static_cast<float>(1e-3 * compute_.p99_ns());
    beat_.tick_max_us = static_cast<float>(1e-3 * static_cast<double>(compute_.max_ns()));
    if (window_ns_ == 0) window_ns_ = now_ns;
    if (now_ns - window_ns_ >= kWindow) {
      beat_.rate = static_cast<float>(static_cast<double>(window_ticks_) /
                                      (1e-9 * static_cast<double>(now_ns - window_ns_)));
      window_ns_ = now_ns;
      window_ticks_ = 0;
    }
    const bool running = ticks_ > 0 && now_ns - last_tick_ns_ < kWindow;
    beat_.state = running ? std::int8_t{2} : std::int8_t{1};
    return beat_;
  }

 private:
  Heartbeat beat_;
  RateStats compute_, age_;
  std::int64_t ticks_ = 0, window_ticks_ = 0;
  std::int64_t last_tick_ns_ = 0, beat_ns_ = 0, window_ns_ = 0;
};

}  // namespace twinbus::lcmtypes
