// The last code before a motor: doc/style.md section 8, the same in simulation and reality.
//
// Commands come in by accept(), stops by stop(); once per tick output() gives what is written to
// the adaptor.  A command is refused whole before anything in it is clamped, because clamping NaN
// gives NaN.  The gate always has an effective set-point of its own; a client's commands are faded
// in from it (OffsetBlend).  Copyable: the protocol explorer clones it.

#pragma once

#include <cstdint>

#include "bridge/gate/blend.h"
#include "bridge/gate/gate_limits.h"
#include "bridge/gate/masked_brake.h"
#include "bridge/gate/plan_run.h"
#include "bridge/gate/refused_command.h"
#include "bridge/gate/soft_servos.h"
#include "bridge/handover/rules.h"
#include "bridge/gate/stop_latch.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus {
struct ProtocolProbe;
}  // namespace twinbus

namespace twinbus::inline bridge {

struct GateCounters {
  std::int64_t accepted = 0, rejected = 0, late = 0;
  std::int64_t clamped = 0;  // numbers cut to a limit
  std::int64_t plans_accepted = 0, plans_refused = 0, plans_followed = 0;
};

// The first number of a command that was cut to a limit by more than a fiftieth of it, for people.
struct FirstCut {
  enum class What : std::int8_t { kNone, kPosition, kVelocity, kTorque, kStiffness, kDamping, kPositionStep, kTorqueStep };
  What what = What::kNone;
  std::int16_t joint = -1;  // index on the bus
  double asked = 0.0, given = 0.0;  // in the unit of what; of steps: the change in one tick
  std::int64_t silent = 0;  // ticks without a command before it
};

class CommandGate {
 public:
  // limits must outlive the gate.
  CommandGate(const GateLimits& limits, bool guard_required, std::uint64_t seed,
              RuleSet off = 0) noexcept;

  // The set-point becomes the measured posture with the model's gains, at rest.
  void hold_measured(const RobotState& state) noexcept;
  // The set-point becomes a command that was in force on another source (a state was imposed with it), and moves on to
  // the client's.
  void adopt(const JointCommand& in_force, const JointCommand& client) noexcept;

  // Obeys commands that name this run and term, from the first controller that speaks; its first
  // command is faded in over blend_s.  watched: silence for the command timeout, counted from
  // now_ns, stops.
  void open(std::int64_t run_id, std::int32_t term, bool watched, double blend_s,
            std::int64_t now_ns) noexcept;
  // Obeys nobody: brings the set-point to rest and holds it, with its gains or those of a stop.
  void close(bool stop_gains = false) noexcept;
  // The next command is faded in again.
  void blend_again(double blend_s) noexcept;
  // Another controller may take the place of the bound one; it does with its first good command,
  // faded in.
  void rebind(std::int64_t controller_id) noexcept;

  // tick: of the state that was published last.  late: its set-point has already been written.
  GateVerdict accept(const JointCommand& command, std::int64_t tick, bool late,
                     std::int64_t now_ns) noexcept;
  // A piece of a stop plan.  A whole one that fits is followed from the first tick without a command, and through a hold.
  void add_plan(const StopPlanPiece& piece, std::int64_t tick) noexcept;
  void stop(const StopRequest& request, std::int64_t now_ns) noexcept;
  void stop(StopKind kind, StopReason reason, std::int64_t now_ns) noexcept;
  // True if the stop is cleared; the client is faded in again.
  bool clear(std::int32_t nonce, std::int64_t now_ns) noexcept;
  void share_nonce(std::int32_t nonce, bool stopped) noexcept { latch_.share(nonce, stopped); }
  void guard(const GuardReport& report, std::int64_t now_ns) noexcept;

  // What the robot measures in this tick; holds, brakes and stop plans of soft servos begin there.
  void measured(const RobotState& state) noexcept;
  // The state of this tick is out, with the stop that is known by now.
  void published(std::int64_t tick) noexcept { published_tick_ = tick; }

  // Time-outs; before output() and before the role of a tick is decided.
  void watch(std::int64_t now_ns) noexcept;
  // Once per tick: the set-point to write.  walking: the guard may not brake the legs.  robot: its estimate of this tick,
  // for the balance of a stop plan; null: there is none.
  const JointCommand& output(std::int64_t tick, bool walking, std::int64_t now_ns,
                             const Estimator* robot = nullptr) noexcept;

