#include "launcher/up/up_accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "common/math/index.h"
#include "common/text/formatted.h"
#include "sim/scene/scene_seed.h"

namespace twinbus::inline launcher {

namespace {

constexpr char kSimulator[] = "twinbus_simulator";

// The ladder is of the one world that a stack simulates.
bool simulates_one_world(const Stack& stack) {
  const auto simulators = std::count_if(stack.processes.begin(), stack.processes.end(),
                                        [](const StackProcess& process) { return process.program == kSimulator; });
  const StackProcess* source = stack.find(stack.activate);
  return source != nullptr && source->program == kSimulator && simulators == 1;
}

bool guarded(const Stack& stack) {
  return std::any_of(stack.processes.begin(), stack.processes.end(),
                     [](const StackProcess& process) { return process.program == "twinbus_guard"; });
}

// CPU of the physics in a control period [s].
double share_of_period(const Rung& rung, double period) { return 1e-3 * rung.cost * period; }

}  // namespace

double time_for_physics(double period, double rate, bool lockstep) {
  return lockstep ? std::numeric_limits<double>::infinity() : kPhysicsShare * period / rate;
}

void keep_to_real_time(AccuracyChoice& choice, const AccuracyRequest& asked, double period, double most) {
  const bool too_long = choice.chosen() != nullptr && share_of_period(*choice.chosen(), period) > most;
  const std::string leaves = formatted("real time leaves the physics %.3g ms of each control period", 1e3 * most);
  if (!too_long) {
    if (asked.budget > most && choice.reason.empty())
      choice.reason = formatted("a budget of %.3g ms does not fit real time: ", 1e3 * asked.budget) + leaves;
    return;
  }
  const Rung wanted = *choice.chosen();
  choice.rung = choice.ladder.choose_within(1e3 * most / period);
  choice.reason = formatted("%.3g mm does not fit real time: ", 1e3 * asked.error) + words_of(wanted) +
                  formatted(" takes %.3g ms in the mean, and ", 1e3 * share_of_period(wanted, period)) + leaves;
  if (choice.rung < 0) choice.reason += ", into which no order and step fits";
}

UpAccuracy::UpAccuracy(const Arguments& arguments, const Model& model, const Scene& scene, const Stack& stack,
                       const RunRequest& run)
    : period_(model.period()) {
  Scene whole = scene;
  if (whole.fidelity == "auto") whole.fidelity = "full";
  asked_ = accuracy_of("up", arguments, whole);
  if (!(asked_.error > 0.0) && !(asked_.budget > 0.0)) return;
  if (!simulates_one_world(stack)) {
    if (arguments.has("--accuracy") || arguments.has("--budget"))
      throw UsageError("up: --accuracy and --budget are for stacks with one simulator, which is active first; " + stack.name + " is none");
    return;
  }
  whole.engine = run.engine;
  whole.accuracy = asked_.error;
  apply_seed(whole, model, run.seed);
  asked_.duration = run.duration > 0.0 ? std::min(run.duration, scene.duration) : scene.duration;
  asked_.seed = run.seed;
  OneProcessConfig config;
  config.settings = settings_of("up", arguments, model.period());
  config.seed = run.seed;
  config.control.guard_in_loop = guarded(stack);
  const double most = time_for_physics(model.period(), run.rate, run.lockstep);
  AccuracyRequest within = asked_;
  if (within.budget > 0.0) within.budget = std::min(within.budget, most);
  choice_ = choose_accuracy(model, whole, config, within);
  keep_to_real_time(*choice_, asked_, period_, most);
}

std::vector<std::string> UpAccuracy::words() const {
  std::vector<std::string> words;
  if (!choice_) return words;
  if (asked_.error > 0.0) words.insert(words.end(), {"--accuracy", formatted("%.9g", asked_.error)});
  if (choice_->chosen() == nullptr) return words;
  const Rung& rung = *choice_->chosen();
  words.insert(words.end(), {"--set", "solver.order=" + std::to_string(rung.order), "--step", formatted("%.12g", rung.step)});
  if (rung.local > 0.0) words.insert(words.end(), {"--set", formatted("solver.local_error=%.9g", rung.local)});
  const TrustBands bands = rung.bands.times(kBand);
  for (const auto& [option, band] : {std::pair("--band-error", bands.off), std::pair("--band-gain", bands.gain),
                                     std::pair("--band-rise", bands.rise), std::pair("--band-depth", bands.depth)})
    words.insert(words.end(), {option, formatted("%.17g", band)});
  return words;
}

std::vector<std::string> UpAccuracy::lines() const {
  if (!choice_) return {};
  const double cost = choice_->cost();
  std::string line = accuracy_line(*choice_, asked_, cost);
  if (choice_->chosen() != nullptr) line += formatted("; %.3g of %.3g ms of a control period", cost * period_, 1e3 * period_);
  std::vector<std::string> lines{line};
  if (!choice_->reason.empty()) lines.push_back(choice_->reason);
  return lines;
}

bool UpAccuracy::drop() {
  const bool had = choice_.has_value();
  choice_.reset();
  return had;
}

double UpAccuracy::step_or(double otherwise) const {
  return choice_ && choice_->chosen() != nullptr ? choice_->chosen()->step : otherwise;
}

std::string UpAccuracy::in_report(const std::string& report) const {
  if (!choice_) return report;
  auto json = nlohmann::ordered_json::parse(report);
  json["accuracy"] = nlohmann::ordered_json::parse(accuracy_json(*choice_, asked_, choice_->cost()));
  return json.dump(2) + "\n";
}

}  // namespace twinbus::launcher
