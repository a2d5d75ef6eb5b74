// How `up` comes to the order and step of its world: by the ladder and the cache of `run --accuracy`, and no more than real time
// leaves.
//
// Nothing is left out of the model: whoever watches a stack may push it, jog it or send it anywhere.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "launcher/run/accuracy.h"
#include "launcher/run/verdict.h"
#include "launcher/stack/stack.h"

namespace twinbus::inline launcher {

inline constexpr double kPhysicsShare = 0.5;  // of a control period that the physics may take; the rest is for everybody else

// What the physics may take of a control period where time is kept [s of CPU, in the mean]; infinite in lock-step.
double time_for_physics(double period, double rate, bool lockstep);

// Where what was chosen takes more than `most` of a control period: the nearest to the converged answer that does not, and in
// reason the sentence that says so.  most: as time_for_physics(); asked: with the budget that the user has given.
void keep_to_real_time(AccuracyChoice& choice, const AccuracyRequest& asked, double period, double most);

class UpAccuracy {
 public:
  // scene: fitted to the model.  Climbs the ladder where that is asked and no cache has it.  Throws UsageError, and
  // std::runtime_error where it is interrupted.
  UpAccuracy(const Arguments& arguments, const Model& model, const Scene& scene, const Stack& stack, const RunRequest& run);

  // Appended to what the simulator is started with; empty where nothing was asked or nothing holds it.
  std::vector<std::string> words() const;
  // What was chosen, for people; empty where nothing was asked.
  std::vector<std::string> lines() const;
  double step_or(double otherwise) const;
  // Another world runs: nothing was chosen for it.  Whether something had been.
  bool drop();
  // Why the error asked for is not held; empty: it is, or a budget alone was asked, within which the best runs.
  std::string failure() const { return choice_ && (asked_.error > 0.0 || choice_->rung < 0) ? choice_->reason : ""; }
  // A report with what was chosen.
  std::string in_report(const std::string& report) const;

 private:
  AccuracyRequest asked_;
  std::optional<AccuracyChoice> choice_;
  double period_ = 0.0;  // of control [s]
};

}  // namespace twinbus::launcher
