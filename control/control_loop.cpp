#include "control/control_loop.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "control/arm_follow.h"
#include "control/balance.h"
#include "control/blend.h"
#include "control/guard.h"
#include "control/mask_brake.h"
#include "control/mode_queue.h"
#include "control/posture.h"
#include "control/state_check.h"
#include "control/static_torque.h"
#include "robot/estimator.h"

namespace twinbus {

namespace {
constexpr double kModeBlend = 0.5;        // [s] between the set-points of two modes
constexpr double kBrake = 0.3;            // [s] in which hold brings a moving joint to rest
constexpr double kStopTime = 0.4;         // [s] in which a balanced stop ends a motion
constexpr double kFallenTilt = 0.7;       // [rad]
constexpr double kBalanceTilt = 0.35;     // [rad] from which balance still begins
constexpr double kIdleDamping = 0.1;      // share of kd
constexpr double kLean = 0.04;            // [m] at full stick
constexpr double kCrouch = 0.10;          // [m] at full trigger
constexpr double kGamepadTimeout = 0.25;  // [s]
constexpr double kSettledZmp = 0.02;      // [m] inside the support polygon: a stop may end
constexpr std::int64_t kNs = 1'000'000'000;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

template <std::size_t N>
std::array<float, N> to_floats(const Eigen::Matrix<double, static_cast<int>(N), 1>& v) noexcept {
  std::array<float, N> out{};
  for (std::size_t i = 0; i < N; ++i) out[i] = static_cast<float>(v[static_cast<Eigen::Index>(i)]);
  return out;
}
}  // namespace

struct ControlLoop::Impl {
  Impl(const Model& m, const ControlConfig& c);

  bool step(std::int64_t now_ns, JointCommand& out) noexcept;
  void first_state() noexcept;
  void hear_requests() noexcept;
  void obey(const ModeRequest& request) noexcept;
  void enter(Mode next) noexcept;
  void enter_hold(bool at_measured) noexcept;
  void follow_stop() noexcept;
  void watch_for_a_fall() noexcept;
  void lean(std::int64_t now_ns) noexcept;
  void compute(std::int64_t now_ns, double dt) noexcept;
  void want(double dt) noexcept;
  void guard_and_mask(std::int64_t now_ns, double dt) noexcept;
  void limit(double dt) noexcept;
  void write(JointCommand& out) noexcept;
  void report() noexcept;
  bool may_balance() const noexcept;
  double tilt() const noexcept;
  const Joint& joint(int bus) const noexcept { return model.joints[at(model.bus_joints[at(bus)])]; }
  PerJoint<double> measured_q() const noexcept { return state.q; }

  const Model& model;
  ControlConfig config;
  Estimator estimator;
  std::unique_ptr<Balance> balance;  // null when the robot cannot
  Posture posture;
  ArmFollow arm;
  Blend blend;
  MaskBrake brake;
  StaticTorque static_torque;
  std::unique_ptr<Guard> guard;
  ModeQueue requests;

  RobotState state;
  bool have_state = false, have_output = false;
  std::int64_t answered_tick = -1, answered_run = 0, previous_run = 0;
  std::int32_t answered_term = 0;
  JointCommand command;

  Mode mode = Mode::kNone, mode_before_stop = Mode::kNone;
  bool balancing = false;
  bool blend_next = false;
  bool stopping = false, held_by_gate = false;
  StopKind stop_heard = StopKind::kNone;
  SetPoint want_point, last;
  Eigen::VectorXd q_given, tau_static;

