#include "bridge/gate/command_gate.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "robot/dynamics/pair_speed.h"
#include "robot/kinematics/brake.h"

namespace twinbus::inline bridge {

namespace {

constexpr double kRounding = 1e-6;  // of the range of a limit: what is nearer to it was not beyond it
constexpr double kSpoken = 0.02;    // of half the range of a limit; a smaller cut is counted only
constexpr int kMakesUp = 50;        // ticks of cut steps that are put down to a silence before them, at most
constexpr std::int64_t kBalancedStopLasts_ns = 2'000'000'000;
constexpr int kTicksWithoutStopping = 3;
constexpr double kTakeOver = 0.10;  // in which a stop plan takes the set-points over [s]
constexpr double kMotorHaste = 1.05;  // of its speed, that a set-point may turn a motor: as set_point_rate() of a joint
constexpr double kSoftTakeOver = 0.25;  // and from soft servos, which are far from it; not before the command timeout [s]
constexpr double kSoftReach = 1.0;      // from where the joints are [rad or m]
constexpr double kTakeBack = 0.15;  // and a controller again [s]
constexpr double kTorqueBack = 0.04;  // and its torques: what is kept of them longer tilts a robot that balances [s]
// Of its last command, within which the controller may go on; the controller itself gives up a little before.
constexpr double kResumesWithin = 0.21;  // [s]
constexpr std::int64_t kLater = 2;  // that a command may be late beyond what is usual, to end a stop plan [ticks]

// The checks of plans that a test has switched off.
std::uint8_t left_out(RuleSet off) noexcept {
  if (off == 0) return 0;
  std::uint8_t checks = 0;
  const auto without_rule = [&](Rule rule, PlanCheck check) {
    if (!holds(off, rule)) checks = static_cast<std::uint8_t>(checks | check);
  };
  without_rule(Rule::kPlanWhole, kCheckWhole);
  without_rule(Rule::kPlanUnmixed, kCheckUnmixed);
  without_rule(Rule::kPlanOrder, kCheckOrder);
  without_rule(Rule::kPlanSource, kCheckSource);
  without_rule(Rule::kPlanController, kCheckController);
  without_rule(Rule::kPlanAge, kCheckAge);
  return checks;
}

// Cuts value into [low, high]; 1 if it had to.  Numbers are finite here.
template <class T>
int cut(T& value, double low, double high) noexcept {
  const double x = static_cast<double>(value);
  if (x >= low && x <= high) return 0;
  value = static_cast<T>(x < low ? low : high);
  return 1;
}

}  // namespace

CommandGate::CommandGate(const GateLimits& limits, bool guard_required, std::uint64_t seed,
                         RuleSet off) noexcept
    : limits_(&limits), off_(off), guard_required_(guard_required), plan_(*limits.robot), latch_(seed) {
  client_.joint_count = effective_.joint_count = static_cast<std::int16_t>(limits.joint_count);
}

void CommandGate::hold_measured(const RobotState& state) noexcept {
  blend_.clear();
  for (int j = 0; j < limits_->joint_count; ++j) {
    const std::size_t i = at(j);
    effective_.q[i] = state.q[i];
    effective_.qd[i] = 0.0F;
    effective_.tau[i] = state.tau[i];
    cut(effective_.tau[i], -limits_->effort[i], limits_->effort[i]);
    effective_.kp[i] = limits_->kp[i];
    effective_.kd[i] = limits_->kd[i];
  }
  limits_->pairs.limit(state.q, effective_.tau);
  start_hold(false);
}

void CommandGate::adopt(const JointCommand& in_force, const JointCommand& client) noexcept {
  blend_.clear();
  effective_ = in_force;
  effective_.joint_count = static_cast<std::int16_t>(limits_->joint_count);
  start_hold(false);
  client_ = client;
  client_.flags = 0;
}

void CommandGate::open(std::int64_t run_id, std::int32_t term, bool watched, double blend_s,
                       std::int64_t now_ns) noexcept {
  open_ = true;
  watched_ = watched;
  run_id_ = run_id;
  term_ = term;
  controller_ = next_controller_ = 0;
  last_tick_ = -1;
  last_accepted_ns_ = guard_ns_ = now_ns;
  guard_tick_ = -1;
  have_client_ = fed_ = false;
  soft_ = 0;
  plan_.forget();
  blend_again(blend_s);
}

void CommandGate::close(bool stop_gains) noexcept {
  if (open_ && (!latch_.latched() || plan_.running())) start_hold(stop_gains || latch_.latched());
  plan_.forget();
  open_ = false;
  have_client_ = false;
}

void CommandGate::blend_again(double blend_s) noexcept {
  fade_next_ = true;
  next_blend_s_ = blend_s;
  next_torque_s_ = 0.0;
}

void CommandGate::rebind(std::int64_t controller_id) noexcept {
  if (controller_id != controller_) next_controller_ = controller_id;
}

GateVerdict CommandGate::judge(const JointCommand& command, std::int64_t tick) const noexcept {
  if (!open_) return GateVerdict::kClosed;
  if (command.run_id != run_id_ && holds(off_, Rule::kCommandRun)) return GateVerdict::kOtherRun;
  if (command.term != term_ && holds(off_, Rule::kCommandTerm)) return GateVerdict::kOtherTerm;
  if (controller_ != 0 && command.controller_id != controller_ &&
      command.controller_id != next_controller_ && holds(off_, Rule::kOneController)) {
    return GateVerdict::kOtherController;
  }
  if (command.tick <= last_tick_ && holds(off_, Rule::kCommandOrder)) return GateVerdict::kOldTick;
  const std::int64_t oldest = tick - limits_->command_timeout_ns / limits_->period_ns;
  if ((command.tick < oldest || command.tick > tick) && holds(off_, Rule::kCommandAge)) {
    return GateVerdict::kTooOld;
  }
  if (command.joint_count != limits_->joint_count) return GateVerdict::kWrongSize;
  if (command.model_hash != limits_->model_hash) return GateVerdict::kWrongModel;
  // Infinity minus itself and NaN minus itself are NaN, everything else gives zero.
  double zero = 0.0;
  for (int j = 0; j < limits_->joint_count; ++j) {
    const std::size_t i = at(j);
    const double floats = static_cast<double>(command.qd[i] - command.qd[i]) +
                          static_cast<double>(command.tau[i] - command.tau[i]) +
                          static_cast<double>(command.kp[i] - command.kp[i]) +
                          static_cast<double>(command.kd[i] - command.kd[i]);
    zero += (command.q[i] - command.q[i]) + floats;
  }
  if (!(zero == 0.0)) return GateVerdict::kNotFinite;
  // The answer to a state that was published before the stop cannot know of it.
  if (latch_.kind == StopKind::kBalanced && (command.flags & kCommandStopping) == 0 && command.tick > stop_tick_) {
    return GateVerdict::kStopped;
  }
  if (latch_.kind > StopKind::kBalanced && holds(off_, Rule::kStopShutsGate)) {
    return GateVerdict::kStopped;
  }
  return plan_.running() ? judge_resume(command, tick) : GateVerdict::kAccepted;
}

// The controller that was obeyed may go on soon after its last command; whoever comes later waits for the plan's end.
GateVerdict CommandGate::judge_resume(const JointCommand& command, std::int64_t tick) const noexcept {
  if (plan_.ended(tick)) return GateVerdict::kAccepted;
  const double silent = static_cast<double>(tick - fed_tick_) * limits_->period;
  const bool other = command.controller_id != controller_ && holds(off_, Rule::kPlanOtherWaits);
  const bool later = silent > kResumesWithin && holds(off_, Rule::kPlanResumeSoon);
  const bool stopped = !resumable_ && holds(off_, Rule::kPlanStopStays);
  if (other || stopped || later) return GateVerdict::kPlanRuns;
  if (command.tick < tick - usual_age_ - kLater && holds(off_, Rule::kPlanResumeNew)) return GateVerdict::kTooOld;  // made before it knew of the silence
  return GateVerdict::kAccepted;
}

PlanContext CommandGate::plan_context(std::int64_t tick) const noexcept {
  const bool soft = soft_ != 0 && measured_.known;
  return {.run_id = run_id_, .controller_id = controller_, .tick = tick, .term = term_,
          .from = soft ? &measured_.q : &effective_.q, .reach = soft ? kSoftReach : PlanAssembler::kReach,
          .left_out = left_out(off_)};
}

bool CommandGate::plan_ready(std::int64_t tick) const noexcept {
  return open_ && watched_ && have_client_ && plan_.ready(plan_context(tick));
}

void CommandGate::add_plan(const StopPlanPiece& piece, std::int64_t tick) noexcept {
  if (!open_ || !watched_ || (plan_.running() && holds(off_, Rule::kPlanKept))) return;
  const StopPlan* before = plan_.whole();
  const std::int32_t number = before != nullptr ? before->head.number : -1;
  const PlanRefusal refusal = plan_.add(piece, plan_context(tick));
  if (refusal != PlanRefusal::kNone) {
    plan_refusal_ = refusal;
    ++counters_.plans_refused;
  } else if (plan_.whole() != nullptr && plan_.whole()->head.number != number) {
    ++counters_.plans_accepted;
  }
}

void CommandGate::end_plan() noexcept {
  plan_.stop();
  blend_again(kTakeBack);
  next_torque_s_ = kTorqueBack;
}

// Decides whether a stop plan is followed this tick, and takes the set-points from it.
void CommandGate::follow_plan(std::int64_t tick, const Estimator* robot, std::int64_t now_ns) noexcept {
  const bool silent = have_client_ && !fed_ && !holding_ && latch_.kind <= StopKind::kBalanced;
  const bool soon = (tick - fed_tick_) * limits_->period_ns <= limits_->command_timeout_ns;
  const bool waits = soon && !plan_asked_ && (soft_ != 0 || !holds(off_, Rule::kPlanAtOnce));
  bool starts = false;
  if (!plan_.running() && (silent || plan_asked_) && !waits && plan_ready(tick)) {
    starts = true;
    if (!holds(off_, Rule::kPlanOtherWaits)) controller_ = 0;
    follow_stiffly();
    plan_.start(tick, robot);
    resumable_ = !plan_asked_;
    holding_ = false;
    ++counters_.plans_followed;
  }
  plan_asked_ = false;
  if (!plan_.running()) return;
  if (plan_.over(tick)) {
    plan_.stop();
    held_after_plan_ = true;
    if (latch_.kind >= StopKind::kHold || !holds(off_, Rule::kPlanEndLatches)) {
      start_hold(true);
    } else {
      stop(StopKind::kHold, StopReason::kCommandTimeout, now_ns);
    }
    return;
  }
  if (plan_.ended(tick)) controller_ = next_controller_ = 0;  // the first that speaks now
  plan_.set_points(tick, robot, client_);
  const double take_over = soft_ != 0 ? kSoftTakeOver : kTakeOver;
  if (starts) blend_.start(effective_, client_, plan_.joints() & limits_->all, limits_->period, take_over);
  // Joints that the plan does not move go on as they were commanded last, and are held from the time-out on.
  const std::int64_t others = limits_->all & ~plan_.joints();
  if (others == 0 || (tick - plan_.since()) * limits_->period_ns < limits_->command_timeout_ns) return;
  for (int j = 0; j < limits_->joint_count; ++j) {
    const std::size_t i = at(j);
    if ((others & bit(j)) == 0) continue;
    client_.kp[i] = limits_->stop_kp[i];
    client_.kd[i] = limits_->stop_kd[i];
    brake_step(limits_->brake[i], limits_->period, client_.q[i], client_.qd[i]);
  }
}

void CommandGate::measured(const RobotState& state) noexcept { measured_ = {true, state.q, state.qd}; }

// Nobody balances by soft servos any more: those of a stop, from where the joints are.
void CommandGate::follow_stiffly() noexcept {
  if (soft_ == 0 || !measured_.known) return;
  stiffen(measured_, limits_->stop_kp, limits_->stop_kd, soft_, effective_);
  client_ = effective_;
}

GateVerdict CommandGate::accept(const JointCommand& command, std::int64_t tick, bool late,
                                std::int64_t now_ns) noexcept {
  watch(now_ns);  // a process that slept finds its backlog too late
  const GateVerdict verdict = judge(command, tick);
  if (verdict != GateVerdict::kAccepted) {
    if (verdict == GateVerdict::kClosed) return verdict;
    ++counters_.rejected;
    refused_.add(verdict, command,
                 {run_id_, term_, controller_, last_tick_, tick, limits_->joint_count, limits_->model_hash});
    return verdict;
  }
  refused_.obeyed();
  ++counters_.accepted;
  if (late) ++counters_.late;
  if (next_controller_ != 0 && command.controller_id == next_controller_) {
    next_controller_ = 0;
    blend_again(limits_->blend_s);
  }
  if (plan_.running()) end_plan();
  controller_ = command.controller_id;
  last_tick_ = command.tick;
  last_accepted_ns_ = now_ns;
  fed_ = true;
  fed_tick_ = tick;
  usual_age_ = std::max<std::int64_t>(tick - command.tick, 0);
  held_after_plan_ = false;
  if ((command.flags & kCommandStopping) != 0) stopping_seen_ = true;
  if (fade_next_) {
    fade_next_ = false;
    // Nothing jumps without a fade either: a tick changes set-point and torque by their limits at most.
    if ((command.flags & kCommandNoFade) != 0) next_blend_s_ = next_torque_s_ = 0.0;
    blend_.start(effective_, command, limits_->all, late ? 0.0 : limits_->period, next_blend_s_, next_torque_s_);
  }
  client_ = command;
  soft_ = soft_joints(command, limits_->stop_kp, limits_->joint_count);
  have_client_ = true;
  holding_ = false;
  return verdict;
}

// The set-point of our own: from where it is to rest, torque as it is, gains as they are or those
// of a stop.
void CommandGate::start_hold(bool stop_gains) noexcept {
  blend_.clear();
  if (stop_gains) {
    const std::int64_t soft = soft_joints(effective_, limits_->stop_kp, limits_->joint_count);
    stiffen(measured_, limits_->stop_kp, limits_->stop_kd, soft, effective_);
  }
  client_ = effective_;
  client_.flags = 0;
  holding_ = true;
  fade_next_ = true;
  if (!(next_blend_s_ > 0.0)) next_blend_s_ = limits_->blend_s;
  if (!stop_gains) return;
  client_.kp = limits_->stop_kp;
  client_.kd = limits_->stop_kd;
  blend_.start(effective_, client_, limits_->all, 0.0, limits_->blend_s);  // gains fade
}

void CommandGate::stop(const StopRequest& request, std::int64_t now_ns) noexcept {
  const StopKind before = latch_.kind;
  if (latch_.stop(request, off_)) entered_stop(before, now_ns);
}

void CommandGate::stop(StopKind kind, StopReason reason, std::int64_t now_ns) noexcept {
  const StopKind before = latch_.kind;
  if (latch_.stop(kind, reason)) entered_stop(before, now_ns);
}

void CommandGate::entered_stop(StopKind before, std::int64_t now_ns) noexcept {
  if (latch_.kind <= before) return;
  stop_since_ns_ = now_ns;
  stop_tick_ = published_tick_;
  ticks_without_stopping_ = 0;
  stopping_seen_ = false;
  // A source that follows no controller of its own has nobody who could make a balanced stop.
  if (latch_.kind == StopKind::kBalanced && !(open_ && watched_)) latch_.kind = StopKind::kHold;
  if (latch_.kind == StopKind::kOff && holds(off_, Rule::kPlanOffEnds)) plan_.forget();
  resumable_ = resumable_ && latch_.kind < StopKind::kHold;
  if (latch_.kind != StopKind::kHold || plan_.running()) return;
  plan_asked_ = latch_.reason != StopReason::kDevice && plan_ready(tick_ + 1) && plan_.leads_away(effective_);
  if (!plan_asked_) start_hold(true);
}

bool CommandGate::clear(std::int32_t nonce, std::int64_t now_ns) noexcept {
  if (!latch_.clear(nonce, off_)) return false;
  held_after_plan_ = false;
  last_accepted_ns_ = now_ns;
  if (plan_.running()) return true;  // to its end first
  plan_asked_ = false;
  controller_ = next_controller_ = 0;
  have_client_ = false;
  if (!holding_) start_hold(false);
  blend_again(limits_->blend_s);
  return true;
}

void CommandGate::guard(const GuardReport& report, std::int64_t now_ns) noexcept {
  if (report.run_id != run_id_ || report.tick <= guard_tick_) return;
  guard_tick_ = report.tick;
  guard_ns_ = now_ns;
  guard_mask_ = report.hold_mask & limits_->all;
}

void CommandGate::watch(std::int64_t now_ns) noexcept {
  if (latch_.kind == StopKind::kBalanced && now_ns - stop_since_ns_ > kBalancedStopLasts_ns) {
    stop(StopKind::kHold, latch_.reason, now_ns);
  }
  if (open_ && watched_ && !latch_.latched() &&
      now_ns - last_accepted_ns_ >= limits_->command_timeout_ns && !plan_.running() && !plan_ready(tick_ + 1) &&
      holds(off_, Rule::kTimeoutStops)) {
    stop(StopKind::kHold, StopReason::kCommandTimeout, now_ns);
  }
}

std::int64_t CommandGate::mask_in_force(bool walking, std::int64_t now_ns) const noexcept {
  if (!open_) return 0;
  std::int64_t mask = guard_tick_ >= 0 ? guard_mask_ : 0;
  if (now_ns - guard_ns_ > limits_->guard_timeout_ns) {
    mask = guard_required_ ? (mask | limits_->arms) : 0;
  }
  return walking ? mask & ~limits_->legs : mask;
}

void CommandGate::off_command(JointCommand& command) const noexcept {
  command = effective_;
  command.qd.fill(0.0F);
  command.tau.fill(0.0F);
  command.kp.fill(0.0F);
  command.kd.fill(0.0F);
  if (limits_->damp_when_off) command.kd = limits_->stop_kd;
}

void CommandGate::limit(JointCommand& command) noexcept {
  using What = FirstCut::What;
  int cuts = 0;
  std::size_t i = 0;
  // Cuts value into [low, high]; from: what a step counts from.
  const auto within = [&](auto& value, What what, double low, double high, double from = 0.0) {
    const double asked = static_cast<double>(value);
    if (cut(value, low, high) == 0 || std::abs(asked - static_cast<double>(value)) <= kRounding * (high - low)) return;
    ++cuts;
    const bool step = what == What::kPositionStep || what == What::kTorqueStep;
    step_cut_ = step_cut_ || step;
    FirstCut& first = step && silent_ticks_ > 0 ? first_catch_up_ : first_cut_;
    if (first.what != What::kNone || std::abs(asked - static_cast<double>(value)) <= 0.5 * kSpoken * (high - low)) return;
    first = {what, static_cast<std::int16_t>(i), asked - from, static_cast<double>(value) - from, step ? silent_ticks_ : 0};
  };
  for (; i < static_cast<std::size_t>(limits_->joint_count); ++i) {
    const double q = effective_.q[i], tau = static_cast<double>(effective_.tau[i]);
    const double q_step = limits_->step[i], tau_step = kTorqueStep * limits_->effort[i];
    within(command.q[i], What::kPosition, limits_->lower[i], limits_->upper[i]);
    within(command.qd[i], What::kVelocity, -limits_->velocity[i], limits_->velocity[i]);
    within(command.tau[i], What::kTorque, -limits_->effort[i], limits_->effort[i]);
    within(command.kp[i], What::kStiffness, 0.0, static_cast<double>(limits_->kp_max[i]));
    within(command.kd[i], What::kDamping, 0.0, static_cast<double>(limits_->kd_max[i]));
    within(command.q[i], What::kPositionStep, q - q_step, q + q_step, q);
    within(command.tau[i], What::kTorqueStep, tau - tau_step, tau + tau_step, tau);
  }
  // Where two motors turn two joints: how fast these turn, and what they give at the measured posture.
  for (int j = 0; j < limits_->joint_count && !limits_->pairs.empty(); ++j) {
    const ParallelJoints* pair = limits_->pairs.with(limits_->robot->bus_joints[at(j)]);
    if (pair == nullptr || pair->joints[0] != limits_->robot->bus_joints[at(j)]) continue;
    const std::size_t first = at(j), second = at(limits_->robot->bus_index[at(pair->joints[1])]);
    Eigen::Vector2d to(command.q[first], command.q[second]);
    Eigen::Vector2d qd(static_cast<double>(command.qd[first]), static_cast<double>(command.qd[second]));
    if (!limit_speed(*pair, {effective_.q[first], effective_.q[second]}, limits_->period, kMotorHaste, to, qd)) continue;
    ++cuts;
    command.q[first] = to[0];
    command.q[second] = to[1];
    command.qd[first] = static_cast<float>(qd[0]);
    command.qd[second] = static_cast<float>(qd[1]);
  }
  const auto& posture = measured_.known ? measured_.q : command.q;
  limits_->pairs.limit(posture, command.tau, [&](std::size_t joint, double asked, double given) {
    const double limit = limits_->effort[joint];
    if (std::abs(asked - given) <= kRounding * limit) return;
    ++cuts;
    if (first_cut_.what == FirstCut::What::kNone && std::abs(asked - given) > kSpoken * limit)
      first_cut_ = {FirstCut::What::kTorque, static_cast<std::int16_t>(joint), asked, given, 0};
  });
  counters_.clamped += cuts;
}

// The set-point stands still without commands; the next one asks for the way of all those ticks at once, which the limit
// of a step spreads over some ticks.
void CommandGate::count_silence(bool silent) noexcept {
  if (silent) {
    ++silent_ticks_;
    made_up_ = 0;
  } else if (!step_cut_ || ++made_up_ > kMakesUp) {
    silent_ticks_ = 0;
  }
  step_cut_ = false;
}

const JointCommand& CommandGate::output(std::int64_t tick, bool walking,
                                        std::int64_t now_ns, const Estimator* robot) noexcept {
  watch(now_ns);
  if (latch_.kind == StopKind::kBalanced) {
    ticks_without_stopping_ = stopping_seen_ ? 0 : ticks_without_stopping_ + 1;
    if (ticks_without_stopping_ >= kTicksWithoutStopping)
      stop(StopKind::kHold, latch_.reason, now_ns);
  }
  stopping_seen_ = false;
  if (!holds(off_, Rule::kStopLatches)) latch_.clear(latch_.nonce);

  if (open_ && watched_) follow_plan(tick, robot, now_ns);
  const bool silent = have_client_ && !fed_ && !holding_;
  fed_ = false;
  tick_ = tick;
  JointCommand command;
  if (latch_.kind == StopKind::kOff) {
    off_command(command);
  } else {
    if (holding_) {
      for (int j = 0; j < limits_->joint_count; ++j) {
        brake_step(limits_->brake[at(j)], limits_->period, client_.q[at(j)], client_.qd[at(j)]);
      }
    }
    const std::int64_t mask = holding_ ? 0 : mask_in_force(walking || plan_.walks(), now_ns);
    const MaskedBrake::Released released = brake_.hold(mask, *limits_, client_, measured_, effective_);
    blend_.active &= ~released.at_once;
    if (released.faded != 0) blend_.start(effective_, client_, released.faded, limits_->period, limits_->blend_s);
    command = client_;
    blend_.advance_and_apply(limits_->period, limits_->joint_count, command);
    brake_.apply(*limits_, effective_, command);
    limit(command);
  }
  count_silence(silent);
  command.tick = tick;
  command.run_id = run_id_;
  command.term = term_;
  command.controller_id = controller_;
  command.model_hash = limits_->model_hash;
  command.joint_count = static_cast<std::int16_t>(limits_->joint_count);
  effective_ = command;
  return effective_;
}

}  // namespace twinbus::bridge
