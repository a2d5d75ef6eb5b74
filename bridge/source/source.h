// A source of STATE around an adaptor: read, publish, wait for the command, gate it, write it; once
// per tick.
//
// Pure: knows neither bus nor clock.  The process shells (bridge/main.cpp, sim/main.cpp), `twinbus
// run` and the protocol explorer drive the same object.  One tick is
//
//     begin_tick(now)   the adaptor is read, the handover moves, the state is filled in
//       publish state()
//     on_command(...)   as commands arrive
//     end_tick(now)     the gate's output is written; at 0.6 of the period at the latest

#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "bridge/adaptor/adaptor.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/pace.h"
#include "lcmtypes/msg/reports.h"
#include "lcmtypes/msg/requests.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/stop_plan.h"

namespace twinbus {

struct FirstCut;

struct SourceConfig {
  std::int64_t run_id = 1;  // random, below 2^53
  SourceKind kind = SourceKind::kSimulator;
  Pace pace = Pace::kRealTime;
  bool guard_required = false;  // the stack lists a guard: its silence masks the arms
  std::uint64_t seed = 1;       // of stop nonces
};

class Source {
 public:
  // Model and adaptor must outlive the source; the adaptor is open.
  Source(const Model& model, RobotAdaptor& adaptor, const SourceConfig& config);
  ~Source();

  // Heard on the bus, admitted and finite.  now_ns: steady clock.
  // On STATE, from another run.
  void on_state(const RobotState& state, std::int64_t now_ns) noexcept;
  // On STATE_SIM, STATE_BRIDGE or STATE_REPLAY.
  void on_standby_state(const RobotState& state, std::int64_t now_ns) noexcept;
  void on_command(const JointCommand& command, std::int64_t now_ns) noexcept;
  void on_stop_plan(const StopPlanPiece& piece, std::int64_t now_ns) noexcept;
  void on_source_request(const SourceRequest& request, std::int64_t now_ns) noexcept;
  void on_controller_request(const ControllerRequest& request, std::int64_t now_ns) noexcept;
  void on_stop(const StopRequest& stop, std::int64_t now_ns) noexcept;
  void on_guard(const GuardReport& report, std::int64_t now_ns) noexcept;
  // For policy when_safe.
  void on_controller_status(const ControllerStatus& status, std::int64_t now_ns) noexcept;

  void begin_tick(std::int64_t now_ns) noexcept;
  void end_tick(std::int64_t now_ns) noexcept;

  // After begin_tick: what to publish, and whether on STATE (else on the own channel of its kind;
  // see also role).
  const RobotState& state() const noexcept;
  bool publishes_on_state() const noexcept;
  // True once an admitted command for the present tick has come, so that end_tick need not wait for
  // its deadline.
  bool command_ready() const noexcept;
  // A real-time standby keeps its ticks in step with STATE: when the next tick is due, given its
  // own last one.
  std::int64_t next_tick_due_ns(std::int64_t last_due_ns) const noexcept;
  // A stop that policy when_safe asks of the controller; kNone if none.  Publish it on STOP.
  StopRequest take_stop_to_publish(std::int64_t now_ns) noexcept;

  // Once per fall of the robot, which has latched stop 'off': what led to it, zero-terminated.
  bool take_fall(std::array<char, 200>& cause) noexcept;

  const SourceStatus& status() const noexcept;
  const FirstCut& first_cut() const noexcept;  // of a command, by the gate; bridge/gate/command_gate.h
  const FirstCut& first_catch_up() const noexcept;
  // The command that was last written to the adaptor.
  const JointCommand& effective_command() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