  Gamepad gamepad;
  std::int64_t gamepad_ns = 0;
  bool gamepad_leans = false;
  GuardReport guard_heard;
  std::int64_t guard_heard_ns = 0;
  std::int64_t mask = 0;
  const char* sentence = nullptr;
  const char* arm_refusal = nullptr;
  ControllerStatus status;
};

ControlLoop::Impl::Impl(const Model& m, const ControlConfig& c)
    : model(m),
      config(c),
      estimator(m),
      posture(m),
      arm(m),
      blend(m.bus_count()),
      brake(m),
      static_torque(m),
      q_given(Eigen::VectorXd::Zero(m.joint_count())),
      tau_static(q_given) {
  if (m.bus_count() < 1 || m.bus_count() > kMaxJoints) {
    throw std::runtime_error("robot " + m.name + " has " + std::to_string(m.bus_count()) +
                             " actuated joints; the bus carries 1 to " +
                             std::to_string(kMaxJoints));
  }
  if (Balance::why_not(m) == nullptr) balance = std::make_unique<Balance>(m, c.gains);
  if (c.guard_in_loop) guard = std::make_unique<Guard>(m, GuardConfig{.guard_id = c.controller_id});
}

double ControlLoop::Impl::tilt() const noexcept {
  const double up = estimator.configuration().base.linear()(2, 2);
  return std::acos(std::clamp(up, -1.0, 1.0));
}

bool ControlLoop::Impl::may_balance() const noexcept {
  return balance != nullptr && tilt() < kBalanceTilt && estimator.loaded(0) && estimator.loaded(1);
}

// Hold keeps the set-points, brought to rest; at_measured starts from where the joints are instead.
void ControlLoop::Impl::enter_hold(bool at_measured) noexcept {
  balancing = false;
  if (at_measured || !have_output) {
    posture.rest(measured_q());
  } else {
    posture.brake(last.q, last.qd, kBrake);
  }
}

void ControlLoop::Impl::enter(Mode next) noexcept {
  switch (next) {
    case Mode::kIdle:
      arm.drop();
      balancing = false;
      break;
    case Mode::kBalance:
      if (!may_balance()) {
        sentence =
            balance == nullptr
                ? "this robot cannot balance: it needs a free base and two six-joint legs with "
                  "soles"
                : "balance needs an upright robot with both soles on the ground; holding instead";
        next = Mode::kHold;
        enter_hold(!have_output);
        break;
      }
      if (!balancing) {
        if (mode == Mode::kIdle || mode == Mode::kNone || !have_output) posture.rest(measured_q());
        balance->start(estimator);
        balancing = true;
      }
      break;
    default:
      enter_hold(mode == Mode::kIdle || mode == Mode::kNone);
      break;
  }
  mode = next;
  blend_next = have_output;
}

void ControlLoop::Impl::obey(const ModeRequest& request) noexcept {
  status.mode_sequence = request.sequence;
  if (held_by_gate && request.mode != Mode::kIdle) {
    sentence = "the robot is stopped: clear the stop first; the mode stays as it is";
    return;
  }
  switch (request.mode) {
    case Mode::kIdle:
    case Mode::kHold:
      if (mode != request.mode) enter(request.mode);
      break;
    case Mode::kPose: {
      std::int64_t legs = 0;
      for (int k = 0; k < model.bus_count(); ++k) {
        if (balance != nullptr && balance->is_leg(model.bus_joints[at(k)]))
          legs |= std::int64_t{1} << k;
      }
      arm.cancel();
      if (balancing && (request.joint_mask & legs) == 0) {
        mode = Mode::kPose;  // the legs go on balancing
      } else {
        enter(Mode::kHold);
        mode = Mode::kPose;
      }
      posture.move(request.q, request.joint_mask, static_cast<double>(request.duration));
      break;
    }
    case Mode::kBalance:
      if (mode != Mode::kBalance) enter(Mode::kBalance);
      if (balancing) {
        balance->request(request.motion, static_cast<double>(request.amplitude),
                         static_cast<double>(request.frequency));
      }
      break;
    case Mode::kWalk:
      sentence = "walking comes with a later release; the mode stays as it is";
      break;
    case Mode::kStop:
      arm.cancel();
      if (balancing) {
        balance->stop_motion(kStopTime);
      } else if (mode != Mode::kIdle) {
        enter(Mode::kHold);
      }
      break;
    case Mode::kNone:
      break;
  }
}

void ControlLoop::Impl::first_state() noexcept {
  estimator.reset();
  estimator.update(state);
  have_output = false;
  mode = Mode::kNone;
  balancing = false;
  brake.reset();
  blend.cancel();
  enter(config.first_mode);
}

// The gate obeys nobody while it is stopped, but for a balanced stop: then it passes what carries
// `stopping`.
void ControlLoop::Impl::follow_stop() noexcept {
  const bool was_held = held_by_gate;
  held_by_gate = state.role == Role::kStopped && state.stop_kind >= StopKind::kHold;
  const bool balanced = state.stop_kind == StopKind::kBalanced || stop_heard == StopKind::kBalanced;
  if (balanced && !stopping) {
    arm.cancel();
    if (balancing) balance->stop_motion(kStopTime);
    if (!balancing && mode != Mode::kIdle) enter_hold(false);
    stopping = true;
  }
  if (state.stop_kind != StopKind::kBalanced) {
    stopping = false;
  } else if (balancing && balance->resting() &&
             estimator.support_margin(estimator.zmp()) > kSettledZmp) {
    stopping = false;
  }
  stop_heard = StopKind::kNone;
  if (!held_by_gate && !was_held) return;
  if (held_by_gate && !was_held) {
    mode_before_stop = mode;
    mode = Mode::kStop;
    arm.drop();
  }
  // Nobody listens: follow the robot, so that the first command after the clear is where it is.
  posture.rest(measured_q());
  blend.cancel();
  brake.reset();
  blend_next = have_output = false;
  balancing = may_balance();
  if (balancing) balance->start(estimator);
  if (!held_by_gate) {
    mode = mode_before_stop == Mode::kIdle ? Mode::kIdle : balancing ? Mode::kBalance : Mode::kHold;
    if (mode == Mode::kIdle) balancing = false;
  }
}

void ControlLoop::Impl::watch_for_a_fall() noexcept {
  if (!balancing || tilt() < kFallenTilt) return;
  sentence = "the robot has fallen: the joints are damped; put it on its feet and ask for balance";
  enter(Mode::kIdle);
}

void ControlLoop::Impl::lean(std::int64_t now_ns) noexcept {
  if (!balancing) return;
  const bool fresh = gamepad_ns != 0 &&
                     static_cast<double>(now_ns - gamepad_ns) < kGamepadTimeout * 1e9 &&
                     gamepad.connected && gamepad.deadman && gamepad.run_id == state.run_id;
  if (!fresh) {
    if (gamepad_leans) balance->lean(Eigen::Vector3d::Zero());
    gamepad_leans = false;
    return;
  }
  const auto axis = [](float a) { return std::clamp(static_cast<double>(a), -1.0, 1.0); };
  balance->lean({kLean * axis(gamepad.left_y), kLean * axis(gamepad.left_x),
                 -kCrouch * std::max({0.0, axis(gamepad.right_trigger), -axis(gamepad.right_y)})});
  gamepad_leans = true;
}

// What the mode asks of every joint.
void ControlLoop::Impl::want(double dt) noexcept {
  posture.advance(dt);
  arm.update(posture, mask, dt);
  if (arm.refusal() != nullptr && arm.refusal() != arm_refusal) sentence = arm.refusal();
  arm_refusal = arm.refusal();
  const int n = model.bus_count();
  q_given = estimator.configuration().q;
  for (int k = 0; k < n; ++k) q_given[model.bus_joints[at(k)]] = posture.q(k);
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& follower = model.joints[at(j)];
    if (follower.mimic >= 0)
      q_given[j] = follower.mimic_multiplier * q_given[follower.mimic] + follower.mimic_offset;
  }

