#include "control/loop/control_loop.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/math/index.h"
#include "control/guard/guard.h"
#include "control/guard/hold_words.h"
#include "control/loop/blend.h"
#include "control/loop/control_report.h"
#include "control/loop/driver_token.h"
#include "control/loop/footstep_shapes.h"
#include "control/loop/mask_brake.h"
#include "control/loop/mode_queue.h"
#include "control/loop/modes.h"
#include "control/loop/set_point_limits.h"
#include "control/loop/state_check.h"
#include "lcmtypes/msg/obeyed_once.h"
#include "robot/description/walking_config.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline control {

namespace {
constexpr double kModeBlend = 0.5;        // [s] between the set-points of two modes
constexpr double kLean = 0.04;            // [m] at full stick
constexpr double kCrouch = 0.10;          // [m] at full trigger
constexpr double kGamepadTimeout = 0.25;  // [s]
constexpr std::int64_t kMostTicks = 5;    // that a step of time may be worth
constexpr double kSameMotion = 1.0;       // [s] in which another source may go on with the motion
constexpr std::int64_t kHandOver = 16;    // ticks that both sources of a switch may publish
constexpr double kMostWalkTimeout = 2.0;  // [s]
constexpr double kPadShare = 0.8;         // of the fastest walk, at full stick
constexpr double kLook = 0.3;             // [s] in which a robot at rest finds out what is up
constexpr double kResumesWithin = 0.2;    // of the first tick without a command, a motion is taken up again [s]
constexpr std::int64_t kSilentTicks = 5;  // without a command, from when on the robot was led by its stop plan
constexpr double kSentNear = 0.1;         // [rad] of the plan, that a set-point of a follower can be
constexpr const char* kInsane = "a state that no robot can be in was ignored";

// Of the plans of a controller; another one's are others.
std::int32_t first_number(std::int64_t controller_id) noexcept {
  const std::uint64_t mixed = static_cast<std::uint64_t>(controller_id) * 0x9e3779b97f4a7c15ULL;
  return static_cast<std::int32_t>(mixed >> 36);
}

double axis(float a) noexcept { return std::clamp(static_cast<double>(a), -1.0, 1.0); }

}  // namespace

struct ControlLoop::Impl {
  Impl(const Model& m, const ControlConfig& c);

  bool step(std::int64_t now_ns, JointCommand& out) noexcept;
  void first_state() noexcept;
  void next_state(bool same_source, bool again) noexcept;
  void compute(std::int64_t now_ns, double dt, bool same_source) noexcept;
  void obey_requests() noexcept;
  void look_again(std::int64_t now_ns) noexcept;
  bool pad_speaks(std::int64_t now_ns) const noexcept;
  Eigen::Vector3d lean(std::int64_t now_ns) const noexcept;
  Eigen::Vector3d walk_velocity(std::int64_t now_ns) const noexcept;
  void guard_and_mask(std::int64_t now_ns, double dt) noexcept;
  void write(JointCommand& out) const noexcept;
  bool goes_on() const noexcept;
  bool computed_already() const noexcept;
  bool was_led() const noexcept;
  bool resume() noexcept;
  Moment now() const noexcept { return {state, estimator, have_output ? &last : nullptr}; }

  const Model& model;
  ControlConfig config;
  Estimator estimator;
  std::int64_t look = 0;      // ticks in which the robot holds first, and finds its attitude
  std::int64_t obeys_at = 0;  // tick from which on it obeys
  bool begins = false;        // the first mode is still to come
  Modes modes;
  Blend blend;
  MaskBrake brake;
  SetPointLimits limits;
  StopPlanner planner;
  StateCheck check;
  std::unique_ptr<Guard> guard;
  ModeQueue requests;
  std::int64_t legs = 0;      // bit per joint: never masked
  std::int64_t measured = 0;  // bit per joint whose last set-point was what is measured

  RobotState state;
  bool have_state = false, have_output = false;
  std::int64_t answered_tick = -1, answered_run = 0, previous_run = 0;
  std::int64_t looked_run = 0;  // the source whose states were answered without time going on
  std::int32_t answered_term = 0;
  bool plan_runs = false;  // the source follows a stop plan, and no one may take the robot over
  Eigen::VectorXd resumed_q, resumed_qd;  // [joint_count]
  SetPoint want, last;
  JointCommand command;

