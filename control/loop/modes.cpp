#include "control/loop/modes.h"

#include <stdexcept>

#include "common/math/index.h"
#include "robot/description/walking_config.h"
#include "robot/dynamics/joint_friction.h"

namespace twinbus::inline control {

namespace {
constexpr double kBrake = 0.3;         // [s] in which hold brings a moving joint to rest
constexpr double kFallenTilt = 0.7;    // [rad]
constexpr double kIdleDamping = 0.1;   // share of kd
constexpr const char* kHasFallen =
    "the robot has fallen: the joints are damped; put it on its feet, clear the stop and ask for balance";
}  // namespace

Modes::Modes(const Model& model, const BalanceGains& gains, const WalkGains& walk)
    : model_(model),
      way_(model),
      posture_(model),
      arm_(model),
      motion_(model),
      braked_(model),
      brace_(model),
      static_torque_(model),
      q_given_(Eigen::VectorXd::Zero(model.joint_count())),
      tau_(q_given_) {
  for (int k = 0; k < model.bus_count(); ++k) {
    const Joint& joint = model.joints[at(model.bus_joints[at(k)])];
    kp_[at(k)] = joint.kp;
    kd_[at(k)] = joint.kd;
  }
  for (int j = 0; j < model.joint_count(); ++j) {
    if (model.joints[at(j)].mimic >= 0) followers_.push_back(j);
  }
  no_walk_ = "this robot cannot walk: it needs a free base, and two legs of five to seven joints with soles, or two or four with point feet";
  if (Balance::why_not(model) == nullptr) {
    standing_ = (balance_ = std::make_unique<Balance>(model, gains)).get();
  } else if (why_no_point_feet(model) == nullptr) {
    point_feet_ = std::make_unique<PointFeet>(model);
    standing_ = walker_ = point_feet_.get();
  }
  for (int k = 0; standing_ != nullptr && k < model.bus_count(); ++k) {
    if (standing_->is_leg(model.bus_joints[at(k)])) legs_ |= bit(k);
  }
  if (balance_ == nullptr) return;
  try {
    pose_ = std::make_unique<PoseCheck>(model);
    squat_ = std::make_unique<SquatCheck>(model);
    walker_ = (walk_ = std::make_unique<Walk>(model, walk)).get();
  } catch (const std::runtime_error& error) {
    no_walk_ = std::string(error.what()) + "; the mode stays as it is";
  }
}

bool Modes::may_balance(const Moment& now) const noexcept { return standing_ != nullptr && standing_->may_start(now.estimator); }

// Upright, and carried by a foot: not in a hoist, not on the ground.
bool Modes::stands(const Moment& now) const noexcept {
  return standing_ != nullptr && now.estimator.tilt() < kFallenTilt && standing_->stands(now.estimator);
}

void Modes::begin(Behavior* behavior, const Moment& now) noexcept {
  if (mode_ == Mode::kIdle || mode_ == Mode::kNone || now.last == nullptr) posture_.rest(now.state.q);
  let_legs_go();
  active_ = behavior;
  active_->start(now.estimator);
}

void Modes::enter_walk(const Moment& now) noexcept {
  if (walker_ == nullptr) {
    sentence_ = no_walk_.c_str();
    return;
  }
  if (active_ != walker_) {
    if (!may_balance(now)) {
      sentence_ = "walking begins on an upright robot with its feet on the ground; the mode stays as it is";
      return;
    }
    if (const char* why = walker_->why_no_walk(now.estimator)) {
      sentence_ = why;
      return;
    }
    if (const char* caution = walker_->caution(now.estimator)) sentence_ = caution;
    changed_ = true;
    begin(walker_, now);
  }
  active_->walk(true);
  after_rest_.reset();
  mode_ = Mode::kWalk;
}

void Modes::leave_walk(const ModeRequest& next, bool at_once, bool tidy) noexcept {
  active_->leave_walk(at_once, tidy, after_rest_.has_value());
  after_rest_ = next;
}

void Modes::start(Mode first, const Moment& now) noexcept {
  mode_ = Mode::kNone;
  forget_pose();
  motion_.forget();
  after_motion_ = {};
  bracing_ = false;
  let_legs_go();
  if (standing_ != nullptr) standing_->forget();
  enter(!model_.floating_base && first == Mode::kBalance ? Mode::kHold : first, now);
}

void Modes::rebase() noexcept {
  if (active_ != nullptr) active_->rebase();
}

// Hold keeps the set-points, brought to rest; at_measured starts from where the joints are instead.
void Modes::enter_hold(const Moment& now, bool at_measured) noexcept {
  let_legs_go();
  if (at_measured || now.last == nullptr) {
    posture_.rest(now.state.q);
  } else {
    posture_.brake(now.last->q, now.last->qd, kBrake);
  }
}

void Modes::enter_balance(const Moment& now) noexcept {
  if (!may_balance(now)) {
    sentence_ =
        !model_.floating_base ? "the base is fixed, so nothing has to balance; holding instead"
        : standing_ == nullptr
            ? "this robot cannot balance: it needs a free base, and two legs of five to seven joints with soles, or two or four with "
              "point feet"
            : "balance needs an upright robot with its feet on the ground; holding instead";
    enter_hold(now, false);
    mode_ = Mode::kHold;
    return;
  }
  if (active_ != standing_) begin(standing_, now);
  mode_ = Mode::kBalance;
}

void Modes::enter(Mode next, const Moment& now) noexcept {
  changed_ = true;
  switch (next) {
    case Mode::kIdle:
      arm_.drop();
      motion_.drop();
      let_legs_go();
      mode_ = Mode::kIdle;
      break;
    case Mode::kBalance:
      enter_balance(now);
      break;
    default:
      enter_hold(now, mode_ == Mode::kIdle || mode_ == Mode::kNone);
      mode_ = next;
      break;
  }
}

void Modes::obey(const ModeRequest& request, const Moment& now) noexcept {
  if (bracing_) {
    if (request.mode != Mode::kIdle) {
      sentence_ = "the robot falls: it obeys again once it lies; the mode stays as it is";
      return;
    }
    bracing_ = false;
  }
  // Damped legs fold.  Who means it says `stop off`, which is never refused.
  if (request.mode == Mode::kIdle && stands(now)) {
    sentence_ =
        "idle lets go of the joints and the standing robot would fall; ./twinbus mode idle "
        "--let-go "
        "does it all the same";
    return;
  }
  if (held_by_gate_) {
    if (request.mode == Mode::kIdle) {
      mode_before_stop_ = Mode::kIdle;
    } else {
      sentence_ = now.state.plan_number != 0
                      ? "the robot follows its stop plan: ask again once it stands; the mode stays as it is"
                      : "the robot is stopped: clear the stop first; the mode stays as it is";
    }
    return;
  }
  if (request.mode == Mode::kBalance && request.motion == Motion::kPlayed) {
    sentence_ = "a motion is played by ./twinbus motion FILE --play; the mode stays as it is";
    return;
  }
  if (request.mode == Mode::kBalance && request.motion != Motion::kNone && standing_ == nullptr) {
    sentence_ = model_.floating_base ? "sway and squat move a robot that balances on its legs, and this one cannot: ./twinbus pose NAME or JOINT=ANGLE "
                                       "moves its joints; the mode stays as it is"
                                     : "sway and squat move a robot that balances on its legs, and the base of this one is fixed: ./twinbus pose and "
                                       "reach move it; the mode stays as it is";
    return;
  }
  if (put_off(request)) return;
  if (request.mode == Mode::kPose && !walks()) {
    if (const char* why = why_no_pose(request, now)) {
      sentence_ = why;
      return;
    }
  }
  const bool stand_first = request.mode == Mode::kHold || request.mode == Mode::kPose ||
                           request.mode == Mode::kBalance || request.mode == Mode::kStop;
  if (walks() && stand_first) {
    const bool stop = request.mode == Mode::kStop;
    if (stop) arm_.cancel();
    return leave_walk(request, stop, !stop);
  }
  if (request.mode != Mode::kNone) looks_ahead_ = false;
  switch (request.mode) {
    case Mode::kIdle:
    case Mode::kHold:
      if (mode_ != request.mode) enter(request.mode, now);
      break;
    case Mode::kPose:
      way_.start(now.estimator.configuration(), now.last != nullptr ? now.last->q : now.state.q, request.q,
                 request.joint_mask);
      asked_pose_ = request;
      looks_ahead_ = true;
      break;
    case Mode::kBalance:
      if (mode_ != Mode::kBalance) enter(Mode::kBalance, now);
      if (active_ != nullptr) request_motion(request, now);
      break;
    case Mode::kWalk:
      if (!walks()) {
        enter_walk(now);
      } else if (!stopping_) {
        after_rest_.reset();
        active_->walk(true);
      }
      break;
    case Mode::kStop:
      arm_.cancel();
      stop_playing();
      if (active_ != nullptr) {
        active_->stop_motion(kStopTime);
      } else if (mode_ != Mode::kIdle) {
        enter(Mode::kHold, now);
      }
      break;
    case Mode::kNone:
      break;
  }
}

// The gate obeys nobody while it is stopped, but for a balanced stop: then it passes what carries
// `stopping`.
bool Modes::follow_stop(StopKind asked, bool for_switch, bool plan_runs, const Moment& now) noexcept {
  const RobotState& state = now.state;
  const bool was_held = held_by_gate_;
  held_by_gate_ = plan_runs || (state.role == Role::kStopped && state.stop_kind >= StopKind::kHold);
  const bool balanced = state.stop_kind == StopKind::kBalanced || asked == StopKind::kBalanced;
  if (balanced && !stopping_) {
    arm_.cancel();
    stop_playing();
    forget_pose();
    if (walks()) {
      leave_walk({}, true, for_switch);
    } else if (active_ != nullptr) {
      active_->stop_motion(kStopTime);
    } else if (mode_ != Mode::kIdle && !bracing_) {
      enter_hold(now, false);
    }
    stopping_ = true;
  }
  if (state.stop_kind != StopKind::kBalanced) {
    stopping_ = false;
  } else if (active_ != nullptr && active_->stopped(now.estimator)) {
    stopping_ = false;
  }
  if (!held_by_gate_ && !was_held) return false;
  forget_pose();
  if (held_by_gate_ && !was_held) {
    mode_before_stop_ = mode_;
    mode_ = Mode::kStop;
    arm_.drop();
    motion_.drop();
  }
  bracing_ = false;
  // Nobody listens: follow the robot, so that the first command after the clear is where it is.
  posture_.rest(state.q);
  changed_ = false;
  let_legs_go();
  const bool balances = may_balance(now);
  if (balances) begin(standing_, now);
  if (!held_by_gate_) {
    mode_ = mode_before_stop_ == Mode::kIdle ? Mode::kIdle
            : balances                       ? Mode::kBalance
                                             : Mode::kHold;
    if (mode_ == Mode::kIdle) let_legs_go();
  }
  return true;
}

PlannedMotion Modes::motion(const JointCommand& command) const noexcept {
  const std::int64_t all = model_.bus_count() >= 63 ? ~std::int64_t{0} : bit(model_.bus_count()) - 1;
  const bool legs_move = active_ != nullptr && active_->moves();
  const PointFeet* points = point_feet();
  const bool moves = legs_move || posture_.moving() || arm_.moving() || motion_.active();
  return {.walk = walk(),
          .posture = motion_.stage() == MotionFollow::Stage::kPlays ? braked_ : posture_,
          .arm = arm_,
          .q_given = q_given_,
          .command = command,
          .joints = all,
          .follow = measured(),
          .down = points != nullptr && points->stepping() ? &points->stance() : nullptr,
          .down_torque = points != nullptr ? &points->stance_torque() : nullptr,
          .rests = !moves,
          .steered = mode_ != Mode::kIdle && mode_ != Mode::kNone && !bracing_ && !held_by_gate_};
}

void Modes::resume_walk(const Walk& foreseen, const Eigen::VectorXd& q, const Eigen::VectorXd& qd) noexcept {
  *walk_ = foreseen;
  walk_->take_over(q, qd);
}

void Modes::watch_for_a_fall(const Moment& now) noexcept {
  if (bracing_) {
    if (brace_.over()) end_brace(now);
    return;
  }
  if (active_ == nullptr || held_by_gate_) return;  // a gate that obeys nobody lets it bend nothing
  if (now.estimator.tilt() >= kFallenTilt) {
    looks_ahead_ = false;
    sentence_ = kHasFallen;
    enter(Mode::kIdle, now);
  } else if (Brace::is_lost(now.estimator)) {
    sentence_ = "the robot falls: it bends its knees, brings its arms before it and gives way";
    arm_.drop();
    motion_.drop();
    let_legs_go();
    looks_ahead_ = false;
    bracing_ = true;
    changed_ = false;  // a fall leaves no time to blend
    mode_ = Mode::kStop;
    brace_.start(now.last, now.state, posture_);
  }
}

// It lies, or the push was less bad than it seemed.
void Modes::end_brace(const Moment& now) noexcept {
  bracing_ = false;
  const bool stands = may_balance(now);
  sentence_ = stands ? "the robot did not fall: it balances again" : kHasFallen;
  enter(stands ? Mode::kBalance : Mode::kIdle, now);
}

void Modes::damp(const RobotState& state, SetPoint& set_point) const noexcept {
  for (int k = 0; k < model_.bus_count(); ++k) {
    const auto i = at(k);
    set_point.q[i] = state.q[i];
    set_point.qd[i] = set_point.tau[i] = set_point.kp[i] = 0.0;
    set_point.kd[i] = kIdleDamping * model_.joints[at(model_.bus_joints[i])].kd;
  }
}

void Modes::want(const Moment& now, std::int64_t mask, double dt, SetPoint& set_point) noexcept {
  if (dt > 0.0) look_ahead(now);
  posture_.advance(dt);
  if (dt > 0.0 && now.last != nullptr && !bracing_) posture_.yield(mask, now.last->q, now.last->qd, dt);
  if (balance_ != nullptr) balance_->watch(now.estimator, dt);
  // A path begins where a guard holds the arm, not where the arm was wanted before.
  for (int k = 0; now.last != nullptr && arm_.begins() && k < model_.bus_count(); ++k) {
    if (((mask >> k) & 1) != 0) posture_.set(k, now.last->q[at(k)], 0.0);
  }
  arm_.update(posture_, mask, dt);
  if (const char* why = arm_.take_refusal()) sentence_ = path_refusal_ = why;
  if (dt > 0.0) play(now, mask, dt);
  if (mode_ == Mode::kIdle) return damp(now.state, set_point);
  if (bracing_) return brace_.update(now.estimator, posture_, dt, set_point);
  if (after_rest_ && active_->resting()) {
    const ModeRequest next = *std::exchange(after_rest_, std::nullopt);
    enter(Mode::kBalance, now);
    obey(next, now);
  }

  const int n = model_.bus_count();
  q_given_ = now.estimator.configuration().q;
  for (int k = 0; k < n; ++k) q_given_[model_.bus_joints[at(k)]] = posture_.q(k);
  for (const int j : followers_) {
    const Joint& follower = model_.joints[at(j)];
    q_given_[j] = follower.mimic_multiplier * q_given_[follower.mimic] + follower.mimic_offset;
  }
  move_legs(now, dt);
  const Eigen::VectorXd& tau = active_ != nullptr ? active_->tau() : tau_;
  set_point.kp = kp_;
  set_point.kd = kd_;
  for (int k = 0; k < n; ++k) {
    set_point.q[at(k)] = posture_.q(k);
    set_point.qd[at(k)] = posture_.qd(k);
    set_point.tau[at(k)] = tau[model_.bus_joints[at(k)]];
  }
  if (active_ != nullptr) set_legs(set_point);
  const std::int64_t unplanned = measured();
  for (int k = 0; k < n; ++k) {
    const Joint& joint = model_.joints[at(model_.bus_joints[at(k)])];
    if (((unplanned >> k) & 1) == 0) set_point.tau[at(k)] += friction_torque(joint, set_point.qd[at(k)]);
  }
}

}  // namespace twinbus::control