  const Eigen::VectorXd* tau = nullptr;
  if (mode == Mode::kIdle) {
    for (int k = 0; k < n; ++k) {
      const auto i = at(k);
      want_point.q[i] = state.q[i];
      want_point.qd[i] = want_point.tau[i] = want_point.kp[i] = 0.0;
      want_point.kd[i] = kIdleDamping * joint(k).kd;
    }
    return;
  }
  if (balancing) {
    balance->update(estimator, q_given, dt);
    if (!balance->finite()) {
      sentence = "the balance controller met a number that is not one; it starts again";
      balance->start(estimator);
      balance->update(estimator, q_given, dt);
    }
    tau = &balance->tau();
  } else {
    static_torque.solve(estimator, q_given, tau_static);
    tau = &tau_static;
  }
  for (int k = 0; k < n; ++k) {
    const auto i = at(k);
    const int j = model.bus_joints[i];
    const bool leg = balancing && balance->is_leg(j);
    want_point.q[i] = leg ? balance->q()[j] : posture.q(k);
    want_point.qd[i] = leg ? balance->qd()[j] : posture.qd(k);
    want_point.tau[i] = (*tau)[j];
    want_point.kp[i] = leg ? balance->kp(j) : joint(k).kp;
    want_point.kd[i] = leg ? balance->kd(j) : joint(k).kd;
  }
}