  StopKind stop_heard = StopKind::kNone;
  bool switch_heard = false;  // a stop that comes before a switch
  Gamepad gamepad;
  DriverToken token;
  std::int64_t gamepad_ns = 0;
  WalkCommand walk;
  std::int64_t walk_ns = 0;
  StepList steps;
  bool new_steps = false;
  // Streams, too: what a sender has said before is from a log.
  SenderSequences<64> steps_heard, walks_heard, pads_heard;
  GuardReport guard_heard;
  bool guard_speaks = false;  // of this run, not long ago
  std::int64_t guard_heard_ns = 0;
  std::int64_t mask = 0;  // bit per joint held this tick
  HoldWords hold_words;
  const char* sentence = nullptr;
  ControllerStatus status;
};

ControlLoop::Impl::Impl(const Model& m, const ControlConfig& c)
    : model(m),
      config(c),
      estimator(m),
      modes(m, c.gains, WalkGains{}),
      blend(m.bus_count()),
      brake(m),
      limits(m),
      planner(m, modes.any_walk(), first_number(c.controller_id)),
      check(m),
      hold_words(m) {
  if (m.bus_count() < 1 || m.bus_count() > kMaxJoints) {
    throw std::runtime_error("robot " + m.name + " has " + std::to_string(m.bus_count()) +
                             " actuated joints; the bus carries 1 to " + std::to_string(kMaxJoints));
  }
  if (c.guard_in_loop) guard = std::make_unique<Guard>(m, GuardConfig{.guard_id = c.controller_id});
  for (int leg_joint : m.leg_joints) {
    for (int k = 0; k < m.bus_count(); ++k) {
      if (m.bus_joints[at(k)] == leg_joint) legs |= std::int64_t{1} << k;
    }
  }
  resumed_q = resumed_qd = Eigen::VectorXd::Zero(m.joint_count());
  status.controller_id = c.controller_id;
  const bool own_attitude = m.walking.own_attitude;
  estimator.estimate_attitude(own_attitude);
  if (own_attitude) look = std::llround(kLook / m.period());
}

void ControlLoop::Impl::first_state() noexcept {
  estimator.reset();
  estimator.update(state);
  obeys_at = state.tick + look;
  begins = look > 0;
  have_output = false;
  brake.reset();
  blend.cancel();
  if (guard != nullptr) guard->reset();
  modes.start(look > 0 ? Mode::kHold : config.first_mode, now());
}

void ControlLoop::Impl::next_state(bool same_source, bool again) noexcept {
  estimator.update(state, again);
  if (same_source) return;
  modes.rebase();
  if (guard != nullptr) guard->reset();
}

// A switch goes on where the last source was; a source that was started anew does not.
bool ControlLoop::Impl::goes_on() const noexcept {
  const std::int64_t ticks = state.tick - answered_tick;
  return answered_tick >= 0 && ticks >= 0 &&
         static_cast<double>(ticks) * model.period() <= kSameMotion;
}

// The old source goes on until it sees its successor, so both publish the ticks between.  Time goes on once in each:
// twice, the motion would run ahead of the robot; taken for a source started anew, it would end.
bool ControlLoop::Impl::computed_already() const noexcept {
  const std::int64_t behind = answered_tick - state.tick;
  return answered_tick >= 0 && behind >= 0 && behind < kHandOver && state.tick > kHandOver;
}

bool ControlLoop::Impl::pad_speaks(std::int64_t now_ns) const noexcept {
  return gamepad_ns != 0 && static_cast<double>(now_ns - gamepad_ns) < kGamepadTimeout * 1e9 &&
         gamepad.connected && gamepad.deadman && gamepad.run_id == state.run_id;
}

// The stick leans the body, the trigger lowers it, as long as the pad is held.
Eigen::Vector3d ControlLoop::Impl::lean(std::int64_t now_ns) const noexcept {
  if (!pad_speaks(now_ns)) return Eigen::Vector3d::Zero();
  const double crouch = std::max({0.0, axis(gamepad.right_trigger), -axis(gamepad.right_y)});
  return {kLean * axis(gamepad.left_y), kLean * axis(gamepad.left_x), -kCrouch * crouch};
}

