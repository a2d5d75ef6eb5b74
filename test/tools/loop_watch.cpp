// How long each STATE waited for its COMMAND, as the kernel saw both datagrams: a watcher that sleeps measures the same.
//
//   loop_watch [--url URL] [--prefix P] [--allow A]
//
// Prints "ready", then a line "NS TICK US" per answered tick: steady clock, tick, microseconds from STATE to COMMAND; and
// a line "NS TICK -1" for a tick that had no answer before the next one.  A signal ends it.

#include <cstdio>
#include <cstring>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>

#include "lcmtypes/bus/bus.h"
#include "common/process/process.h"
#include "viewer_log/log/log_event.h"
#include "test/tools/bus_options.h"

using namespace twinbus;

namespace {

constexpr std::size_t kTick = 8;                   // where it lies in both messages [bytes]
constexpr std::int64_t kFlushEvery = 500'000'000;  // [ns]

class LoopWatch {
 public:
  void operator()(const char* channel, std::span<const std::uint8_t> bytes, std::int64_t utime) {
    if (bytes.size() < kTick + 8) return;
    const std::int64_t tick = read_i64(bytes.data() + kTick);
    if (std::strcmp(channel, "STATE") == 0) {
      if (waiting_) print(tick_, -1);
      waiting_ = true;
      tick_ = tick;
      state_utime_ = utime;
    } else if (waiting_ && tick == tick_) {
      waiting_ = false;
      print(tick, utime - state_utime_);
    }
  }

 private:
  static void print(std::int64_t tick, std::int64_t us) {
    std::printf("%lld %lld %lld\n", static_cast<long long>(monotonic_ns()),
                static_cast<long long>(tick), static_cast<long long>(us));
  }

  bool waiting_ = false;
  std::int64_t tick_ = 0, state_utime_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
  BusOptions options;
  for (int i = 1; i < argc; ++i) {
    if (!take_bus_option(argc, argv, i, options))
      throw std::invalid_argument(std::string(argv[i]) + ": unknown");
  }
  catch_quit_signals();
  go_ahead_of_ordinary_programs();
  Bus bus(options);
  LoopWatch watch;
  bus.listen_raw("(STATE|COMMAND)", watch, 1 << 14);
  std::printf("ready\n");
  std::int64_t flushed = 0;
  while (!quit_requested() && bus.receive(0.1) >= 0) {
    if (monotonic_ns() - flushed < kFlushEvery) continue;
    flushed = monotonic_ns();
    if (std::fflush(stdout) != 0) break;
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "loop_watch: %s\n", error.what());
  return dynamic_cast<const std::invalid_argument*>(&error) != nullptr ? 2 : 1;
}