void ControlLoop::Impl::guard_and_mask(std::int64_t now_ns, double dt) noexcept {
  mask = 0;
  if (guard != nullptr) {
    write(command);  // what is asked, before any mask
    mask = guard->check(state, &command, estimator.configuration()).hold_mask;
  }
  if (guard_heard.run_id == state.run_id && guard_heard_ns != 0 &&
      static_cast<double>(now_ns - guard_heard_ns) < model.guard_timeout * 1e9) {
    mask |= guard_heard.hold_mask;
    status.guard_tick = guard_heard.tick;
  }
  for (int joint_index : model.leg_joints) {
    for (int k = 0; k < model.bus_count(); ++k) {
      if (model.bus_joints[at(k)] == joint_index) mask &= ~(std::int64_t{1} << k);
    }
  }
  brake.apply(want_point, mask, dt);
}

// Nothing leaves that is not finite and within the robot's limits.
void ControlLoop::Impl::limit(double dt) noexcept {
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = at(k);
    const Joint& j = joint(k);
    SetPoint& p = want_point;
    const bool good = std::isfinite(p.q[i]) && std::isfinite(p.qd[i]) && std::isfinite(p.tau[i]) &&
                      std::isfinite(p.kp[i]) && std::isfinite(p.kd[i]);
    if (!good) {
      p.q[i] = have_output ? last.q[i] : std::clamp(state.q[i], -1e3, 1e3);
      p.qd[i] = p.tau[i] = 0.0;
      p.kp[i] = j.kp;
      p.kd[i] = j.kd;
    }
    if (j.kind != JointKind::kContinuous) p.q[i] = std::clamp(p.q[i], j.lower, j.upper);
    if (have_output) {
      const double rate = j.rate > 0.0 ? std::min(j.rate, j.velocity) : j.velocity;
      if (rate > 0.0) p.q[i] = std::clamp(p.q[i], last.q[i] - rate * dt, last.q[i] + rate * dt);
      if (j.kind != JointKind::kContinuous) p.q[i] = std::clamp(p.q[i], j.lower, j.upper);
    }
    if (j.velocity > 0.0) p.qd[i] = std::clamp(p.qd[i], -j.velocity, j.velocity);
    if (j.effort > 0.0) p.tau[i] = std::clamp(p.tau[i], -j.effort, j.effort);
    p.kp[i] = std::max(0.0, p.kp[i]);
    p.kd[i] = std::max(0.0, p.kd[i]);
  }
}

void ControlLoop::Impl::write(JointCommand& out) noexcept {
  out.tick = state.tick;
  out.run_id = state.run_id;
  out.model_hash = state.model_hash;
  out.controller_id = config.controller_id;
  out.term = state.term;
  out.joint_count = static_cast<std::int16_t>(model.bus_count());
  out.flags = stopping ? kCommandStopping : std::int16_t{0};
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = at(k);
    out.q[i] = want_point.q[i];
    out.qd[i] = static_cast<float>(want_point.qd[i]);
    out.tau[i] = static_cast<float>(want_point.tau[i]);
    out.kp[i] = static_cast<float>(want_point.kp[i]);
    out.kd[i] = static_cast<float>(want_point.kd[i]);
  }
}

void ControlLoop::Impl::compute(std::int64_t now_ns, double dt) noexcept {
  lean(now_ns);
  want(dt);
  if (blend_next && have_output) blend.start(last, want_point, kModeBlend);
  blend_next = false;
  blend.apply(want_point, dt);
  guard_and_mask(now_ns, dt);
  limit(dt);
  last = want_point;
  have_output = true;
}

bool ControlLoop::Impl::step(std::int64_t now_ns, JointCommand& out) noexcept {
  if (!have_state) return false;
  if (state.role != Role::kActive && state.role != Role::kReleasing && state.role != Role::kStopped)
    return false;
  const bool same_source = state.run_id == answered_run && state.term == answered_term;
  if (same_source && state.tick == answered_tick) {
    out = command;
    return true;
  }
  const double period = model.period();
  double dt = period;
  const bool sane = is_sane(state, model);
  if (answered_tick < 0) {
    if (!sane) return false;
    first_state();
  } else {
    const std::int64_t ticks = std::clamp<std::int64_t>(state.tick - answered_tick, 1, 5);
    dt = static_cast<double>(ticks) * period;
    if (sane) {
      estimator.update(state);
      if (!same_source) {
        previous_run = answered_run;
        if (balancing) balance->rebase(estimator);
        if (guard != nullptr) guard->reset();
      }
    }
  }
  answered_run = state.run_id;
  answered_term = state.term;
  answered_tick = state.tick;
  if (sane) {
    watch_for_a_fall();
    follow_stop();
    while (const ModeRequest* request = requests.take(state.tick)) obey(*request);
    compute(now_ns, dt);
  } else {
    sentence = "a state that no robot can be in was ignored";
    for (double& qd : last.qd) qd = 0.0;
    want_point = last;
  }
  write(command);
  report();
  out = command;
  return true;
}

