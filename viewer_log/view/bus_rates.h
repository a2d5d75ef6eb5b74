// How often STATE, COMMAND and GUARD come and how fast the robot's time goes, as seen by a process that may be late itself.
//
// A process of low priority on a busy machine reads late and in bursts, and what finds no room in its socket meanwhile is lost to it alone.
// Windows therefore begin and end where it is on time, STATE is measured by its ticks, and of COMMAND and GUARD it has heard the same share
// as of STATE.  Pure: no clock.

#pragma once

#include <algorithm>
#include <cstdint>

namespace twinbus::inline viewer_log {

enum class Receiver : std::int8_t {
  kExact,  // each message is counted at its own time, as in a log
  kPrompt, // everything that came until now has been read, and so it was a moment before
  kLate,
};

// Up to one moment; totals only grow.
struct BusTotals {
  std::int64_t states = 0, commands = 0, guards = 0;
  std::int64_t run_id = 0, tick = 0;            // of the newest STATE
  std::int64_t time_ns = 0, state_at_ns = 0;    // its time, and when it came; 0: never
};

class BusRates {
 public:
  void update(const BusTotals& totals, std::int64_t now_ns, Receiver receiver);

  double state() const { return state_; }      // [Hz]
  double command() const { return command_; }  // [Hz]
  double guard() const { return guard_; }      // [Hz]
  double realtime_factor() const { return factor_; }  // time of the state per time of this machine; 0 unknown

 private:
  static constexpr std::int64_t kWindow = 2'000'000'000;     // shorter, the jitter of the reader is seen [ns]
  static constexpr std::int64_t kPatience = 10'000'000'000;  // a reader that is never on time must do [ns]
  static constexpr std::int64_t kFresh = 250'000'000;        // a state older than this says nothing of now [ns]

  void begin(const BusTotals& totals, std::int64_t now_ns, bool fresh);

  BusTotals from_{};
  std::int64_t from_ns_ = 0, waiting_ns_ = 0;  // waiting for a moment to begin or end at
  bool from_fresh_ = false;
  double state_ = 0.0, command_ = 0.0, guard_ = 0.0, factor_ = 0.0;
};

inline void BusRates::begin(const BusTotals& totals, std::int64_t now_ns, bool fresh) {
  from_ = totals;
  from_ns_ = waiting_ns_ = now_ns;
  from_fresh_ = fresh;
}

inline void BusRates::update(const BusTotals& totals, std::int64_t now_ns, Receiver receiver) {
  if (waiting_ns_ == 0 || now_ns < waiting_ns_) waiting_ns_ = now_ns;
  if (receiver == Receiver::kLate && now_ns - waiting_ns_ < kPatience) return;
  const bool fresh = totals.state_at_ns != 0 && now_ns - totals.state_at_ns < kFresh;
  // Another source counts anew.
  const bool same = totals.run_id == from_.run_id && totals.tick >= from_.tick && totals.time_ns >= from_.time_ns;
  if (from_ns_ == 0 || now_ns < from_ns_ || (!same && receiver != Receiver::kExact)) return begin(totals, now_ns, fresh);
  if (now_ns - from_ns_ < kWindow) return;
  const double elapsed = 1e-9 * static_cast<double>(now_ns - from_ns_);
  const bool known = same && fresh && from_fresh_ && totals.state_at_ns > from_.state_at_ns;
  const double heard = static_cast<double>(totals.states - from_.states);
  const double ticks = static_cast<double>(totals.tick - from_.tick);
  const double missed = receiver != Receiver::kExact && known && heard > 0.0 ? std::max(1.0, ticks / heard) : 1.0;
  state_ = missed * heard / elapsed;
  command_ = missed * static_cast<double>(totals.commands - from_.commands) / elapsed;
  guard_ = missed * static_cast<double>(totals.guards - from_.guards) / elapsed;
  const double advanced = 1e-9 * static_cast<double>(totals.time_ns - from_.time_ns);
  factor_ = known ? 1e9 * advanced / static_cast<double>(totals.state_at_ns - from_.state_at_ns) : 0.0;
  begin(totals, now_ns, fresh);
}

}  // namespace twinbus::viewer_log
