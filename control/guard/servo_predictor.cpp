#include "control/guard/servo_predictor.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "robot/kinematics/brake.h"
#include "common/math/index.h"
#include "common/math/quintic_fade.h"
#include "robot/dynamics/joint_friction.h"

namespace twinbus::inline control {

namespace {

constexpr double kFollows = 20.0;      // natural frequency of a servo that follows its set-point, at least [rad/s]
constexpr double kLags = 0.025;         // a servo that follows is this late, at most [s]
constexpr double kStrays = 0.2;        // a set-point that was far from its joint may be so again [s]
constexpr int kPartsOfTick = 2;         // steps until the brake comes
constexpr double kBrakeStep = 0.005;   // of the look along a brake [s]
constexpr int kMostBrakeSteps = 60;
constexpr double kNearLimit = 0.95;     // of an effort: a torque beyond it may be cut
constexpr double kRests = 0.02;        // [rad/s or m/s]
constexpr double kLeastBrake = 1.0;    // [rad/s^2 or m/s^2]
constexpr int kLimitPasses = 4;        // of a step, until it is known which torques and joints are at their limits
constexpr double kStop = 1e6;          // of a stop, beside inertia [kg m^2 or kg]

// The smaller of two that agree on where to go, or zero.
double agreed(double a, double b) noexcept { return a * b > 0.0 ? (std::abs(a) < std::abs(b) ? a : b) : 0.0; }

// A course that ends `rest` behind its first part, and is as fast as it can then.
Course ends_at(double first, double speed, double rest, double brake) noexcept {
  const double needed = 0.5 * speed * speed / std::max(std::abs(rest), 1e-9);
  if (rest * speed >= 0.0 && needed > kLeastBrake) return {first, speed, needed};
  return {first, std::copysign(std::sqrt(2.0 * brake * std::abs(rest)), rest), brake};
}

}  // namespace

ServoPredictor::ServoPredictor(const Model& model, int delay_ticks, double lag)
    : period_(model.period()),
      lag_(lag),
      delay_((std::clamp(delay_ticks, 0, SetPointTrack::kMostDelay) + 1) * model.period() + lag),
      fade_s_(model.blend_s),
      count_(std::min(model.bus_count(), kMaxJoints)),
      delay_ticks_(std::clamp(delay_ticks, 0, SetPointTrack::kMostDelay)),
      factor_(at(JointInertia::kFactor)),
      inertia_(model),
      dynamics_(model),
      no_acceleration_(Eigen::VectorXd::Zero(model.joint_count())),
      torque_(no_acceleration_) {
  for (int k = 0; k < count_; ++k) {
    const int j = model.bus_joints[at(k)];
    const Joint& joint = model.joints[at(j)];
    Servo& s = servos_[at(k)];
    s.joint = j;
    s.of = &joint;
    s.effort = joint.effort;
    s.most_speed = joint.velocity;
    s.rate = set_point_rate(joint);
    s.brake = brake_deceleration(joint);
    s.damping = joint.damping;
    s.lower = joint.lower;
    s.upper = joint.upper;
    s.hold_kp = hold_kp(joint);
    s.hold_kd = hold_kd(joint);
    s.leg = std::find(model.leg_joints.begin(), model.leg_joints.end(), j) != model.leg_joints.end();
    order_[at(k)] = k;
  }
  std::sort(order_.begin(), order_.begin() + count_,
            [&](int a, int b) { return servos_[at(a)].joint < servos_[at(b)].joint; });
  for (int n = 0; n < count_; ++n) joints_[at(n)] = servos_[at(order_[at(n)])].joint;
  Kinematics kinematics(model);
  kinematics.update(Configuration(model));
  inertia_.update(kinematics, std::span(joints_).first(at(count_)));
  for (int n = 0; n < count_; ++n) servos_[at(order_[at(n)])].follows_kp = kFollows * kFollows * inertia_(n, n);
}

void ServoPredictor::reset() noexcept {
  started_ = changed_ = false;
  soft_ = weak_ = held_now_ = 0;
  masks_.fill(0);
  for (Servo& s : servos_) s.strays = 0.0;
}

std::int64_t ServoPredictor::on_hold() const noexcept {
  std::int64_t held = masks_[0];
  for (int i = 1; i < delay_ticks_; ++i) held |= masks_[at(i)];
  return held & soft_;
}

// A client begins where the source held the robot, or where the client before it was, unless it will have no fade.
void ServoPredictor::hear(const RobotState& state, const JointCommand& command) noexcept {
  if (started_ && command.controller_id == controller_) return;
  for (int k = 0; k < count_; ++k) {
    const auto i = at(k);
    Servo& s = servos_[i];
    if (!started_) {
      s.q = s.heard_q = s.asked = state.q[i];
      s.kp = s.of->kp;
      s.kd = s.of->kd;
      s.client_speed = s.step = s.qd = 0.0;
      s.client_q = command.q[i];
    }
    s.from_q = s.q - command.q[i];
    s.from_v = s.qd - static_cast<double>(command.qd[i]);
    s.from_kp = s.kp - static_cast<double>(command.kp[i]);
    s.from_kd = s.kd - static_cast<double>(command.kd[i]);
    s.faded = (command.flags & kCommandNoFade) != 0 ? fade_s_ : 0.0;
  }
  controller_ = command.controller_id;
  if (!started_) {
    heard_tick_ = command.tick - 1;
    looked_tick_ = state.tick - 1;
  }
  started_ = true;
}

// A brake may have begun sooner or later than it was taken to, from another speed.  The torque of its servo tells where its
// set-point is; one that is not where it was thought to be is where the joint is.  A robot that measures no torque says zero.
void ServoPredictor::see_held(Servo& s, double q, double v, double tau) noexcept {
  s.feels = s.feels || tau != 0.0;
  if (!s.feels) return;
  const double kp = std::max(s.kp, s.hold_kp), kd = std::max(s.kd, s.hold_kd);
  if (!(kp > 0.0) || (s.effort > 0.0 && std::abs(tau) > kNearLimit * s.effort)) return;
  const double pulls = tau - s.held_tau;
  if (std::abs(s.q - q - (pulls - kd * (s.held_v - v)) / kp) < kFollowed) return;
  s.q = std::clamp(q + pulls / kp, s.lower, s.upper);
  s.held_v = std::clamp(v, -s.most_speed, s.most_speed);
}

// A mask begins or ends, as in the gate (bridge/gate/masked_brake.h).  What is held may be let go at any time, and goes on from
// where it is then.
void ServoPredictor::hold(const RobotState& state, const JointCommand& command) noexcept {
  const std::int64_t in_force = delay_ticks_ > 0 ? masks_[at(delay_ticks_ - 1)] : masks_[0];
  const std::int64_t begin = in_force & ~held_now_, bound = in_force | held_now_;
  held_now_ = in_force;
  for (int k = 0; k < count_ && bound != 0; ++k) {
    if ((bound & bit(k)) == 0) continue;
    const auto i = at(k);
    Servo& s = servos_[i];
    if ((begin & bit(k)) != 0) {
      const BrakeStart start = brake_start(s.q, s.qd, state.q[i], static_cast<double>(state.qd[i]), s.most_speed,
                                           twinbus::is_soft(s.kp, *s.of));
      s.q = start.q;
      s.held_v = start.v;
      s.held_tau = start.share * s.tau;
    } else if ((in_force & bit(k)) != 0) {
      see_held(s, state.q[i], static_cast<double>(state.qd[i]), static_cast<double>(state.tau[i]));
    }
    if (twinbus::is_soft(static_cast<double>(command.kp[i]), *s.of)) {
      s.faded = fade_s_;
      continue;
    }
    s.from_q = s.q - command.q[i];
    s.from_v = s.held_v - static_cast<double>(command.qd[i]);
    s.from_kp = std::max(s.kp, s.hold_kp) - static_cast<double>(command.kp[i]);
    s.from_kd = std::max(s.kd, s.hold_kd) - static_cast<double>(command.kd[i]);
    s.faded = 0.0;
  }
}

void ServoPredictor::move_set_points(const RobotState& state, const JointCommand& command) noexcept {
  const auto passed = [](std::int64_t since, std::int64_t tick, std::int64_t least) {
    return static_cast<double>(std::clamp<std::int64_t>(tick - since, least, kMostLeftOut));
  };
  const double looks = passed(looked_tick_, state.tick, 1), commands = passed(heard_tick_, command.tick, 0);
  // Of a stream that comes later here than to the gate, the last command is taken to go on.
  const double late = commands > 0.0 ? passed(command.tick, state.tick, 0) * period_ : 0.0;
  looked_tick_ = state.tick;
  heard_tick_ = command.tick;
  for (int k = 0; k < count_; ++k) {
    const auto i = at(k);
    Servo& s = servos_[i];
    s.faded += looks * period_;
    const QuinticFade fade = s.faded < fade_s_ ? quintic_fade(s.faded / fade_s_) : QuinticFade{};
    const double asked = std::clamp(command.q[i] + fade.h0 * s.from_q + fade.h1 * fade_s_ * s.from_v, s.lower, s.upper);
    if (commands > 0.0 && changed_) {
      s.client_speed = s.step = static_cast<double>(command.qd[i]);
      s.client_q = command.q[i];
      if ((held_now_ & bit_of(i)) == 0) s.heard_q = s.q = std::clamp(command.q[i], s.lower, s.upper);
    } else if (commands > 0.0) {
      const double moved = (command.q[i] - s.client_q) / (commands * period_);
      s.client_speed = agreed(moved, s.step);  // a step of a policy is none
      s.step = moved;
      s.client_q = command.q[i];
    }
    const double fading = s.from_q * fade.h0_rate / fade_s_ + s.from_v * fade.h1_rate;
    s.asked = asked;
    s.speed = s.client_speed + fading;
    s.qd = static_cast<double>(command.qd[i]) + fading;
    s.qd = std::clamp(s.qd, -s.most_speed, s.most_speed);
    // What overcomes friction moves nothing.
    const double tau = static_cast<double>(command.tau[i]) - coulomb_torque(*s.of, static_cast<double>(command.qd[i]));
    s.tau = std::clamp(tau, -s.effort, s.effort);
    s.kp = std::clamp(static_cast<double>(command.kp[i]) + fade.h0 * s.from_kp, 0.0, most_kp(*s.of));
    s.kd = std::clamp(static_cast<double>(command.kd[i]) + fade.h0 * s.from_kd, 0.0, most_kd(*s.of));
    const double before = s.q;
    if ((held_now_ & bit_of(i)) != 0) {
      brake_step(s.brake, looks * period_, s.q, s.held_v);
      s.heard_q = s.q = std::clamp(s.q, s.lower, s.upper);
      s.goes_on = asked;
    } else {
      s.heard_q = std::clamp(asked, s.heard_q - s.rate * looks * period_, s.heard_q + s.rate * looks * period_);
      s.goes_on = std::clamp(asked + s.speed * late, s.lower, s.upper);
      s.q = std::clamp(s.goes_on, s.heard_q - s.rate * late, s.heard_q + s.rate * late);
    }
    s.moved = std::clamp((s.q - before) / looks, -s.rate * period_, s.rate * period_);
  }
  changed_ = changed_ && !(commands > 0.0);
}

// Which joints are soft: by the gate's rules, and servos that move their joints slowly, as robot.yaml itself may say.
void ServoPredictor::gather(const RobotState& state, const JointCommand& command) noexcept {
  std::int64_t legs = 0, stray = 0;
  weak_ &= held_now_;
  for (int k = 0; k < count_; ++k) {
    const auto i = at(k);
    Servo& s = servos_[i];
    const double speed = std::max(std::abs(static_cast<double>(state.qd[i])), std::abs(s.speed));
    const bool held = (held_now_ & bit_of(i)) != 0;  // which keeps the joint from it
    const double off = std::min(std::abs(s.asked - state.q[i]), std::abs(command.q[i] - state.q[i]));  // a fade may be over, or not
    const bool far = !held && off > kFarSetPoint + kLags * speed;
    s.strays = far ? kStrays : std::max(0.0, s.strays - period_);
    if (s.leg) legs |= bit_of(i);
    if (s.strays > 0.0) stray |= bit_of(i);
    if (twinbus::is_soft(s.kp, *s.of) || s.kp < s.follows_kp) weak_ |= bit_of(i);
  }
  std::int64_t soft = weak_ | stray;
  if ((stray & legs) != 0) soft |= legs;  // who means torque with one joint of a leg does with all
  soft_ = soft & legs;
  if ((soft & ~legs) != 0) soft_ |= (bit(count_) - 1) & ~legs;
  moving_ = 0;
  for (int n = 0; n < count_; ++n) {
    const int k = order_[at(n)];
    if ((soft_ & bit_of(at(k))) == 0 || servos_[at(k)].leg) continue;
    of_bus_[at(moving_)] = k;
    joints_[at(moving_)] = servos_[at(k)].joint;
    ++moving_;
  }
}

// One implicit step: the torque of the end of the step, or its limit where that is beyond it.  With what is added to the
// diagonal, A, the change of speed dv follows from (H + A) dv = h (tau - bias) - A v.  Which torques are at their limits is
// found by Newton's method: a limit that is taken by the beginning of a step alone throws a light joint to and fro.  So is what
// runs into a stop, which throws what hangs on it.
TWINBUS_AVX2_CLONES
void ServoPredictor::step(double h) noexcept {
  for (int n = 0; n < moving_; ++n) {
    const Servo& s = servos_[at(of_bus_[at(n)])];
    Motion& m = motion_[at(n)];
    const Lanes zero{};
    const Lanes fast = m.set_v < 0.0 ? -m.set_v : m.set_v, left = fast - s.brake * h, slowed = left > 0.0 ? left : zero;
    const Lanes slower = m.set_v < 0.0 ? -slowed : slowed;
    const Lanes on = m.asked + s.speed * h, far = lanes(s.rate * h);
    m.set = m.braked ? m.set + 0.5 * (m.set_v + slower) * h : clamped(on, m.set - far, m.set + far);
    m.asked = m.braked ? m.asked : on;
    m.set_v = m.braked ? slower : m.set_v;
    m.set = clamped(m.set, lanes(m.lower), lanes(m.upper));
    m.torque = m.kp * (m.set - m.q) + m.kd * (m.braked ? m.set_v : lanes(s.qd)) + m.tau;
  }
  bool settled = false;
  for (int pass = 0; pass < kLimitPasses && !settled; ++pass) {
    bool same = has_factor_;
    for (int n = 0; n < moving_; ++n) {
      const auto i = at(n);
      const Servo& s = servos_[at(of_bus_[i])];
      const Motion& m = motion_[i];
      const Lanes stop = m.stopped != 0.0 ? lanes(kStop) : Lanes{};
      const Lanes added = h * s.damping + stop + (m.limited != 0.0 ? Lanes{} : h * m.kd + h * h * m.kp);
      same = same && !any(added != added_[i].x);
      added_[i].x = added;
      change_[i].x = h * ((m.limited != 0.0 ? m.limited * s.effort : m.torque) - bias_[i]) - added * m.v +
                     stop * ((m.stopped > 0.0 ? lanes(m.upper) : lanes(m.lower)) - m.q) / h;
    }
    if (!same) inertia_.factor(&added_[0].x, &factor_[0].x);
    has_factor_ = true;
    inertia_.solve(&factor_[0].x, &change_[0].x);
    settled = true;
    for (int n = 0; n < moving_; ++n) {
      const Servo& s = servos_[at(of_bus_[at(n)])];
      Motion& m = motion_[at(n)];
      const Lanes v = m.v + change_[at(n)].x, q = m.q + h * v;
      // At a stop already: it holds what would go on, and lets go what turns back.
      const Lanes end = m.stopped > 0.0 ? lanes(m.upper) : lanes(m.lower);
      const Lanes on = q > m.upper ? lanes(1.0) : q < m.lower ? lanes(-1.0) : Lanes{};
      const Lanes stopped = m.stopped != 0.0 ? (m.stopped * (end - q) > 0.0 ? Lanes{} : m.stopped) : on;
      settled = settled && !any(stopped != m.stopped);
      m.stopped = stopped;
      if (!(s.effort > 0.0)) continue;
      const Lanes then = m.torque - (h * m.kp + m.kd) * v;
      const Lanes limited = then > s.effort ? lanes(1.0) : then < -s.effort ? lanes(-1.0) : Lanes{};
      settled = settled && !any(limited != m.limited);
      m.limited = limited;
    }
  }
  for (int n = 0; n < moving_; ++n) {
    Motion& m = motion_[at(n)];
    m.v += change_[at(n)].x;
    m.v = m.stopped != 0.0 ? Lanes{} : m.v;
    m.q = clamped(m.q + h * m.v, lanes(m.lower), lanes(m.upper));
    m.q = m.stopped != 0.0 ? (m.stopped > 0.0 ? lanes(m.upper) : lanes(m.lower)) : m.q;
  }
}

void ServoPredictor::set_gains(Motion& m, const Servo& s) noexcept {
  m.kp = m.braked ? lanes(std::max(s.kp, s.hold_kp)) : lanes(s.kp);
  m.kd = m.braked ? lanes(std::max(s.kd, s.hold_kd)) : lanes(s.kd);
}

void ServoPredictor::brake_those(const Masks& masks) noexcept {
  has_factor_ = false;
  for (int n = 0; n < moving_; ++n) {
    const int k = of_bus_[at(n)];
    const Servo& s = servos_[at(k)];
    Motion& m = motion_[at(n)];
    const bool soft = twinbus::is_soft(s.kp, *s.of);
    for (int lane = 0; lane < kLanes; ++lane) {
      if ((masks[at(lane)] & bit(k)) == 0 || m.braked[lane] != 0) continue;
      m.braked[lane] = -1;
      const BrakeStart start = brake_start(m.set[lane], s.qd, m.q[lane], m.v[lane], s.most_speed, soft);
      m.set[lane] = start.q + 0.5 * start.v * period_;
      m.set_v[lane] = start.v;
      m.tau[lane] = start.share * s.tau;
    }
    set_gains(m, s);
  }
}

// What is written for a tick stands still in it.  Its mean is kept: set-points move on evenly, half a tick sooner.
// A mask a lane, to courses_ from `first` on: what is held of these stays so, of others the brake comes a tick sooner.
TWINBUS_AVX2_CLONES
void ServoPredictor::run(const Masks& masks, std::size_t first) noexcept {
  for (int n = 0; n < moving_; ++n) {
    const auto k = at(of_bus_[at(n)]);
    const Servo& s = servos_[k];
    Motion& m = motion_[at(n)];
    m = {};
    m.v = lanes(v_[k]);
    m.set = lanes(s.q - 0.5 * s.moved - q_[k]);
    m.asked = lanes(s.goes_on - q_[k]);
    m.lower = std::min(s.lower - q_[k], 0.0);
    m.upper = std::max(s.upper - q_[k], 0.0);
    m.tau = lanes(s.tau);
    const double far = 0.5 * s.rate * period_;  // what is let go now moves at once
    for (int lane = 0; lane < kLanes && (held_now_ & bit_of(k)) != 0; ++lane) {
      if ((masks[at(lane)] & bit_of(k)) == 0) {
        m.set[lane] = std::clamp(m.asked[lane], s.q - q_[k] - far, s.q - q_[k] + far);
        continue;
      }
      m.braked[lane] = -1;
      m.set_v[lane] = s.held_v;
      m.tau[lane] = s.held_tau;
    }
    set_gains(m, s);
  }
  has_factor_ = false;
  for (int tick = 0; tick <= delay_ticks_; ++tick) {
    if (tick == delay_ticks_) brake_those(masks);
    for (int part = 0; part < kPartsOfTick; ++part) step(period_ / kPartsOfTick);
  }
  Masks all;
  all.fill(~std::int64_t{0});
  brake_those(all);
  for (int part = 0; part < 2 && lag_ > 0.0; ++part) step(0.5 * lag_);
  for (int n = 0; n < moving_; ++n) {
    Motion& m = motion_[at(n)];
    m.first = m.least = m.most = m.q;
    m.speed = m.v;
  }
  has_factor_ = false;
  Flags moves = ~Flags{};  // a lane that rests does so whatever the other one does
  for (int part = 0; part < kMostBrakeSteps && any(moves); ++part) {
    step(kBrakeStep);
    Flags still{};
    for (int n = 0; n < moving_; ++n) {
      Motion& m = motion_[at(n)];
      m.least = (moves & (m.q < m.least)) ? m.q : m.least;
      m.most = (moves & (m.q > m.most)) ? m.q : m.most;
      still |= (m.v * m.speed > 0.0) & ((m.v > kRests) | (m.v < -kRests));
    }
    moves &= still;
  }
  for (int n = 0; n < moving_; ++n) {
    const auto k = at(of_bus_[at(n)]);
    const Motion& m = motion_[at(n)];
    for (int lane = 0; lane < kLanes; ++lane) {
      const double up = m.most[lane] - m.first[lane], down = m.least[lane] - m.first[lane];
      courses_[first + at(lane)][k] = ends_at(m.first[lane], m.speed[lane], up > -down ? up : down, servos_[k].brake);
    }
  }
}

// What was looked at before is not again: nothing held, all of them, what was kept, and the last masks.
void ServoPredictor::look_masked(std::int64_t mask, std::int64_t next) noexcept {
  const std::int64_t asked = mask & all_moving_, after = next & all_moving_;
  const auto end = masked_of_.begin() + static_cast<std::ptrdiff_t>(known_), known = std::find(masked_of_.begin(), end, asked);
  shown_ = static_cast<std::size_t>(known - masked_of_.begin());
  if (known != end) return;
  const Masks masks{asked, after, after, after};
  run(masks, kMasked);
  std::copy(masks.begin(), masks.end(), masked_of_.begin() + kMasked);
  known_ = masked_of_.size();
  shown_ = kMasked;
}

void ServoPredictor::look(const RobotState& state, const Kinematics& kinematics, const Configuration& configuration,
                          std::int64_t kept, std::int64_t others) noexcept {
  for (int k = 0; k < count_; ++k) {
    const Servo& s = servos_[at(k)];
    if (!is_soft(at(k)) || !s.leg) continue;
    const double speed = static_cast<double>(state.qd[at(k)]);
    for (PerJoint<Course>& courses : courses_) courses[at(k)] = {speed * delay_, speed, s.brake};
  }
  all_moving_ = 0;
  for (int n = 0; n < moving_; ++n) all_moving_ |= bit(of_bus_[at(n)]);
  const Masks masks{0, all_moving_, kept & all_moving_, (kept | on_hold() | others) & all_moving_};
  std::copy(masks.begin(), masks.end(), masked_of_.begin());
  known_ = masks.size();
  if (moving_ == 0) return;
  q_ = state.q;
  for (int k = 0; k < count_; ++k) v_[at(k)] = static_cast<double>(state.qd[at(k)]);
  inertia_.update(kinematics, std::span(joints_).first(at(moving_)));
  dynamics_.solve(kinematics, configuration, no_acceleration_, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), nothing_,
                  torque_);
  for (int n = 0; n < moving_; ++n) bias_[at(n)] = torque_[joints_[at(n)]];
  run(masks, kObeyed);
}

void ServoPredictor::follow(const RobotState& state, const JointCommand& command, std::int64_t mask,
                            const Kinematics& kinematics, const Configuration& configuration, std::int64_t kept,
                            std::int64_t others) noexcept {
  if (state.stop_kind > StopKind::kBalanced) return reset();  // the source holds the robot, and begins anew from there
  hear(state, command);
  for (std::size_t i = masks_.size(); i-- > 1;) masks_[i] = masks_[i - 1];
  masks_[0] = mask;
  hold(state, command);
  move_set_points(state, command);
  gather(state, command);
  if (soft_ == 0) return;
  look(state, kinematics, configuration, kept, others);
}

}  // namespace twinbus::control
