// How a run comes to the order and step that hold the error asked for: the ladder (launcher/run/ladder.h), climbed
// once and then kept in the cache of this user.

#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/file/fingerprint.h"
#include "common/process/arguments.h"
#include "launcher/run/ladder.h"

namespace twinbus::inline launcher {

inline constexpr double kAutoError = 1e-3;  // of `fidelity: auto` where no error is asked for [m]
inline constexpr double kBand = 1.5;        // times what the doubts of the run that was measured came to

// --fidelity, if given, instead of the scene's.  Throws UsageError for a word that is none.
void choose_fidelity(const Arguments& arguments, Scene& scene);

// --set of `command`.  Throws UsageError for what is no setting.
using Settings = std::vector<std::pair<std::string, std::string>>;
Settings settings_of(const std::string& command, const Arguments& arguments, double period);

struct AccuracyRequest {
  double error = 0.0;   // asked for [m]; 0: the best that the budget gives
  double budget = 0.0;  // of the physics in a control period, CPU [s]; 0: none
  double duration = 0.0;
  std::uint64_t seed = 1;
  bool all = false;   // the whole ladder
  bool talk = false;  // progress on stderr
};

struct AccuracyChoice {
  Ladder ladder;
  int rung = -1;       // -1: none holds the error, or fits the budget
  bool kept = false;   // the ladder came from the cache
  std::string reason;  // one sentence where rung is -1, or where the budget does not hold the error

  const Rung* chosen() const { return rung >= 0 ? &ladder.rungs[static_cast<std::size_t>(rung)] : nullptr; }
  double cost() const { return rung >= 0 ? chosen()->cost : std::nan(""); }  // of its physics [ms/s]; NaN: none was chosen
};

// --accuracy and --budget of `command`, else what the scene asks for.  Throws UsageError.
AccuracyRequest accuracy_of(const std::string& command, const Arguments& arguments, const Scene& scene);
// --budget: milliseconds, or with a unit.  What is wrong with it, or empty.
std::string read_budget(const std::string& text, double& seconds);

AccuracyChoice choose_accuracy(const Model& model, const Scene& scene,
                               const OneProcessConfig& config, const AccuracyRequest& request);

// Of all that its ladder depends on: scene with its seed drawn and what its files hold, settings, robot, this program and the instructions
// that it takes.
Fingerprint ladder_key(const Model& model, const Scene& scene, const OneProcessConfig& config, const AccuracyRequest& request);

// What was chosen, a line for people and an object for a report; cost: of the physics [ms of CPU per simulated s].
std::string accuracy_line(const AccuracyChoice& choice, const AccuracyRequest& asked, double cost);
std::string accuracy_json(const AccuracyChoice& choice, const AccuracyRequest& asked, double cost);

}  // namespace twinbus::launcher
