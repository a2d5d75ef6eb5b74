#include "launcher/run/seeds.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

#include <nlohmann/json.hpp>

#include "common/process/process.h"
#include "common/text/formatted.h"
#include "launcher/bus/event_groups.h"
#include "launcher/run/judge_scene.h"

namespace twinbus::inline launcher {

namespace {

constexpr std::uint64_t kMostSeeds = 1'000'000;
constexpr std::size_t kMostListed = 20;               // of seeds that failed for one cause

bool number(const std::string& word, std::uint64_t& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && value <= 1'000'000'000;
}

// Those from `first` on: one, or as many as step together in lanes.
std::vector<SeedResult> run_group(const Model& model, const SeedsRequest& request, std::uint64_t first, std::size_t count,
                                  const std::function<SeededRun(std::uint64_t)>& prepare) {
  std::vector<SeedResult> results(count);
  std::vector<SeededRun> ready(count);
  std::vector<std::unique_ptr<OneProcess>> runs(count);
  const auto guarded = [&](std::size_t k, const auto& what) {
    try {
      return what();
    } catch (const std::exception& error) {
      results[k].error = error.what();
      runs[k].reset();
      return false;
    }
  };
  std::vector<OneProcess*> going;
  for (std::size_t k = 0; k < count; ++k) {
    results[k].seed = first + k;
    (void)guarded(k, [&] {
      ready[k] = prepare(first + k);
      runs[k] = std::make_unique<OneProcess>(model, ready[k].scene, ready[k].config);
      going.push_back(runs[k].get());
      return true;
    });
  }
  std::string forbidden;
  try {
    if (request.lanes && !going.empty()) OneProcess::share_lanes(going);
  } catch (const std::exception& error) {
    forbidden = error.what();
  }
  while (!quit_requested() && forbidden.empty()) {
    going.clear();
    for (std::size_t k = 0; k < count; ++k) {
      if (!runs[k] || runs[k]->ticks() >= request.ticks || !guarded(k, [&] { return runs[k]->tick(); })) continue;
      runs[k]->take_sentences();
      going.push_back(runs[k].get());
    }
    if (going.empty()) break;
    if (request.lanes) OneProcess::advance_together(going);
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!runs[k]) continue;
    if (!forbidden.empty()) {
      results[k].error = forbidden;
      continue;
    }
    (void)guarded(k, [&] {
      results[k].ticks = runs[k]->ticks();
      results[k].verdict = judge_scene(*runs[k], ready[k].scene.criteria, request.ticks, request.part);
      results[k].state_hash = runs[k]->state_hash();
      results[k].doubted = runs[k]->trust().doubted;
      return true;
    });
  }
  return results;
}

std::string cause_of(const SeedResult& result) {
  if (!result.error.empty()) return result.error;
  return result.verdict.passed ? "" : result.verdict.failures.empty() ? "it was not finished" : result.verdict.failures.front();
}

std::string list_of(const std::vector<std::uint64_t>& seeds) {
  std::string text = seeds.size() > 1 ? "(seeds" : "(seed";
  for (std::size_t i = 0; i < std::min(seeds.size(), kMostListed); ++i) text += " " + std::to_string(seeds[i]);
  return text + (seeds.size() > kMostListed ? " ...)" : ")");
}

// What the steps of all seeds say of the error that was measured with the first one.
std::string doubts_text(const std::vector<SeedResult>& results, const SeedsRequest& request) {
  std::vector<std::uint64_t> doubted;
  for (const SeedResult& result : results) {
    if (result.doubted > 0) doubted.push_back(result.seed);
  }
  if (!request.measured) {
    if (doubted.empty()) return "";
    return formatted("%zu of %zu had physics steps that are not to be trusted ", doubted.size(), results.size()) + list_of(doubted) + "\n";
  }
  const std::string first = formatted("seed %llu, with which the error was measured", static_cast<unsigned long long>(request.seeds.first));
  std::string text = formatted("accuracy: %zu of %zu seeds had no worse step than ", results.size() - doubted.size(), results.size()) + first +
                     "; their own errors were not measured\n";
  if (!doubted.empty()) {
    text += formatted("accuracy: %zu of %zu had worse steps than that, so nothing is known of their errors ", doubted.size(), results.size()) +
            list_of(doubted) + "\n";
  }
  return text;
}

}  // namespace

bool read_seeds(const std::string& word, SeedRange& seeds) {
  const std::size_t dots = word.find("..");
  SeedRange found;
  if (!number(word.substr(0, dots), found.first)) return false;
  if (!number(dots == std::string::npos ? word : word.substr(dots + 2), found.last)) return false;
  if (found.last < found.first || found.last - found.first >= kMostSeeds) return false;
  seeds = found;
  return true;
}

