// What Source does, as one copyable object: handover, gate and adaptor joined once per tick.
//
// Source (source.h) is this behind a pointer.  The protocol explorer holds it directly and clones
// it; a clone shares the model and the adaptor.

#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "bridge/adaptor/adaptor.h"
#include "bridge/gate/command_gate.h"
#include "bridge/adaptor/frozen_sensors.h"
#include "bridge/handover/handover.h"
#include "bridge/source/fall_watch.h"
#include "bridge/source/source.h"
#include "robot/estimation/estimator.h"

namespace twinbus {

class SourceCore {
 public:
  // limits, model and adaptor must outlive this.
  SourceCore(const Model& model, const GateLimits& limits, RobotAdaptor& adaptor,
             const SourceConfig& config, const HandoverConfig& handover);

  void on_state(const RobotState& state, std::int64_t now_ns) noexcept;
  void on_standby_state(const RobotState& state, std::int64_t now_ns) noexcept;
  void on_command(const JointCommand& command, std::int64_t now_ns) noexcept;
  void on_stop_plan(const StopPlanPiece& piece, std::int64_t now_ns) noexcept;
  void on_source_request(const SourceRequest& request, std::int64_t now_ns) noexcept;
  void on_controller_request(const ControllerRequest& request, std::int64_t now_ns) noexcept;
  void on_stop(const StopRequest& stop, std::int64_t now_ns) noexcept;
  void on_guard(const GuardReport& report, std::int64_t now_ns) noexcept;
  void on_controller_status(const ControllerStatus& status, std::int64_t now_ns) noexcept;
  void begin_tick(std::int64_t now_ns) noexcept;
  void end_tick(std::int64_t now_ns) noexcept;
  std::int64_t next_tick_due_ns(std::int64_t last_due_ns) const noexcept;
  StopRequest take_stop_to_publish(std::int64_t now_ns) noexcept;
  bool take_fall(std::array<char, 200>& cause) noexcept;

  const RobotState& state() const noexcept { return state_; }
  bool command_ready() const noexcept;
  const SourceStatus& status() const noexcept { return status_; }
  const Handover& handover() const noexcept { return handover_; }
  const CommandGate& gate() const noexcept { return gate_; }
  Transition last_transition() const noexcept { return transition_; }
  GateVerdict last_verdict() const noexcept { return verdict_; }

 private:
  friend struct ProtocolProbe;  // test/protocol looks inside to tell states apart
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
  const GateLimits* limits_;
  RobotAdaptor* adaptor_;
  SourceConfig config_;
  Handover handover_;
  CommandGate gate_;
  std::optional<Estimator> holder_estimate_;  // of the source that a settable standby follows
  std::optional<Estimator> own_estimate_;     // of hardware: is it statically stable?  And for stop plans
  std::int64_t estimated_tick_ = -1;

  RobotState state_;
  RobotState holder_state_;
  JointCommand holder_command_;
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

}  // namespace twinbus