// A WALK command counts for its time-out; else the pad's sticks ask for shares of what the robot can.
Eigen::Vector3d ControlLoop::Impl::walk_velocity(std::int64_t now_ns) const noexcept {
  const double timeout = std::clamp(static_cast<double>(walk.timeout), 0.0, kMostWalkTimeout);
  // One for the last source still counts for its time: a switch does not end a walk.
  const bool meant = walk.run_id == state.run_id || walk.run_id == previous_run;
  if (walk_ns != 0 && meant && static_cast<double>(now_ns - walk_ns) < timeout * 1e9) {
    return Eigen::Vector3d(static_cast<double>(walk.vx), static_cast<double>(walk.vy), static_cast<double>(walk.wz));
  }
  if (!pad_speaks(now_ns)) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d share(axis(gamepad.left_y), axis(gamepad.left_x), axis(gamepad.right_x));
  return kPadShare * share.cwiseProduct(modes.most_velocity());
}

void ControlLoop::Impl::guard_and_mask(std::int64_t now_ns, double dt) noexcept {
  if (guard != nullptr) write(command);  // what is asked, before any mask
  mask = guard != nullptr ? guard->check(state, &command, estimator).hold_mask : 0;
  const bool fresh = guard_heard_ns != 0 && static_cast<double>(now_ns - guard_heard_ns) < model.guard_timeout * 1e9;
  guard_speaks = fresh && guard_heard.run_id == state.run_id;
  if (guard_speaks) {
    mask |= guard_heard.hold_mask;
    status.guard_tick = guard_heard.tick;
  }
  mask &= ~legs;
  brake.apply(want, mask, dt);
}

void ControlLoop::Impl::write(JointCommand& out) const noexcept {
  out.tick = state.tick;
  out.run_id = state.run_id;
  out.model_hash = state.model_hash;
  out.controller_id = config.controller_id;
  out.term = state.term;
  out.joint_count = static_cast<std::int16_t>(model.bus_count());
  out.flags = modes.stopping() ? kCommandStopping : std::int16_t{0};
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = at(k);
    out.q[i] = want.q[i];
    out.qd[i] = static_cast<float>(want.qd[i]);
    out.tau[i] = static_cast<float>(want.tau[i]);
    out.kp[i] = static_cast<float>(want.kp[i]);
    out.kd[i] = static_cast<float>(want.kd[i]);
  }
}

void ControlLoop::Impl::obey_requests() noexcept {
  if (std::exchange(begins, false) && state.role == Role::kActive) {
    ModeRequest first;
    first.mode = config.first_mode;
    modes.obey(first, now());
  }
  while (const ModeRequest* request = requests.take(state.tick)) {
    status.mode_sequence = request->sequence;
    modes.obey(*request, now());
  }
}

// Whether commands were missing for so long that the stop plan has led the robot.
bool ControlLoop::Impl::was_led() const noexcept {
  return state.plan_number != 0 &&
         (state.tick - answered_tick > 1 || state.tick - state.plan_tick >= kSilentTicks);
}

// Takes up the motion where a stop plan of ours has led it meanwhile.  False: nobody may, before the plan has ended.
bool ControlLoop::Impl::resume() noexcept {
  const StopPlan* plan = planner.plan(state.plan_number);
  const auto silent = static_cast<double>(state.tick - state.plan_tick) * model.period();
  if (plan == nullptr || !(silent <= kResumesWithin) || state.stop_kind != StopKind::kNone) return false;
  if (!plan->head.walks) {
    if (modes.point_feet() != nullptr) {  // its feet are not where it left them
      have_output = false;
      blend.cancel();
      modes.resume();
    }
    return true;
  }
  const Walk* foreseen = modes.walk() != nullptr ? planner.walk_at(state.plan_number, state.tick - 1) : nullptr;
  if (foreseen == nullptr) return false;
  // What the source wrote last is not heard, but the servos' torques show it.
  PlanJoints planned;
  joints_at(*plan, state.tick - 1, model.period(), planned);
  Eigen::VectorXd& q = resumed_q;
  Eigen::VectorXd& qd = resumed_qd;
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = at(k);
    const double kp = last.kp[i], kd = last.kd[i];
    double sent = planned.q[i];
    if (((legs >> k) & 1) != 0 && kp > 0.0) {
      const double servo = static_cast<double>(state.tau[i]) - planned.tau[i] -
                           kd * (planned.qd[i] - static_cast<double>(state.qd[i]));
      sent = std::clamp(state.q[i] + servo / kp, sent - kSentNear, sent + kSentNear);
    }
    last.q[i] = q[model.bus_joints[i]] = sent;
    last.qd[i] = qd[model.bus_joints[i]] = planned.qd[i];
    last.tau[i] = planned.tau[i];
  }
  std::array<bool, 2> stands;
  std::array<Eigen::Vector2d, 2> place;
  std::array<double, 2> yaw;
  for (int f = 0; f < 2; ++f) {
    const Foothold& foot = foreseen->pattern().foot(f);
    stands[at(f)] = !foreseen->pattern().swings(f);
    place[at(f)] = foot.position;
    yaw[at(f)] = foot.yaw();
  }
  estimator.resume(stands, place, yaw);
  if (guard != nullptr) guard->reset();  // it foretells from set-points that were not
  modes.resume_walk(*foreseen, q, qd);
  answered_tick = state.tick - 1;
  return true;
}