std::vector<SeedResult> run_seeds(const Model& model, const SeedsRequest& request,
                                  const std::function<SeededRun(std::uint64_t)>& prepare) {
  const std::uint64_t count = request.seeds.last - request.seeds.first + 1;
  const auto processors = std::max(1U, std::thread::hardware_concurrency());
  const std::uint64_t group = request.lanes ? SimAdaptor::kMostTogether : 1;
  const std::uint64_t most = request.jobs > 0 ? static_cast<std::uint64_t>(request.jobs) : processors;
  const auto jobs = std::min<std::uint64_t>((count + group - 1) / group, most);
  std::vector<SeedResult> results(count);
  std::vector<char> done(count, 0);
  std::atomic<std::uint64_t> next{0}, finished{0};
  std::mutex output;
  std::int64_t shown_ns = monotonic_ns();
  const bool terminal = isatty(STDERR_FILENO) == 1;
  const auto work = [&] {
    for (std::uint64_t from = next.fetch_add(group); from < count && !quit_requested(); from = next.fetch_add(group)) {
      const std::uint64_t to = std::min(count, from + group);
      std::vector<SeedResult> found = run_group(model, request, request.seeds.first + from, to - from, prepare);
      std::move(found.begin(), found.end(), results.begin() + static_cast<std::ptrdiff_t>(from));
      for (std::uint64_t i = from; i < to; ++i) done[i] = quit_requested() ? 0 : 1;
      finished += to - from;
      if (!request.talk) continue;
      const std::scoped_lock lock(output);
      for (std::uint64_t i = from; i < to; ++i) {
        const std::string cause = cause_of(results[i]);
        if (cause.empty() || done[i] == 0) continue;
        if (terminal) std::fprintf(stderr, "\r                    \r");
        std::printf("seed %llu: %s\n", static_cast<unsigned long long>(results[i].seed), cause.c_str());
        std::fflush(stdout);
      }
      if (!terminal || monotonic_ns() - shown_ns < kProgressEvery) continue;
      shown_ns = monotonic_ns();
      std::fprintf(stderr, "\r%llu of %llu seeds ", static_cast<unsigned long long>(finished.load()), static_cast<unsigned long long>(count));
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t j = 1; j < jobs; ++j) threads.emplace_back(work);
    work();
  }
  if (request.talk && terminal) std::fprintf(stderr, "\r                    \r");
  std::vector<SeedResult> kept;
  for (std::uint64_t i = 0; i < count; ++i) {
    if (done[i] != 0) kept.push_back(std::move(results[i]));
  }
  return kept;
}

std::string seeds_text(const std::vector<SeedResult>& results, const SeedsRequest& request, double period, double wall_s) {
  std::size_t passed = 0;
  std::int64_t ticks = 0;
  std::map<std::string, std::vector<std::uint64_t>> causes;
  for (const SeedResult& result : results) {
    ticks += result.ticks;
    const std::string cause = cause_of(result);
    if (cause.empty()) {
      ++passed;
    } else {
      causes[without_numbers(cause)].push_back(result.seed);
    }
  }
  std::string text;
  for (const auto& [cause, seeds] : causes) {
    text += std::to_string(seeds.size()) + " of " + std::to_string(results.size()) + ": " + cause + " " + list_of(seeds) + "\n";
  }
  text += doubts_text(results, request);
  const std::uint64_t asked = request.seeds.last - request.seeds.first + 1;
  text += formatted("%zu of %zu seeds passed; %.1f s simulated in %.2f s, %.0f ticks a second\n", passed, results.size(),
                    period * static_cast<double>(ticks), wall_s, static_cast<double>(ticks) / std::max(wall_s, 1e-9));
  if (results.size() < asked) text += "stopped: " + std::to_string(asked - results.size()) + " seeds were not run\n";
  return text;
}

std::string seeds_json(const std::vector<SeedResult>& results, const SeedsRequest& seeds, const RunRequest& request,
                       double wall_s) {
  nlohmann::ordered_json json = {{"scene", request.scene}, {"robot", request.robot}, {"engine", request.engine},
                                 {"step_s", request.step_s}, {"duration_s", request.duration}, {"wall_s", wall_s}};
  if (!seeds.accuracy.empty()) json["accuracy"] = nlohmann::ordered_json::parse(seeds.accuracy);
  std::size_t passed = 0;
  auto& list = json["seeds"] = nlohmann::ordered_json::array();
  for (const SeedResult& result : results) {
    const bool good = cause_of(result).empty();
    passed += good ? 1 : 0;
    list.push_back({{"seed", result.seed}, {"passed", good}, {"ticks", result.ticks}, {"state_hash", result.state_hash}, {"doubted_steps", result.doubted},
                    {"failures", result.error.empty() ? result.verdict.failures : std::vector<std::string>{result.error}}});
  }
  json["passed"] = passed;
  json["run"] = results.size();
  return json.dump(2) + "\n";
}

}  // namespace twinbus::launcher
