// Judges a run of the stack by what was heard: rates, missed ticks, falls; and writes it down.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "launcher/lookout.h"

namespace twinbus {

// What the run was asked for.
struct RunRequest {
  std::string scene;
  std::string robot;
  std::string engine;
  std::uint64_t seed = 0;
  double step_s = 0.0;      // physics step
  double period = 0.002;    // [s]
  double rate = 1.0;        // times real time
  bool lockstep = false;
  double duration = 0.0;    // asked for [s]; 0: until Ctrl-C
};

// Counters of processes when the measured part began; they go on counting from their own start.
struct CountersAtStart {
  std::int64_t source_missed = 0;
  std::int64_t controller_missed = 0;
};

struct RunVerdict {
  std::int64_t ticks = 0;
  std::int64_t missed = 0;          // the worse of what source and controller counted
  std::int64_t source_missed = 0;
  std::int64_t controller_missed = 0;
  double missed_allowed = 0.0;      // share
  double state_rate = 0.0;          // [Hz]
  double command_rate = 0.0;
  double rate_wanted = 0.0;
  bool fifo = false;                // source and controller both
  bool fell = false;
  bool passed = false;
  std::vector<std::string> failures;  // one sentence each
};

std::int64_t controller_missed_ticks(const Lookout& seen, std::int64_t now_ns);
// Source and controller both run at FIFO priority.
bool runs_at_fifo(const Lookout& seen, std::int64_t now_ns);

RunVerdict judge(const Lookout& seen, const RunRequest& request, const CountersAtStart& start, std::int64_t now_ns);

// Lines for people.
std::vector<std::string> verdict_lines(const RunVerdict& verdict, const RunRequest& request);

// JSON with the keys that `twinbus run --report` writes, as far as the bus shows them, and the rates.
std::string report_json(const RunVerdict& verdict, const RunRequest& request, const Lookout& seen, double wall_s,
                        const std::string& state_hash);

}  // namespace twinbus