  const JointCommand& effective() const noexcept { return effective_; }
  const StopLatch& latch() const noexcept { return latch_; }
  const GateCounters& counters() const noexcept { return counters_; }
  const RefusedCommand& refused() const noexcept { return refused_; }  // the last one
  const FirstCut& first_cut() const noexcept { return first_cut_; }
  // The first step of a set-point that had ticks without a command to make up for.
  const FirstCut& first_catch_up() const noexcept { return first_catch_up_; }
  std::int64_t controller_id() const noexcept { return controller_; }
  std::int64_t last_accepted_ns() const noexcept { return last_accepted_ns_; }
  std::int64_t last_accepted_tick() const noexcept { return last_tick_; }
  std::int64_t masked() const noexcept { return brake_.joints(); }  // bit per joint
  bool is_open() const noexcept { return open_; }
  bool commanded() const noexcept { return have_client_; }  // a command was accepted since open()
  bool wants_blend() const noexcept { return fade_next_ && next_blend_s_ > 0.0; }
  bool blending() const noexcept { return blend_.active != 0; }
  // Share of the bound controller in what is obeyed: 0 nobody is obeyed yet, or a hold or a stop plan is .. 1 its commands act
  // as they are.
  float faded_in() const noexcept {
    return have_client_ && !holding_ && !plan_.running() ? blend_.share_of_client() : 0.0f;
  }
  const PlanRun& plan() const noexcept { return plan_; }
  PlanRefusal plan_refusal() const noexcept { return plan_refusal_; }  // of the last plan refused
  // The hold in force came at the end of a stop plan.
  bool held_after_plan() const noexcept { return held_after_plan_; }

 private:
  friend struct twinbus::ProtocolProbe;  // test/protocol looks inside to tell states apart
  GateVerdict judge(const JointCommand& command, std::int64_t tick) const noexcept;
  PlanContext plan_context(std::int64_t tick) const noexcept;
  bool plan_ready(std::int64_t tick) const noexcept;
  GateVerdict judge_resume(const JointCommand& command, std::int64_t tick) const noexcept;
  void end_plan() noexcept;
  void follow_plan(std::int64_t tick, const Estimator* robot, std::int64_t now_ns) noexcept;
  void entered_stop(StopKind before, std::int64_t now_ns) noexcept;
  void start_hold(bool stop_gains) noexcept;
  void follow_stiffly() noexcept;
  void off_command(JointCommand& command) const noexcept;
  void limit(JointCommand& command) noexcept;
  void count_silence(bool silent) noexcept;
  std::int64_t mask_in_force(bool walking, std::int64_t now_ns) const noexcept;

  const GateLimits* limits_;
  RuleSet off_;
  bool guard_required_;
  bool open_ = false;
  bool watched_ = false;
  bool have_client_ = false;  // client_ is a command of the present client
  bool fade_next_ = false;    // the next accepted command starts a blend
  bool holding_ = true;       // client_ is a hold of our own
  double next_blend_s_ = 0.0, next_torque_s_ = 0.0;
  std::int64_t run_id_ = 0;
  std::int64_t controller_ = 0;
  std::int64_t next_controller_ = 0;
  std::int64_t last_tick_ = -1;
  std::int64_t last_accepted_ns_ = 0;
  std::int64_t stop_since_ns_ = 0;
  std::int64_t guard_ns_ = 0;  // of the last report, or of open()
  std::int64_t guard_tick_ = -1;
  std::int64_t guard_mask_ = 0;
  std::int32_t term_ = 0;
  std::int32_t ticks_without_stopping_ = 0;
  bool stopping_seen_ = false;  // this tick
  bool fed_ = false;            // a command was accepted since the last output
  bool plan_asked_ = false;     // a hold is to be reached along the plan
  bool held_after_plan_ = false;
  bool resumable_ = true;          // the plan that is followed has met no stop
  std::int64_t tick_ = -1;         // of the last output
  std::int64_t published_tick_ = -1, stop_tick_ = -1;  // the newest state that is out, and that was when the stop came
  std::int64_t fed_tick_ = -1;     // of the source, when the last command was accepted
  std::int64_t usual_age_ = 0;     // of that command then [ticks]
  PlanRun plan_;
  PlanRefusal plan_refusal_ = PlanRefusal::kNone;
  StopLatch latch_;
  GateCounters counters_;
  RefusedCommand refused_;
  FirstCut first_cut_, first_catch_up_;
  std::int64_t silent_ticks_ = 0;  // whose way the set-point has not made up for
  int made_up_ = 0;                // ticks with cut steps since
  bool step_cut_ = false;          // in this tick
  JointCommand client_;     // what is asked for, by the client or by our own hold
  JointCommand effective_;  // what was written last
  OffsetBlend blend_;
  MeasuredJoints measured_;
  std::int64_t soft_ = 0;   // bit per joint whose servo the obeyed controller wants far softer than that of a stop
  MaskedBrake brake_;
};

}  // namespace twinbus::bridge
