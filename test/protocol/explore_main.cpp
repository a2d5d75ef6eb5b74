// ./twinbus bench explorer: explorer_bench [--sources N] [--depth D] [--faults F]
// [--happenings H] [--minutes M]
// [--start NAME] [--without RULE].  With --minutes it deepens until the time is over.  --without
// switches off a rule of bridge/handover/rules.h, by its number, to see that it is missed.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "test/protocol/explorer.h"

using namespace twinbus;
using namespace twinbus::protocol;

namespace {

constexpr int kFirstDepth = 3;

bool report(Start start, int sources, const Bounds& bounds, const Outcome& outcome,
            double seconds) {
  std::printf(
      "%-14s sources %d depth %2d faults %d happenings %d: %9lld states %10lld steps %8lld ends "
      "%7.1f s  %s\n",
      start_name(start), sources, bounds.depth, bounds.faults, bounds.happenings,
      static_cast<long long>(outcome.states), static_cast<long long>(outcome.steps),
      static_cast<long long>(outcome.ends), seconds,
      !outcome.violation.empty() ? "VIOLATION"
      : outcome.complete         ? "holds"
                                 : "out of time");
  if (!outcome.violation.empty()) {
    std::printf("  %s\n", outcome.violation.c_str());
    for (std::size_t i = 0; i < outcome.trace.size(); ++i) {
      std::printf("  %2zu %s\n", i + 1, outcome.trace[i].c_str());
    }
  }
  std::fflush(stdout);
  return outcome.violation.empty();
}

}  // namespace

int main(int argc, char** argv) {
  int sources = 2;
  double minutes = 0.0;
  Bounds bounds;
  int depth = 0;  // not said
  std::string only;
  RuleSet off = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help" || i + 1 >= argc) {
      std::puts(
          "explorer_bench [--sources 2|3] [--depth D] [--faults F] [--happenings H] [--minutes "
          "M] [--start NAME] [--without RULE]");
      return word == "--help" ? 0 : 2;
    }
    const char* value = argv[++i];
    if (word == "--sources")
      sources = std::atoi(value);
    else if (word == "--depth")
      depth = std::atoi(value);
    else if (word == "--faults")
      bounds.faults = std::atoi(value);
    else if (word == "--happenings")
      bounds.happenings = std::atoi(value);
    else if (word == "--minutes")
      minutes = std::atof(value);
    else if (word == "--start")
      only = value;
    else if (word == "--without")
      off |= without(static_cast<Rule>(std::atoi(value)));
    else {
      std::fprintf(stderr, "explorer_bench: no option %s\n", word.c_str());
      return 2;
    }
  }
  if (sources < 2 || sources > kMaxSources || bounds.depth < 1 || bounds.depth > 60) return 2;
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  const double begin = now();
  if (depth > 0) {
    bounds.depth = depth;
  } else if (minutes > 0.0) {
    bounds.depth = kFirstDepth;  // all starts first, then deeper
  }
  bool holds = true;
  for (;;) {
    bool complete = true;
    for (const Start start : all_starts()) {
      if (!only.empty() && only != start_name(start)) continue;
      if (minutes > 0.0) bounds.seconds = 60.0 * minutes - (now() - begin);
      if (bounds.seconds <= 0.0) return holds ? 0 : 1;
      const double from = now();
      const Outcome outcome = explore(start, sources, bounds, off);
      holds = report(start, sources, bounds, outcome, now() - from) && holds;
      complete = complete && outcome.complete;
    }
    if (!(minutes > 0.0) || !complete || !holds) return holds ? 0 : 1;
    if (bounds.faults <= bounds.happenings)
      ++bounds.faults;
    else
      ++bounds.happenings;
    ++bounds.depth;
  }
}