void ControlLoop::Impl::compute(std::int64_t now_ns, double dt, bool same_source) noexcept {
  modes.watch_for_a_fall(now());
  const bool for_switch = std::exchange(switch_heard, false);
  if (modes.follow_stop(std::exchange(stop_heard, StopKind::kNone), for_switch, plan_runs, now())) {
    blend.cancel();
    brake.reset();
    have_output = false;
  }
  if (state.tick >= obeys_at) obey_requests();
  modes.lean(lean(now_ns));
  modes.walk(walk_velocity(now_ns));
  if (std::exchange(new_steps, false)) modes.walk_steps(steps);
  modes.want(now(), mask, dt, want);
  const std::int64_t follows = modes.measured();
  if (modes.take_change() && have_output) blend.start(last, want, follows | measured, kModeBlend);
  measured = follows;
  blend.apply(want, dt);
  guard_and_mask(now_ns, dt);
  const Posture::Held held = modes.take_held();
  const char* why = hold_words.tell(held.waits, held.given_up, guard.get(), guard_speaks ? &guard_heard : nullptr, state.tick);
  if (why != nullptr) sentence = why;
  // Set-points that follow what is measured begin anew where another robot is; its gate fades them in.
  limits.apply(state, same_source ? now().last : nullptr, dt, want);
  last = want;
  have_output = true;
}

// A tick that the last source has published already, of another robot.  Steps go on as they are; legs that balance are
// where they are measured: told to be where the other robot's are, they would pull this one over while its gate fades.
void ControlLoop::Impl::look_again(std::int64_t now_ns) noexcept {
  if (modes.walk() != nullptr || modes.point_feet() != nullptr || !have_output || !check.is_sane(state)) return;
  next_state(std::exchange(looked_run, state.run_id) == state.run_id, true);
  modes.want(now(), mask, 0.0, want);
  blend.apply(want, 0.0);
  guard_and_mask(now_ns, 0.0);
  limits.apply(state, nullptr, 0.0, want);
  last = want;
}

bool ControlLoop::Impl::step(std::int64_t now_ns, JointCommand& out) noexcept {
  if (!have_state) return false;
  if (state.role != Role::kActive && state.role != Role::kReleasing && state.role != Role::kStopped) return false;
  const bool same_source = state.run_id == answered_run && state.term == answered_term;
  if (same_source && state.tick == answered_tick) {
    out = command;
    return true;
  }
  if (!same_source && computed_already()) {
    look_again(now_ns);
    write(command);
    out = command;
    return true;
  }
  const bool sane = check.is_sane(state);
  const bool first = answered_tick < 0 || (!same_source && !goes_on());
  if (first && !sane) return false;
  const bool was_running = plan_runs;
  const bool led = !first && sane && was_led();
  plan_runs = (first && state.plan_number != 0) || (led && !resume());
  double dt = model.period();
  if (first || (plan_runs && !was_running)) {  // what it knew of the robot is no longer so
    first_state();
  } else {
    dt *= static_cast<double>(std::clamp<std::int64_t>(state.tick - answered_tick, 1, kMostTicks));
    if (sane) next_state(same_source, false);
  }
  if (!same_source) previous_run = answered_run;
  answered_run = state.run_id;
  answered_term = state.term;
  answered_tick = state.tick;
  looked_run = 0;
  if (sane) {
    compute(now_ns, dt, same_source);
  } else {
    sentence = kInsane;
    last.qd.fill(0.0);
    want = last;
  }
  write(command);
  if (plan_runs || led) {  // the plan that is followed is needed until a command is obeyed again
    planner.drop();
  } else if (sane) {
    planner.advance(modes.motion(command));
  }
  report_tick(modes, now(), status);
  out = command;
  return true;
}

ControlLoop::ControlLoop(const Model& model, const ControlConfig& config) : impl_(std::make_unique<Impl>(model, config)) {}
ControlLoop::~ControlLoop() = default;

