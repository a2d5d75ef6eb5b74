// ./twinbus bench explorer: explorer_bench [--sources N] [--depth D] [--faults F]
// [--happenings H] [--minutes M]
// [--start NAME] [--without RULE].  With --minutes it deepens until the time is over.  --without
// switches off a rule of bridge/handover/rules.h, by its number, to see that it is missed.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "common/process/options.h"
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
  Bounds bounds;
  std::int64_t asked = 2, depth = 0, rule = -1;  // depth 0, rule -1: not said
  std::int64_t faults = bounds.faults, happenings = bounds.happenings;
  double minutes = 0.0;
  std::string only;
  Options options("explorer_bench", "Explores the states of the protocol.");
  options.integer("--sources", "N", asked, 2, kMaxSources, "sources");
  options.integer("--depth", "D", depth, 0, 60, "of the search");
  options.integer("--faults", "F", faults, 0, 1000, "of the network, on a way");
  options.integer("--happenings", "H", happenings, 0, 1000, "of operators and devices, on a way");
  options.number("--minutes", "M", minutes, 0.0, 1e6, "deeper and deeper for so long");
  options.text("--start", "NAME", only, "only this one");
  options.integer("--without", "RULE", rule, 0, 100, "leaves a rule out, to see that it is missed");
  options.parse(argc, argv);
  const int sources = static_cast<int>(asked);
  bounds.faults = static_cast<int>(faults);
  bounds.happenings = static_cast<int>(happenings);
  const RuleSet off = rule >= 0 ? without(static_cast<Rule>(rule)) : RuleSet{0};
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  };
  const double begin = now();
  if (depth > 0) {
    bounds.depth = static_cast<int>(depth);
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
