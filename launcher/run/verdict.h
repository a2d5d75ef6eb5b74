// Judges a run of the stack by what was heard: rates, missed ticks, falls; and writes it down.

#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "launcher/bus/stack_monitor.h"
#include "sim/world/step_trust.h"

namespace twinbus::inline launcher {

// What the run was asked for.
struct RunRequest {
  std::string scene;
  std::string robot;
  std::string engine;
  std::string contact = "spring_damper";
  std::uint64_t seed = 0;
  double step_s = 0.0;    // physics step
  double period = 0.002;  // [s]
  double rate = 1.0;      // times real time
  bool lockstep = false;
  bool patient = false;   // the simulated world waits for late commands, and is slower than real time meanwhile
  double duration = 0.0;  // asked for [s]; 0: until Ctrl-C
  bool whole_log = false;  // a log of some size was asked for: one that is cut fails the run
};

// Ticks that sources and controllers have missed since they started, and how many of those would have been in time had
// the machine not stood still.
struct MissedCounts {
  std::int64_t source = 0;
  std::int64_t source_stalled = 0;
  std::int64_t controller = 0;
  std::int64_t controller_stalled = 0;
  std::int64_t timer = -1;  // ticks that a bare timer of higher priority missed; -1: there was none
};

struct RunVerdict {
  std::int64_t ticks = 0;
  std::int64_t missed = 0;   // the worse of what source and controller counted
  std::int64_t stalled = 0;  // of these, by the machine
  std::int64_t source_missed = 0;
  std::int64_t controller_missed = 0;
  std::int64_t timer_missed = -1;
  double missed_allowed = 0.0;  // share, of what is not the machine's
  double answer_median_us =
      0.0;  // from STATE sent to COMMAND obeyed, as the source sees it; 0 unknown
  double answer_p99_us = 0.0;
  double state_rate = 0.0;  // [Hz]
  double command_rate = 0.0;
  double rate_wanted = 0.0;
  double realtime_factor = 0.0;  // of rate_wanted
  bool fifo = false;  // source and controller both
  bool fell = false;
  bool passed = false;
  std::vector<std::string> failures;  // one sentence each
  std::string doubts{};               // what the simulator says of its own steps: doubts_line()
  std::int64_t doubted_steps = 0;
  std::vector<std::string> left_out;  // what was asked and could not be judged: the run is only a part of its scene
  std::int64_t not_recorded = 0;      // messages that recorders lost: a disk that is full, a socket that was
  bool by_operator = false;           // ended by Ctrl-C
  double measured = 0.0;              // for so long [s]; of by_operator alone
};

MissedCounts missed_so_far(const StackMonitor& seen, std::int64_t now_ns);
// What source and controller, ours or a user's, both have: 0 nothing, 1 FIFO priority, 2 and locked memory.
int real_time_of(const StackMonitor& seen, std::int64_t now_ns);
std::string real_time_text(int real_time, bool patient = false);

RunVerdict judge(const StackMonitor& seen, const RunRequest& request, const MissedCounts& start,
                 std::int64_t now_ns);

// The run was ended by Ctrl-C after so long [s]; less than was asked for fails.
void end_by_operator(RunVerdict& verdict, const RunRequest& request, double measured);

// Which physics steps are not to be trusted, a line for people; empty: all are.
std::string doubts_line(const TrustCounts& trust);
// The last line of a run that its criteria passed: one verdict, though steps are doubted.
std::string passed_line(std::int64_t doubted_steps, bool log_cut = false);

// The same of a report: doubted_steps, with those of each kind.
nlohmann::ordered_json doubts_json(const TrustCounts& trust);

// Lines for people.
std::vector<std::string> verdict_lines(const RunVerdict& verdict, const RunRequest& request);

// JSON with the keys that `twinbus run --report` writes, as far as the bus shows them, and the rates.
std::string report_json(const RunVerdict& verdict, const RunRequest& request, const StackMonitor& seen,
                        double wall_s, const std::string& state_hash);

}  // namespace twinbus::launcher
