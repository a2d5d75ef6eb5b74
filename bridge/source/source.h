// A source of STATE around an adaptor: read, publish, wait for the command, gate it, write it; once
// per tick.
//
// Pure: knows neither bus nor clock.  The process shells (bridge/main.cpp, sim/main.cpp), `twinbus
// run` and the protocol explorer, which clones it, drive the same object.  One tick is
//
//     begin_tick(now)   the adaptor is read, the handover moves, the state is filled in
//       publish state()
//     on_command(...)   as commands arrive
//     end_tick(now)     the gate's output is written; at 0.6 of the period at the latest

#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "bridge/adaptor/adaptor.h"
#include "bridge/adaptor/frozen_sensors.h"
#include "bridge/gate/command_gate.h"
#include "bridge/handover/handover.h"
#include "bridge/source/fall_watch.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/pace.h"
#include "lcmtypes/msg/robot_io.h"
#include "lcmtypes/msg/stop_plan.h"
#include "robot/description/model.h"
#include "robot/estimation/estimator.h"

namespace twinbus {
struct ProtocolProbe;
}  // namespace twinbus

namespace twinbus::inline bridge {

struct SourceConfig {
  std::int64_t run_id = 1;  // random, below 2^53
  SourceKind kind = SourceKind::kSimulator;
  Pace pace = Pace::kRealTime;
  bool guard_required = false;  // the stack lists a guard: its silence masks the arms
  std::uint64_t seed = 1;       // of stop nonces
};

class Source {
 public:
  // Model and adaptor must outlive the source and its copies, which share them; the adaptor is open.
  Source(const Model& model, RobotAdaptor& adaptor, const SourceConfig& config);
  Source(const Model& model, std::shared_ptr<const GateLimits> limits, RobotAdaptor& adaptor, const SourceConfig& config,
         const HandoverConfig& handover);

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
  const RobotState& state() const noexcept { return state_; }
  bool publishes_on_state() const noexcept { return handover_.holds_state(); }
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

  const SourceStatus& status() const noexcept { return status_; }
  const RefusedCommand& refused() const noexcept { return gate_.refused(); }
  const FirstCut& first_cut() const noexcept { return gate_.first_cut(); }  // of a command, by the gate
  const FirstCut& first_catch_up() const noexcept { return gate_.first_catch_up(); }
  // The command that was last written to the adaptor.
  const JointCommand& effective_command() const noexcept { return gate_.effective(); }
  const Handover& handover() const noexcept { return handover_; }
  const CommandGate& gate() const noexcept { return gate_; }
  Transition last_transition() const noexcept { return transition_; }

 private:
  friend struct twinbus::ProtocolProbe;  // test/protocol looks inside to tell states apart
  std::int64_t gate_clock(std::int64_t now_ns) const noexcept;
  HandoverInput handover_input(std::int64_t now_ns) const noexcept;
  bool walking(std::int64_t now_ns) const noexcept;  // the controller says so
  void apply(Transition transition, std::int64_t now_ns) noexcept;
  void follow_role(std::int64_t now_ns) noexcept;
  void impose_holder() noexcept;
  void adopt_imposed() noexcept;
  void read_adaptor(std::int64_t now_ns) noexcept;
  bool frozen(std::int64_t now_ns) const noexcept;
  void anchor(std::int64_t now_ns) noexcept;
  bool holder_walks(std::int64_t now_ns) const noexcept;
  void stand_aside(std::int64_t now_ns) noexcept;
  void fill_state() noexcept;
  void fill_status() noexcept;
  void watch_support(std::int64_t now_ns) noexcept;
  void watch_for_a_fall(std::int64_t now_ns) noexcept;
  bool estimate() noexcept;  // own_estimate_ takes this tick's state, if anybody needs it

  const Model* model_;
  std::shared_ptr<const GateLimits> limits_;
  RobotAdaptor* adaptor_;
  SourceConfig config_;
  Handover handover_;
  CommandGate gate_;
  std::optional<Estimator> holder_estimate_;  // of the source that a settable standby follows
  std::optional<Estimator> own_estimate_;     // of hardware: is it statically stable?  And for stop plans
  std::int64_t estimated_tick_ = -1;

  RobotState state_;
  RobotState holder_state_;
  JointCommand holder_command_, holder_before_;  // the newest, and the one before it
  SourceStatus status_;
  Transition transition_ = Transition::kNone;
  GateVerdict verdict_ = GateVerdict::kClosed;
  ControllerStatus controller_;
  std::int64_t controller_ns_ = 0;
  std::int64_t holder_arrival_ns_ = 0;
  std::int64_t anchored_ns_ = 0;
  std::int64_t walked_ns_ = 0;          // the holder, last
  std::int64_t support_since_ns_ = -1;  // statically stable since; -1 not
  std::int64_t rest_asked_ns_ = 0;
  std::int32_t rest_sequence_ = 0;
  std::int64_t last_controller_request_ = 0;
  std::int64_t good_read_ns_ = 0;
  bool device_ok_ = true;
  FrozenSensors sensors_;
  bool stable_ = true;
  bool holder_new_ = false;  // a STATE of the holder since the last tick
  bool imposed_ = false;     // the adaptor has the holder's state
  bool aside_ = false;       // a shadow that holds its posture while its holder walks
  bool have_holder_command_ = false;
  bool written_ = true;  // this tick's set-point has been written
  bool limp_ = false;    // fall_safe() has taken over

  FallWatch fall_;
  FallContext fall_context_;
  bool fallen_ = false;               // to be told
  std::int64_t mode_since_ns_ = 0;    // of the controller
  std::int64_t began_ns_ = 0;         // the last tick
  std::int64_t slept_at_ns_ = 0, silent_at_ns_ = 0;  // when what the context names was
};

}  // namespace twinbus::bridge