void ControlLoop::on_state(const RobotState& state, std::int64_t /*now_ns*/) noexcept {
  impl_->state = state;
  impl_->have_state = true;
}

void ControlLoop::on_mode_request(const ModeRequest& request) noexcept {
  if (impl_->have_state) (void)impl_->requests.add(request, impl_->state.run_id);
}

void ControlLoop::on_walk_command(const WalkCommand& command, std::int64_t now_ns) noexcept {
  if (!impl_->have_state || command.run_id != impl_->state.run_id) return;
  if (!impl_->walks_heard.is_not_older(command.sender_id, command.sequence)) return;
  impl_->status.walk_sequence = command.sequence;
  impl_->walk = command;
  impl_->walk_ns = now_ns;
}

void ControlLoop::on_step_list(const StepList& list) noexcept {
  StepList& last = impl_->steps;
  if (!impl_->have_state || list.run_id != impl_->state.run_id) return;
  if (list.sender_id == last.sender_id && list.sequence == last.sequence) return;
  if (!impl_->steps_heard.is_new(list.sender_id, list.sequence)) return;
  last = list;
  impl_->new_steps = true;
}

void ControlLoop::on_gamepad(const Gamepad& gamepad, std::int64_t now_ns) noexcept {
  if (!impl_->pads_heard.is_not_older(gamepad.sender_id, gamepad.sequence)) return;
  if (!impl_->token.admits(gamepad, now_ns)) return;
  impl_->gamepad = gamepad;
  impl_->gamepad_ns = now_ns;
}

void ControlLoop::on_arm_path(const ArmPathPiece& piece) noexcept {
  const Impl& i = *impl_;
  // A path asked of the last source still counts: a switch does not move the robot.
  if (!i.have_state || (piece.run_id != i.state.run_id && piece.run_id != i.previous_run)) return;
  impl_->modes.add_path(piece);
}

void ControlLoop::on_motion(const MotionPiece& piece) noexcept {
  const Impl& i = *impl_;
  if (!i.have_state || (piece.run_id != i.state.run_id && piece.run_id != i.previous_run)) return;
  impl_->modes.add_motion(piece);
}

void ControlLoop::on_arm_goal(const ArmGoal& goal) noexcept {
  if (goal.kind == ArmGoalKind::kCancel && impl_->have_state && goal.run_id == impl_->state.run_id)
    impl_->modes.cancel_path();
}

void ControlLoop::on_stop(const StopRequest& stop) noexcept {
  impl_->stop_heard = std::max(impl_->stop_heard, stop.kind);
  impl_->switch_heard = stop.reason == StopReason::kSwitch;
}

void ControlLoop::on_guard(const GuardReport& report, std::int64_t now_ns) noexcept {
  impl_->guard_heard = report;
  impl_->guard_heard_ns = now_ns;
}

void ControlLoop::set_obstacles(const std::vector<Obstacle>& obstacles) {
  if (impl_->guard != nullptr) impl_->guard->set_obstacles(obstacles);
}

bool ControlLoop::step(std::int64_t now_ns, JointCommand& command) noexcept {
  return impl_->step(now_ns, command);
}

bool ControlLoop::take_plan(StopPlanPiece& piece) noexcept { return impl_->planner.take(piece); }

const ControllerStatus& ControlLoop::status() const noexcept { return impl_->status; }

void ControlLoop::footsteps(ObstaclesPiece& out) const noexcept {
  footstep_shapes(impl_->model, impl_->estimator, impl_->modes.walk(), out);
}

std::array<double, 2> ControlLoop::foot_forces() const noexcept { return impl_->modes.foot_forces(); }

const char* ControlLoop::take_sentence(bool* of_path) noexcept {
  if (of_path != nullptr) *of_path = false;
  return impl_->sentence != nullptr ? std::exchange(impl_->sentence, nullptr) : impl_->modes.take_sentence(of_path);
}

std::string ControlLoop::guard_cause() const {
  const Guard* guard = impl_->guard.get();
  if (guard == nullptr || !guard->cause().found) return "";
  std::array<char, 320> text{};
  describe(impl_->model, guard->obstacles(), guard->cause(), text);
  return text.data();
}

const GuardReport& ControlLoop::guard_report() const noexcept {
  static const GuardReport none;
  return impl_->guard != nullptr ? impl_->guard->report() : none;
}

}  // namespace twinbus::control
