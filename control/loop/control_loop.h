// Everything the controller process does once per tick, without a bus: states in, one command out.
//
// The same object runs in the process, in `twinbus run`, in tests and in a log re-run, so it never
// asks for the time: control follows the state's own time, time-outs follow the steady clock passed
// in.

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "control/balance/balance_gains.h"
#include "robot/collision/collision.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/step_list.h"
#include "lcmtypes/msg/stop_plan.h"

namespace twinbus::inline control {

struct ControlConfig {
  std::int64_t controller_id = 1;
  Mode first_mode = Mode::kBalance;  // entered on the first state of a run, without a jump
  bool guard_in_loop = true;
  BalanceGains gains;
};

class ControlLoop {
 public:
  // Allocates everything.  Throws std::runtime_error if the robot cannot be controlled, saying why.
  // The model must outlive the loop.
  ControlLoop(const Model& model, const ControlConfig& config);
  ~ControlLoop();

  // Inputs, admitted and finite (convert); each is remembered until the next step.
  void on_state(const RobotState& state, std::int64_t now_ns) noexcept;
  void on_mode_request(const ModeRequest& request) noexcept;
  void on_walk_command(const WalkCommand& command, std::int64_t now_ns) noexcept;
  // Footsteps to be walked from where the robot stands, in mode walk; refused with a sentence (take_sentence) when it
  // cannot.  The same one again is no new one.
  void on_step_list(const StepList& list) noexcept;
  void on_gamepad(const Gamepad& gamepad, std::int64_t now_ns) noexcept;
  void on_arm_path(const ArmPathPiece& piece) noexcept;
  void on_motion(const MotionPiece& piece) noexcept;
  void on_arm_goal(const ArmGoal& goal) noexcept;  // only to cancel the path being followed
  void on_stop(const StopRequest& stop) noexcept;
  void on_guard(const GuardReport& report, std::int64_t now_ns) noexcept;
  // Obstacles in the ground frame at the start, for the in-loop guard; allocates, call before the
  // loop runs.
  void set_obstacles(const std::vector<Obstacle>& obstacles);

  // Computes the command that answers the newest state.  False when there is nothing to answer (no
  // state yet, source not active, state already answered - a repeated tick gives the same command
  // again and returns true).
  bool step(std::int64_t now_ns, JointCommand& command) noexcept;

  // Fills a piece of the stop plan behind the commands that is ready to be sent; false when there is none.  To be asked
  // after each step until there is none.
  bool take_plan(StopPlanPiece& piece) noexcept;

  // What was decided in the last step, for CONTROLLER_STATUS.
  const ControllerStatus& status() const noexcept;
  // Normal force that each foot was asked to carry in the last step, left and right [N]; 0 where nobody asks.
  std::array<double, 2> foot_forces() const noexcept;
  // The footsteps to come, for FOOTSTEPS; run_id and time are the caller's.
  void footsteps(ObstaclesPiece& out) const noexcept;
  // What people should be told once (the robot cannot walk, it has fallen, ...), or null;
  // cleared by the call.  A string that lives for ever.  of_path, when given: it says why an arm path is not followed.
  const char* take_sentence(bool* of_path = nullptr) noexcept;
  // The in-loop guard's report of the last step, when guard_in_loop.
  const GuardReport& guard_report() const noexcept;
  // Why it held joints or asked for a stop last, in words; empty when it never did.  Allocates.
  std::string guard_cause() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Every message that the controller obeys beside STATE, once, for the process, a run without a bus and `log rerun`: calls
// visit.operator()<&ControlLoop::on_...>() for each, in the order in which a process listens.
template <class Visit>
constexpr void for_each_control_input(Visit&& visit) {
  visit.template operator()<&ControlLoop::on_mode_request>();
  visit.template operator()<&ControlLoop::on_walk_command>();
  visit.template operator()<&ControlLoop::on_step_list>();
  visit.template operator()<&ControlLoop::on_motion>();
  visit.template operator()<&ControlLoop::on_gamepad>();
  visit.template operator()<&ControlLoop::on_arm_path>();
  visit.template operator()<&ControlLoop::on_arm_goal>();
  visit.template operator()<&ControlLoop::on_stop>();
  visit.template operator()<&ControlLoop::on_guard>();
}

}  // namespace twinbus::control