void ControlLoop::Impl::report() noexcept {
  ControllerStatus& s = status;
  s.tick = state.tick;
  s.run_id = state.run_id;
  s.controller_id = config.controller_id;
  s.arm_path_id = arm.path_id();
  s.term = state.term;
  s.mode = mode;
  s.motion = balancing ? balance->motion() : Motion::kNone;
  s.stopping = state.stop_kind;
  s.arm_state = static_cast<std::int8_t>(arm.state());
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  const Eigen::Vector3d zmp = world_in_ground * estimator.zmp();
  if (balancing) {
    s.com = to_floats<3>(balance->com());
    s.com_velocity = to_floats<3>(balance->com_velocity());
    s.com_reference = to_floats<3>(balance->com_reference());
    s.dcm = to_floats<2>(balance->dcm());
    s.zmp_reference = to_floats<2>(balance->stabilizer().zmp_wanted());
  } else {
    s.com = to_floats<3>(world_in_ground * estimator.kinematics().com());
    s.com_velocity = to_floats<3>(world_in_ground.linear() * estimator.kinematics().com_velocity());
    s.com_reference = s.com;
    s.dcm = {s.com[0], s.com[1]};
    s.zmp_reference = to_floats<2>(zmp.head<2>());
  }
  s.zmp = to_floats<2>(zmp.head<2>());
  s.zmp_margin = static_cast<float>(estimator.support_margin(estimator.zmp()));
  const Configuration& c = estimator.configuration();
  const Eigen::Quaterniond attitude(c.base.linear());
  s.base_position = to_floats<3>(c.base.translation());
  s.base_attitude = {static_cast<float>(attitude.w()), static_cast<float>(attitude.x()),
                     static_cast<float>(attitude.y()), static_cast<float>(attitude.z())};
  s.base_velocity = to_floats<3>(c.base_velocity);
}

ControlLoop::ControlLoop(const Model& model, const ControlConfig& config)
    : impl_(std::make_unique<Impl>(model, config)) {}
ControlLoop::~ControlLoop() = default;

void ControlLoop::on_state(const RobotState& state, std::int64_t /*now_ns*/) noexcept {
  impl_->state = state;
  impl_->have_state = true;
}

void ControlLoop::on_mode_request(const ModeRequest& request) noexcept {
  if (impl_->have_state) (void)impl_->requests.add(request, impl_->state.run_id);
}

void ControlLoop::on_walk_command(const WalkCommand& command, std::int64_t /*now_ns*/) noexcept {
  if (!impl_->have_state || command.run_id != impl_->state.run_id) return;
  impl_->status.walk_sequence = command.sequence;
  impl_->sentence = "walking comes with a later release; the mode stays as it is";
}

void ControlLoop::on_gamepad(const Gamepad& gamepad, std::int64_t now_ns) noexcept {
  impl_->gamepad = gamepad;
  impl_->gamepad_ns = now_ns;
}

void ControlLoop::on_arm_path(const ArmPathPiece& piece) noexcept {
  const Impl& i = *impl_;
  // A path asked of the last source still counts: a switch does not move the robot.
  if (!i.have_state || (piece.run_id != i.state.run_id && piece.run_id != i.previous_run)) return;
  if (i.held_by_gate || i.stopping || i.mode == Mode::kIdle || i.mode == Mode::kNone) return;
  impl_->arm.add(piece);
}

void ControlLoop::on_arm_goal(const ArmGoal& goal) noexcept {
  if (goal.kind == ArmGoalKind::kCancel && impl_->have_state && goal.run_id == impl_->state.run_id)
    impl_->arm.cancel();
}

void ControlLoop::on_stop(const StopRequest& stop) noexcept {
  impl_->stop_heard = std::max(impl_->stop_heard, stop.kind);
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

const ControllerStatus& ControlLoop::status() const noexcept { return impl_->status; }

const char* ControlLoop::take_sentence() noexcept {
  return std::exchange(impl_->sentence, nullptr);
}

const GuardReport& ControlLoop::guard_report() const noexcept {
  static const GuardReport none;
  return impl_->guard != nullptr ? impl_->guard->report() : none;
}

}  // namespace twinbus
