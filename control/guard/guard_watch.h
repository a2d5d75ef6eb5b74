// What the guard process does per tick, without a bus: judges a state together with the newest command that answers it.
//
// The same object runs in the process and in the re-run of a log.

#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "control/guard/guard.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline control {

class GuardWatch {
 public:
  // The model must outlive this.
  GuardWatch(const Model& model, const GuardConfig& config)
      : guard_(model, config), estimator_(model) {}

  // For the source that is watched; an older one than the last does not count.
  void on_command(const JointCommand& command) noexcept {
    if (has_command_ && command.run_id == command_.run_id && command.tick < command_.tick) return;
    command_ = command;
    has_command_ = true;
  }

  GuardReport judge(const RobotState& state) noexcept {
    estimator_.update(state);
    if (state.run_id != run_id_) last_run_id_ = std::exchange(run_id_, state.run_id);
    // A source that takes over obeys what the one before it was told last, until it is told something itself.
    const bool for_it = command_.run_id == state.run_id || command_.run_id == last_run_id_;
    const bool answered = has_command_ && for_it && command_.tick <= state.tick && state.tick - command_.tick <= kOldCommand;
    GuardReport report = guard_.check(state, answered ? &command_ : nullptr, estimator_);
    report.compute_ns = 0;
    if (state.stop_kind != StopKind::kNone)
      report.stop_asked = false;  // it has been stopped already
    return report;
  }

  // As Guard::cause.
  const GuardCause& cause() const noexcept { return guard_.cause(); }

  void set_obstacles(const std::vector<Obstacle>& obstacles) { guard_.set_obstacles(obstacles); }
  const std::vector<Obstacle>& obstacles() const noexcept { return guard_.obstacles(); }

 private:
  // An answer to a state further back says nothing any more [ticks].
  static constexpr std::int64_t kOldCommand = 5;

  Guard guard_;
  Estimator estimator_;
  JointCommand command_;
  bool has_command_ = false;
  std::int64_t run_id_ = 0, last_run_id_ = 0;  // of the states
};

}  // namespace twinbus::control
