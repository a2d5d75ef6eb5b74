// One tick of Source: the state is admitted and filled in, the command is gated and written, what is heard in between.

#include "bridge/source/source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bridge/handover/switch_check.h"
#include "common/math/index.h"
#include "lcmtypes/msg/messages.h"
#include "robot/estimation/point_legs.h"

namespace twinbus::inline bridge {

namespace {

constexpr std::int64_t kAhead = 5;  // of the holder's newest state a command may be [ticks]
constexpr double kLead = 0.15;  // a standby ticks this much before STATE is due [periods]
constexpr double kPhaseGain = 0.1;
constexpr double kPhaseStep = 0.02;                     // largest correction per tick [periods]
constexpr std::int64_t kDeviceSilence_ns = 20'000'000;  // of read failures that is ridden out
constexpr std::int64_t kAnchorEvery_ns = 2'000'000'000;
constexpr double kAnchorBeyond = 0.1;  // [rad or m]
constexpr std::int64_t kRestRepeat_ns = 100'000'000;
constexpr double kZmpInside = 0.020;                   // [m]
constexpr double kComSlow = 0.02;                      // [m/s]
constexpr std::int64_t kSupportLasts_ns = 50'000'000;  // stable for so long before it counts
constexpr std::int64_t kControllerFresh_ns = 50'000'000;
constexpr std::int64_t kFollowAfter_ns = 500'000'000;  // a holder has walked
constexpr float kFootInAir = 30.0F;                    // [N]
constexpr double kLately = 2.0;        // what happened so long before a fall may have led to it [s]

// Infinity and NaN give NaN here, every other number zero.
bool finite(const RobotState& state, int joints) noexcept {
  double zero = 0.0;
  for (int j = 0; j < joints; ++j) {
    zero += (state.q[at(j)] - state.q[at(j)]) +
            static_cast<double>(state.qd[at(j)] - state.qd[at(j)]) +
            static_cast<double>(state.tau[at(j)] - state.tau[at(j)]);
  }
  for (const float x : state.attitude) zero += static_cast<double>(x - x);
  for (const float x : state.gyro) zero += static_cast<double>(x - x);
  for (const float x : state.accel) zero += static_cast<double>(x - x);
  for (const auto& wrench : state.wrench) {
    for (const float x : wrench) zero += static_cast<double>(x - x);
  }
  return zero == 0.0;
}

// Upward force of a foot that says so.
bool stands_on_one_foot(const RobotState& state) noexcept {
  for (const Limb foot : {kLeftFoot, kRightFoot}) {
    if (state.wrench_kind[at(foot)] != WrenchKind::kMeasured) return false;
  }
  return std::abs(state.wrench[kLeftFoot][2]) < kFootInAir ||
         std::abs(state.wrench[kRightFoot][2]) < kFootInAir;
}

}  // namespace

Source::Source(const Model& model, std::shared_ptr<const GateLimits> limits, RobotAdaptor& adaptor, const SourceConfig& config,
               const HandoverConfig& handover)
    : model_(&model),
      limits_(std::move(limits)),
      adaptor_(&adaptor),
      config_(config),
      handover_(handover),
      gate_(*limits_, config.guard_required, config.seed ^ static_cast<std::uint64_t>(config.run_id),
            handover.off),
      fall_(model) {
  if (stands_on_points(model) || (model.floating_base && model.soles[0].link >= 0 && model.soles[1].link >= 0)) {
    if (handover.can_be_set) holder_estimate_.emplace(model);
    own_estimate_.emplace(model);
  }
  state_.joint_count = static_cast<std::int16_t>(limits_->joint_count);
  // A simulator that is not active stands still in time, so that its first active tick is the same
  // whenever it comes.
  device_ok_ = adaptor_->read(state_, model.device_timeout) == Status::kOk &&
               finite(state_, limits_->joint_count);
  if (device_ok_) gate_.hold_measured(state_);
  fill_state();
  fill_status();
}

// Time-outs of the gate follow the steady clock; without a clock of its own (lock-step, free run)
// the state's time.
std::int64_t Source::gate_clock(std::int64_t now_ns) const noexcept {
  return config_.pace == Pace::kRealTime ? now_ns : handover_.time_ns;
}

HandoverInput Source::handover_input(std::int64_t now_ns) const noexcept {
  const StopLatch& latch = gate_.latch();
  return {.measured = &state_,
          .stop_kind = latch.kind,
          .stop_was_asked = latch.asked,
          .device_ok = device_ok_,
          .stable = stable_,
          .walking = walking(now_ns)};
}

bool Source::walking(std::int64_t now_ns) const noexcept {
  return controller_.mode == Mode::kWalk && controller_.run_id == config_.run_id &&
         now_ns - controller_ns_ <= 4 * kControllerFresh_ns;
}

// Its controller says so, or a foot of it is in the air while this robot's both stand.
bool Source::holder_walks(std::int64_t now_ns) const noexcept {
  if (controller_.run_id == handover_.holder && controller_.mode == Mode::kWalk &&
      now_ns - controller_ns_ <= 4 * kControllerFresh_ns)
    return true;
  return handover_.holder_fresh(now_ns) && stands_on_one_foot(holder_state_) &&
         !stands_on_one_foot(state_);
}

void Source::on_state(const RobotState& state, std::int64_t now_ns) noexcept {
  const std::int64_t tick_before = handover_.holder_tick;
  const std::int64_t holder_before = handover_.holder;
  handover_.heard_state(state, now_ns);
  if (handover_.holds_state() || state.run_id != handover_.holder) return;
  if (handover_.holder == holder_before && handover_.holder_tick == tick_before) return;
  holder_state_ = state;
  holder_arrival_ns_ = now_ns;
  holder_new_ = true;
  gate_.share_nonce(state.stop_nonce, state.stop_kind != StopKind::kNone);
}

void Source::on_standby_state(const RobotState& state, std::int64_t now_ns) noexcept {
  handover_.heard_standby(state, now_ns);
}

void Source::on_command(const JointCommand& command, std::int64_t now_ns) noexcept {
  if (handover_.role == Role::kStandbyTrack || handover_.role == Role::kParked) {
    if (command.run_id != handover_.holder || command.term != handover_.term) return;
    if (command.joint_count != limits_->joint_count || command.model_hash != limits_->model_hash)
      return;
    const bool follows = have_holder_command_ && holder_command_.run_id == command.run_id && holder_command_.term == command.term;
    if (command.tick > handover_.holder_tick + kAhead || (follows && command.tick <= holder_command_.tick)) return;
    holder_before_ = follows && holder_command_.controller_id == command.controller_id ? holder_command_ : command;
    holder_command_ = command;
    have_holder_command_ = true;
    return;
  }
  const std::int64_t tick = handover_.role == Role::kStandbyShadow
                                ? std::max(state_.tick, handover_.holder_tick)
                                : state_.tick;
  const bool late = written_ || command.tick < tick;
  verdict_ = gate_.accept(command, tick, late, gate_clock(now_ns));
}

void Source::on_stop_plan(const StopPlanPiece& piece, std::int64_t) noexcept {
  if (handover_.holds_state()) gate_.add_plan(piece, state_.tick);
}

void Source::on_source_request(const SourceRequest& request, std::int64_t now_ns) noexcept {
  handover_.request(request, handover_input(now_ns), now_ns);
}

void Source::on_controller_request(const ControllerRequest& request, std::int64_t) noexcept {
  if (request.run_id != config_.run_id || request.controller_id == 0 || !handover_.holds_state())
    return;
  gate_.rebind(request.controller_id);
}

void Source::on_stop(const StopRequest& stop, std::int64_t now_ns) noexcept {
  if (stop.kind == StopKind::kNone) {
    const StopKind before = gate_.latch().kind;
    if (!gate_.clear(stop.stop_nonce, gate_clock(now_ns))) return;
    if (before == StopKind::kOff || limp_) gate_.hold_measured(state_);
    limp_ = false;
    return;
  }
  // The active source asks for rest before it hands over; that is not a stop.
  const bool for_switch = stop.kind == StopKind::kBalanced && stop.reason == StopReason::kSwitch &&
                          (stop.sender_id == config_.run_id || stop.sender_id == handover_.holder);
  if (!for_switch) gate_.stop(stop, gate_clock(now_ns));
}

void Source::on_guard(const GuardReport& report, std::int64_t now_ns) noexcept {
  gate_.guard(report, gate_clock(now_ns));
}

void Source::on_controller_status(const ControllerStatus& status,
                                      std::int64_t now_ns) noexcept {
  const bool mine =
      status.run_id == config_.run_id && status.controller_id == gate_.controller_id();
  const bool of_holder = !handover_.holds_state() && status.run_id == handover_.holder;
  if (!mine && !of_holder) return;
  controller_ = status;
  controller_ns_ = now_ns;
}

bool Source::command_ready() const noexcept {
  if (!gate_.is_open() || gate_.latch().kind > StopKind::kBalanced) return true;
  return gate_.last_accepted_tick() >= state_.tick;
}

// A settable standby takes the active source's state as it is.
void Source::impose_holder() noexcept {
  ImposedState imposed;
  if (holder_estimate_.has_value()) {
    holder_estimate_->update(holder_state_);
    const Configuration& configuration = holder_estimate_->configuration();
    imposed.base = configuration.base;
    imposed.base_velocity = configuration.base_velocity;
    imposed.base_angular_velocity = configuration.base_angular_velocity;
  }
  for (int j = 0; j < limits_->joint_count; ++j) {
    imposed.q[at(j)] = holder_state_.q[at(j)];
    imposed.qd[at(j)] = static_cast<double>(holder_state_.qd[at(j)]);
    imposed.tau[at(j)] = holder_state_.tau[at(j)];
  }
  imposed.forces_known = holder_state_.wrench_kind[kLeftFoot] == WrenchKind::kMeasured &&
                         holder_state_.wrench_kind[kRightFoot] == WrenchKind::kMeasured;
  imposed.foot_wrench = {holder_state_.wrench[kLeftFoot], holder_state_.wrench[kRightFoot]};
  imposed_ = adaptor_->set_state(imposed) == Status::kOk;
}

// What the gate obeys in the role the source has now.
void Source::follow_role(std::int64_t now_ns) noexcept {
  if (handover_.role == Role::kStandbyShadow && handover_.holder != 0 && !aside_) {
    gate_.open(handover_.holder, handover_.term, false, limits_->blend_s, gate_clock(now_ns));
  } else {
    gate_.close();
  }
}

void Source::apply(Transition transition, std::int64_t now_ns) noexcept {
  switch (transition) {
    case Transition::kNone:
    case Transition::kGranted:
      return;
    case Transition::kActivated:
    case Transition::kCancelled:
      gate_.open(config_.run_id, handover_.term, true, limits_->blend_s, gate_clock(now_ns));
      return;
    case Transition::kTookOver: {
      // A settable source has just been, or is now, set to the holder's state; nothing is left to
      // fade.
      double blend_s = limits_->blend_s;
      if (handover_.config.can_be_set) {
        impose_holder();
        holder_new_ = false;
        if (imposed_) adopt_imposed();
        if (imposed_ && !gate_.wants_blend()) blend_s = 0.0;
      }
      gate_.open(config_.run_id, handover_.term, true, blend_s, gate_clock(now_ns));
      return;
    }
    case Transition::kNewHolder:
    case Transition::kReleased:
    case Transition::kStoodDown:
    case Transition::kGaveWay:
    case Transition::kStandby:
    case Transition::kParked:
      anchored_ns_ = now_ns;
      // Who was parked has heard it too: a client of 50 Hz may not speak again before the switch.
      have_holder_command_ = have_holder_command_ && handover_.role != Role::kStandbyShadow &&
                             holder_command_.run_id == handover_.holder && holder_command_.term == handover_.term;
      follow_role(now_ns);
      return;
  }
}

// A simulator stands still while it is parked, and while nothing is heard of the source it tracks.
bool Source::frozen(std::int64_t now_ns) const noexcept {
  if (!handover_.config.can_be_set) return false;
  if (handover_.role == Role::kParked) return true;
  return handover_.role == Role::kStandbyTrack && !handover_.holder_fresh(now_ns);
}

// Steps are feedback on feet that are another's: a robot that copied them would fall.  It holds its posture, and
// follows again when the holder stands as it stands itself.
void Source::stand_aside(std::int64_t now_ns) noexcept {
  if (handover_.role != Role::kStandbyShadow || handover_.config.can_be_set) {
    aside_ = false;
    return;
  }
  if (holder_walks(now_ns)) {
    walked_ns_ = now_ns;
    if (!aside_) gate_.close(true);
    aside_ = true;
  } else if (aside_ && now_ns - walked_ns_ >= kFollowAfter_ns && handover_.holder_fresh(now_ns) &&
             compare_measured(holder_state_, state_) == Refusal::kNone) {
    aside_ = false;
    follow_role(now_ns);
  }
}

// A shadow that can be set is set to what it shadows from time to time; one that cannot fades from
// where it is.
void Source::anchor(std::int64_t now_ns) noexcept {
  if (!holder_new_ || !handover_.holder_fresh(now_ns)) return;
  double gap = 0.0;
  for (int j = 0; j < limits_->joint_count; ++j) {
    gap = std::max(gap, std::abs(holder_state_.q[at(j)] - state_.q[at(j)]));
  }
  const bool far = !(gap <= kAnchorBeyond);
  if (!far && now_ns - anchored_ns_ < kAnchorEvery_ns) return;
  if (handover_.config.can_be_set) {
    impose_holder();
    anchored_ns_ = now_ns;
  } else if (!far) {
    anchored_ns_ = now_ns;
  } else if (now_ns - anchored_ns_ >= kAnchorEvery_ns && !aside_) {
    gate_.blend_again(limits_->blend_s);
    anchored_ns_ = now_ns;
  }
}

void Source::read_adaptor(std::int64_t now_ns) noexcept {
  if (frozen(now_ns)) return;
  if (handover_.role == Role::kStandbyTrack && holder_new_) impose_holder();
  if (handover_.role == Role::kStandbyShadow) {
    if (handover_.config.can_be_set && holder_estimate_.has_value() && holder_new_) {
      holder_estimate_->update(holder_state_);
    }
    anchor(now_ns);
  }
  holder_new_ = false;
  RobotState measured = state_;
  const Status status = adaptor_->read(measured, 0.5 * model_->period());
  const bool good = status == Status::kOk && finite(measured, limits_->joint_count);
  status_.adaptor_status = static_cast<std::int8_t>(status != Status::kOk ? status
                                                    : good                ? Status::kOk
                                                                          : Status::kNotFinite);
  if (good) {
    state_ = measured;
    gate_.measured(state_);
    good_read_ns_ = now_ns;
    device_ok_ = true;
    return;
  }
  if (now_ns - good_read_ns_ < kDeviceSilence_ns) return;
  device_ok_ = false;
  gate_.stop(StopKind::kHold, StopReason::kDevice, gate_clock(now_ns));
}

bool Source::estimate() noexcept {
  if (!handover_.config.hardware && !handover_.pending_switch && !gate_.plan().known(state_.tick)) return false;
  if (handover_.tick != estimated_tick_ + 1) own_estimate_->reset();
  estimated_tick_ = handover_.tick;
  own_estimate_->update(state_);
  return true;
}

// Hardware may be left, and hardware may take over from a walk that has ended, when the active source stands on both
// feet, ZMP well inside, CoM at rest.
void Source::watch_support(std::int64_t now_ns) noexcept {
  if (!own_estimate_.has_value() || !handover_.holds_state()) return;
  const bool estimated = estimate();
  if (!estimated || (!handover_.config.hardware && !handover_.pending_switch)) {
    support_since_ns_ = -1;
    stable_ = false;
    return;
  }
  const Estimator& own = *own_estimate_;
  double margin = own.support_margin(own.zmp());
  double speed = own.com_velocity().head<2>().norm();
  const bool fresh =
      controller_.run_id == config_.run_id && now_ns - controller_ns_ <= kControllerFresh_ns;
  if (fresh) {
    speed = std::hypot(static_cast<double>(controller_.com_velocity[0]),
                       static_cast<double>(controller_.com_velocity[1]));
  }
  if (own.loaded(0) && own.loaded(1) && margin >= kZmpInside && speed < kComSlow) {
    if (support_since_ns_ < 0) support_since_ns_ = now_ns;
    stable_ = now_ns - support_since_ns_ >= kSupportLasts_ns;
  } else {
    support_since_ns_ = -1;
    stable_ = false;
  }
}

// A robot that lies is let go, whatever its controller does, and obeys again when somebody has looked at it.
void Source::watch_for_a_fall(std::int64_t now_ns) noexcept {
  FallContext& c = fall_context_;
  const std::int64_t before_ns = std::exchange(began_ns_, now_ns);
  fall_.see_push(adaptor_->truth());
  if (!handover_.holds_state() || config_.kind == SourceKind::kReplay) return fall_.forget();
  const auto keep_worst = [now_ns](double seconds, double& worst, std::int64_t& at_ns) {
    if (seconds < worst && static_cast<double>(now_ns - at_ns) < kLately * 1e9) return;
    worst = seconds;
    at_ns = now_ns;
  };
  if (config_.pace == Pace::kRealTime) {
    const double slept = 1e-9 * static_cast<double>(now_ns - before_ns) - model_->period();
    keep_worst(before_ns != 0 ? slept : 0.0, c.slept, slept_at_ns_);
    const bool commanded = gate_.is_open() && gate_.commanded() && !gate_.latch().latched();
    const std::int64_t silent_ns = gate_clock(now_ns) - gate_.last_accepted_ns();
    keep_worst(commanded ? 1e-9 * static_cast<double>(silent_ns) : 0.0, c.silent, silent_at_ns_);
  }
  // `stop` without a stop is the brace of a robot that falls already.
  if (controller_.run_id == config_.run_id && controller_.mode != c.mode && controller_.mode != Mode::kStop) {
    c.mode = controller_.mode;
    mode_since_ns_ = now_ns;
  }
  c.mode_age = 1e-9 * static_cast<double>(now_ns - mode_since_ns_);
  c.stop = gate_.latch().kind;
  c.reason = gate_.latch().reason;
  c.plan_runs = gate_.plan().running();
  if (!device_ok_ || !fall_.look(state_, c)) return;
  fallen_ = true;
  gate_.stop(StopKind::kOff, StopReason::kFallen, gate_clock(now_ns));
}

bool Source::take_fall(std::array<char, 200>& cause) noexcept {
  if (!std::exchange(fallen_, false)) return false;
  cause = fall_.cause();
  return true;
}

void Source::begin_tick(std::int64_t now_ns) noexcept {
  if (!written_ && handover_.holds_state()) ++status_.ticks_missed;
  gate_.watch(gate_clock(now_ns));
  transition_ = handover_.begin_tick(handover_input(now_ns), now_ns);
  apply(transition_, now_ns);
  stand_aside(now_ns);
  if (handover_.holds_state() && !handover_.obeys() && gate_.is_open()) gate_.close();
  read_adaptor(now_ns);
  watch_support(now_ns);
  watch_for_a_fall(now_ns);
  written_ = false;
  fill_state();
  gate_.published(state_.tick);
  fill_status();
}

void Source::end_tick(std::int64_t now_ns) noexcept {
  if (written_) return;
  written_ = true;
  if (frozen(now_ns) || handover_.role == Role::kStandbyTrack || limp_) return;
  const bool walks = walking(now_ns);
  const StopKind before = gate_.latch().kind;
  const bool estimated = own_estimate_.has_value() && estimated_tick_ == state_.tick;
  const JointCommand& command =
      gate_.output(state_.tick, walks, gate_clock(now_ns), estimated ? &*own_estimate_ : nullptr);
  if (before == StopKind::kNone && gate_.latch().reason == StopReason::kCommandTimeout && walks && !gate_.held_after_plan()) {
    limp_ = adaptor_->fall_safe() == Status::kOk;  // nobody is left to place the next foot
    if (limp_) return;
  }
  Status status = adaptor_->write(command);
  if (!handover_.obeys()) {
    sensors_.reset();
  } else if (sensors_.look(state_, command, now_ns) && status == Status::kOk) {
    status = Status::kDeviceError;
  }
  if (status != Status::kOk) {
    status_.adaptor_status = static_cast<std::int8_t>(status);
    device_ok_ = false;
    gate_.stop(StopKind::kHold, StopReason::kDevice, gate_clock(now_ns));
  }
}

std::int64_t Source::next_tick_due_ns(std::int64_t last_due_ns) const noexcept {
  const std::int64_t next = last_due_ns + model_->period_ns;
  if (handover_.holds_state() || config_.pace != Pace::kRealTime) return next;
  if (!handover_.holder_fresh(last_due_ns)) return next;
  const double period = static_cast<double>(model_->period_ns);
  const double target = static_cast<double>(holder_arrival_ns_ - next) - kLead * period;
  const double error = std::remainder(target, period);
  return next +
         std::llround(std::clamp(kPhaseGain * error, -kPhaseStep * period, kPhaseStep * period));
}

StopRequest Source::take_stop_to_publish(std::int64_t now_ns) noexcept {
  StopRequest stop;
  if (!handover_.wants_rest || now_ns - rest_asked_ns_ < kRestRepeat_ns) return stop;
  rest_asked_ns_ = now_ns;
  stop.sender_id = config_.run_id;
  stop.sequence = ++rest_sequence_;
  stop.kind = StopKind::kBalanced;
  stop.reason = StopReason::kSwitch;
  return stop;
}

}  // namespace twinbus::bridge
