// `./twinbus run SCENE --seeds 1..256`: the scene once for each seed, as many at a time as the machine has processors.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "launcher/run/local_stack.h"
#include "launcher/run/verdict.h"

namespace twinbus::inline launcher {

constexpr std::int64_t kProgressEvery = 500'000'000;  // of a line on a terminal [ns]

struct SeedRange {
  std::uint64_t first = 1, last = 0;  // none when last < first
};

// "1..256", or "7" for one.  False: it is no such thing, or more than a million seeds.
bool read_seeds(const std::string& word, SeedRange& seeds);

// One seed's run, ready to go.
struct SeededRun {
  Scene scene;  // as the seed draws it
  OneProcessConfig config;
};

// What became of one seed.
struct SeedResult {
  std::uint64_t seed = 0;
  RunVerdict verdict;
  std::string state_hash, error;  // error: it could not be run, and why
  std::int64_t ticks = 0;
  long doubted = 0;  // physics steps that are not to be trusted
};

struct SeedsRequest {
  SeedRange seeds;
  std::int64_t ticks = 0;  // of each
  int jobs = 0;            // at a time; 0: one for each processor
  bool part = false;       // of the scene
  bool lanes = false;      // four together in the lanes of a vector: a seed's state_hash is then that of itself alone with lanes
  bool talk = false;       // progress on a terminal, and a line for each seed that fails
  bool measured = false;   // order and step are those that hold an error with the first seed, and its doubts bound those of all
  std::string accuracy{};  // of the report: accuracy_json() of that choice; empty: none was asked for
};

// In the order of the seeds; fewer when Ctrl-C ends it.  A seed gives the state_hash that it gives alone.
// prepare: makes the run of a seed; called from several threads at once.
std::vector<SeedResult> run_seeds(const Model& model, const SeedsRequest& request,
                                  const std::function<SeededRun(std::uint64_t)>& prepare);

// Lines for people, and a report: how many held, for what the others failed.
std::string seeds_text(const std::vector<SeedResult>& results, const SeedsRequest& request, double period, double wall_s);
std::string seeds_json(const std::vector<SeedResult>& results, const SeedsRequest& seeds, const RunRequest& request,
                       double wall_s);

}  // namespace twinbus::launcher
