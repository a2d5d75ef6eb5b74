#include "control/point_feet/point_feet.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "common/math/quintic_fade.h"
#include "robot/dynamics/joint_friction.h"

namespace twinbus::inline control {

namespace {
// Natural frequencies in those of the pendulum, damping ratios.
constexpr double kUp = 2.2, kUpDamping = 0.9;
constexpr double kTurning = 2.6, kTurnDamping = 0.8;
constexpr double kLevelling = 1.3, kLevelDamping = 0.9;
constexpr double kTrotLevel = 0.9, kTrotRate = 2.0;  // the second: of the velocity alone, in frequencies of the pendulum
constexpr double kFriction = 0.5;     // that feet count on
constexpr double kMostForce = 1.2;    // of a foot, in weights
constexpr double kRamp = 0.03;        // of the force of a foot that has come down or is about to leave [s]
constexpr double kCrawlRamp = 0.5;    // of a crawl, in shifts
constexpr double kStanceKp = 0.15, kStanceKd = 0.4, kSwingKp = 1.0, kSwingKd = 1.0;  // of the gains of robot.yaml
constexpr double kOmegaFilter = 0.004, kBaseFilter = 0.03;  // [s]
constexpr double kFollowStep = 0.2, kFollowStand = 2.0;  // an anchor follows its foot in so long [s]
constexpr double kFade = 0.03;        // of what a foot is off its set-point as it lands or leaves [s]
constexpr double kSettle = 0.6;       // from where it is to where it stands [s]
constexpr double kSpeedUp = 0.12, kBrake = 0.3, kCrawlSpeedUp = 0.02;  // of g
constexpr double kLeash = 0.25;       // of the height: so far is the reference of a walk from the robot
constexpr double kCaught = 0.85;      // of the half length and width: the capture point is beyond, it steps
constexpr double kTips = 0.15;        // of the half width: so far outside the feet that stand, the capture point of a crawl is lost
constexpr double kInwards = 0.7;      // of the half width: a foot may come down so far towards the other side
constexpr double kBelow = 0.02;       // of the height: a foot is sent so far below the ground, to meet it
constexpr double kNear = 0.12;        // of the height: feet that are so near to their stance may rest
constexpr double kSlow = 0.12;        // of sqrt(g h): so slow it may rest
constexpr int kLastPeriods = 8;       // after which it rests all the same
constexpr double kTrim = 0.14, kMostTrim = 0.18;  // of what a walk on two feet misses, in frequencies of the pendulum; of sqrt(g h)
constexpr int kRounds = 40;           // of the force share
constexpr double kDampedLeg = 0.03;   // of the reach: legs that are stretched are moved no faster than this
constexpr double kFarthestWay = 0.12; // of a foot from its set-point [m]
constexpr double kRestSpeed = 0.03;   // [m/s]
constexpr int kRestFeet = 3;

int standing_feet(const Estimator& estimator) noexcept {
  const StandingFeet* feet = estimator.feet();
  int count = 0;
  for (int foot = 0; feet != nullptr && foot < feet->count(); ++foot) count += feet->stands(foot) ? 1 : 0;
  return count;
}
}  // namespace

PointFeet::PointFeet(const Model& model)
    : Behavior(model),
      model_(&model),
      body_(model),
      gait_(step_gait_of(model)),
      crawl_(body_),
      share_(body_.mass * kGravity, 0.5 * (body_.length + body_.width), kFriction),
      dynamics_(model),
      leg_kp_(kp_),
      leg_kd_(kd_),
      stance_(body_.posture),
      stance_torque_(q_) {
  wrench_.resize(body_.legs.size());
  const double each = 1.0 / static_cast<double>(body_.legs.size());
  forces_.fill(Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    wrench_[i].link = body_.legs[i].link;
    for (const int j : body_.legs[i].joints) leg_[at(j)] = true;
  }
  Configuration c(model);
  c.q = stance_;
  Kinematics k(model);
  k.update(c);
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    wrench_[i].point = k.link_in_world(body_.legs[i].link) * body_.centre[i];
    wrench_[i].force << 0.0, 0.0, each * body_.mass * kGravity;
  }
  (void)dynamics_.solve(k, c, qdd_, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), wrench_, stance_torque_);
}

bool PointFeet::may_start(const Estimator& estimator) const noexcept {
  return standing_feet(estimator) >= (body_.two() ? 1 : kRestFeet) && estimator.tilt() < kMayTilt;
}

bool PointFeet::stands(const Estimator& estimator) const noexcept { return standing_feet(estimator) > 0; }

void PointFeet::start(const Estimator& estimator) noexcept {
  fresh_ = true;
  measure(estimator, 0.0);
  walks_ = halts_ = false;
  velocity_wanted_ = wanted_ = Eigen::Vector3d::Zero();
  gait_.rest();
  lifts_ = -1;
  trim_.setZero();
  pressed_ = com_.head<2>();
  share_.reset();
  for (Leg& leg : legs_) {
    leg.anchor = leg.target = leg.point;
    leg.swings = leg.led = false;
    leg.way.setZero();
    leg.fading.setZero();
  }
  yaw_reference_ = yaw_;
  velocity_.setZero();  // of one tick it is noise
  stand_still();
  first_turn_ = rotation_vector(rotation_z(-yaw_) * base_);
  first_turn_.z() = 0.0;
  first_.rest(1.0);
  first_.aim(0.0, kSettle);
  finite_ = true;
}

// Where the centre of mass belongs above feet as they stand, on the ground, and their heading.
Eigen::Vector3d PointFeet::home(double& yaw) const noexcept {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  Eigen::Vector2d stance = Eigen::Vector2d::Zero();
  double along = 0.0, across = 0.0;
  const double each = 1.0 / static_cast<double>(body_.legs.size());
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    middle += each * legs_[i].anchor;
    stance += each * body_.stance[i];
  }
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    const Eigen::Vector2d a = body_.stance[i] - stance;
    const Eigen::Vector2d b = (legs_[i].anchor - middle).head<2>();
    along += a.dot(b);
    across += a.x() * b.y() - a.y() * b.x();
  }
  yaw = std::atan2(across, along);
  middle.head<2>() -= Eigen::Rotation2Dd(yaw) * stance;
  return middle;
}

// Its feet stay where they are: from here the centre of mass goes home.
void PointFeet::stand_still() noexcept {
  double yaw = 0.0;
  const Eigen::Vector3d middle = home(yaw);
  const Eigen::Matrix3d to_feet = rotation_z(-yaw);
  motion_.start({0.0, 0.0, body_.height}, to_feet * (com_ - middle), to_feet * velocity_, kSettle);
  height_.rest(com_.z() - middle.z());
}

void PointFeet::walk(bool on) noexcept {
  walks_ = on;
  if (on) halts_ = false;
  if (!on) wanted_.setZero();
}

void PointFeet::want(const Eigen::Vector3d& velocity) noexcept {
  if (!walks_ || halts_ || !velocity.allFinite()) return;
  wanted_ = gait_.possible(velocity);
}

void PointFeet::leave_walk(bool at_once, bool, bool) noexcept {
  walk(false);
  if (!at_once) return;
  halts_ = true;
  motion_.stop(kSettle);
}

BehaviorReport PointFeet::report(const Estimator& estimator) const noexcept {
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  const Eigen::Vector3d com = world_in_ground * com_, velocity = world_in_ground.linear() * velocity_;
  return {com, velocity, world_in_ground * reference_, com.head<2>() + velocity.head<2>() / gait_.omega(),
          (world_in_ground * estimator.zmp()).head<2>()};
}

bool PointFeet::resting() const noexcept {
  if (body_.two()) return velocity_wanted_.norm() < 1e-3 && quiet_ > 2.0 * gait_.period();
  return !gait_.steps() && motion_.resting() && velocity_.head<2>().norm() < kRestSpeed;
}

void PointFeet::measure(const Estimator& estimator, double dt) noexcept {
  const Configuration& now = estimator.configuration();
  com_ = estimator.kinematics().com();
  const double share = fresh_ ? 1.0 : dt / (dt + kOmegaFilter);
  omega_ += share * (now.base_angular_velocity - omega_);
  // Turned on by its rate, and pulled to what is measured, which is noisier.
  base_ = fresh_ ? Eigen::Matrix3d(now.base.linear()) : Eigen::Matrix3d(rotation_of(dt * omega_) * base_);
  base_ = rotation_of(dt / (dt + kBaseFilter) * rotation_vector(now.base.linear() * base_.transpose())) * base_;
  yaw_ = yaw_of(base_);
  velocity_ = now.base_velocity + omega_.cross(com_ - now.base.translation());
  fresh_ = false;
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    legs_[i].point = estimator.kinematics().link_in_world(body_.legs[i].link) * body_.centre[i];
    legs_[i].point.z() -= body_.radius[i];
  }
}

FourPoints PointFeet::anchors() const noexcept {
  FourPoints places;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = legs_[i].anchor.head<2>();
  return places;
}

void PointFeet::begin_gait(bool crawls, bool backwards) noexcept {
  double yaw = 0.0;
  height_.aim_from(motion_.position().z(), motion_.velocity().z(), 0.0, body_.height, kSettle);
  reference_.head<2>() = com_.head<2>();
  yaw_reference_ = yaw_;
  if (crawls) {
    crawl_.start(com_.head<2>(), home(yaw).head<2>());
    gait_.begin_crawl(backwards);
  } else {
    gait_.begin();
  }
}

// Its feet are near to where they stand best, and it is slow.
bool PointFeet::may_rest() const noexcept {
  double far = 0.0;
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    const Eigen::Vector2d middle = gait_.crawls() ? crawl_.middle() : Eigen::Vector2d(com_.head<2>());
    const Eigen::Vector2d from_middle = legs_[i].anchor.head<2>() - middle;
    far = std::max(far, (Eigen::Rotation2Dd(-yaw_) * from_middle - body_.stance[i]).norm());
  }
  return far < kNear * body_.height && velocity_.head<2>().norm() < kSlow * body_.height * gait_.omega() &&
         velocity_wanted_.norm() < 1e-3;
}

// Whether it steps, and how.
void PointFeet::decide(double dt) noexcept {
  const bool wanted = walks_ && !halts_ && (wanted_.head<2>().norm() > 0.0 || wanted_.z() != 0.0);
  const bool crawls = gait_.crawls_at(wanted_);
  const bool backwards = crawls && gait_.backwards_at(wanted_);
  const bool same = crawls == gait_.crawls() && (!crawls || backwards == gait_.backwards());
  const bool asked = wanted && (same || !gait_.steps());  // else it stands first
  stays_ = wanted && !asked;
  quiet_ = asked ? 0.0 : quiet_ + dt;
  if (body_.two()) return begin_steps(dt);
  double yaw = 0.0;
  const Eigen::Vector3d middle = home(yaw);
  const Eigen::Vector2d ahead = (com_ + velocity_ / gait_.omega()).head<2>();
  const Eigen::Vector2d capture = Eigen::Rotation2Dd(-yaw) * (ahead - middle.head<2>());
  bool lost = std::abs(capture.x()) > kCaught * body_.length || std::abs(capture.y()) > kCaught * body_.width;
  if (!gait_.steps()) {
    if (!asked && !lost) return;
    begin_gait(crawls && !lost, backwards);
    quiet_ = 0.0;
    return;
  }
  for (int leg = 0; gait_.crawls() && leg < 4; ++leg)
    lost = lost || (gait_.swings(leg) && inside_others(anchors(), leg, ahead) < -kTips * body_.width);
  if (gait_.crawls() && lost) {
    gait_.trot_on();
    reference_.head<2>() = com_.head<2>();
  }
  if (asked) return gait_.go_on();
  if (gait_.crawls() && (halts_ || stays_)) return gait_.end();  // it stands wherever its feet are
  if (quiet_ > gait_.period() && !lost && (may_rest() || quiet_ > kLastPeriods * gait_.period())) {
    gait_.end();
  } else {
    gait_.go_on();
  }
}

// On two feet it steps all the time.  Before the first step the foot that is to be lifted presses, until the capture point is as near
// to the other one as when a step begins.
void PointFeet::begin_steps(double dt) noexcept {
  if (gait_.steps()) {
    // Legs that swing and feet that share the load for a while make it slower than the pendulum that the footholds are for.
    const Eigen::Vector2d seen = (rotation_z(-yaw_) * velocity_).head<2>();
    trim_ += dt * kTrim * gait_.omega() * (velocity_wanted_.head<2>() - seen);
    const double most = kMostTrim * body_.height * gait_.omega();
    trim_ = trim_.cwiseMax(-most).cwiseMin(most);
    return;
  }
  if (lifts_ < 0) {
    double yaw = 0.0;
    const Eigen::Vector3d middle = home(yaw);
    lifts_ = (rotation_z(-yaw) * (com_ + velocity_ / gait_.omega() - middle)).y() > 0.0 ? 1 : 0;
    height_.aim_from(motion_.position().z(), motion_.velocity().z(), 0.0, body_.height, kSettle);
  }
  const Eigen::Vector2d stands = legs_[at(1 - lifts_)].point.head<2>(), lifts = legs_[at(lifts_)].point.head<2>();
  const Eigen::Vector2d capture = (com_ + velocity_ / gait_.omega()).head<2>();
  const double inward = (capture - stands).dot(lifts - stands) / std::max(1e-6, (lifts - stands).squaredNorm());
  if (inward > gait_.inward()) return;
  gait_.begin(lifts_);
  lifts_ = -1;
}

// Where the trunk is to be.
void PointFeet::move_reference(double dt) noexcept {
  const bool crawls = gait_.steps() && gait_.crawls();
  const double most = dt * kGravity * (halts_ ? kBrake : crawls ? kCrawlSpeedUp : kSpeedUp);
  const Eigen::Vector3d off = (stays_ ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : wanted_) - velocity_wanted_;
  const double level = off.head<2>().norm(), turn = std::abs(off.z()) * body_.height;
  velocity_wanted_.head<2>() += off.head<2>() * (level > most ? most / level : 1.0);
  velocity_wanted_.z() += off.z() * (turn > most ? most / turn : 1.0);
  if (gait_.steps()) {
    height_.advance(dt);
    yaw_reference_ += dt * velocity_wanted_.z();
    yaw_reference_ = yaw_ + std::clamp(wrap_angle(yaw_reference_ - yaw_), -0.3, 0.3);
    const Eigen::Vector3d level_velocity(velocity_wanted_.x(), velocity_wanted_.y(), 0.0);
    const Eigen::Vector3d velocity = rotation_z(yaw_reference_) * level_velocity;
    reference_ += dt * velocity;
    const Eigen::Vector2d lead = (reference_ - com_).head<2>();
    const double leash = kLeash * body_.height;
    if (lead.norm() > leash) reference_.head<2>() = com_.head<2>() + lead * (leash / lead.norm());
    reference_.z() = ground_ + height_.position();
    reference_velocity_ = velocity + height_.velocity() * Eigen::Vector3d::UnitZ();
    reference_acceleration_ = height_.acceleration() * Eigen::Vector3d::UnitZ();
    if (crawls) {
      const Eigen::Vector2d off_com = crawl_.position() - com_.head<2>();
      if (off_com.norm() > leash) crawl_.move(off_com * (leash / off_com.norm() - 1.0));
      reference_.head<2>() = crawl_.position();
      reference_velocity_.head<2>() = crawl_.velocity();
      reference_acceleration_.head<2>() = crawl_.acceleration();
    }
  } else {
    if (body_.two()) height_.advance(dt);
    motion_.advance(dt);
    double yaw = 0.0;
    const Eigen::Vector3d middle = home(yaw);
    const Eigen::Matrix3d turned = rotation_z(yaw);
    reference_ = middle + turned * motion_.position();
    reference_velocity_ = turned * motion_.velocity();
    reference_acceleration_ = turned * motion_.acceleration();
    yaw_reference_ += std::min(1.0, dt / kSettle) * wrap_angle(yaw - yaw_reference_);
  }
  if (body_.two()) {  // it goes where its feet let it fall
    reference_ << com_.head<2>(), ground_ + height_.position();
    reference_velocity_ << velocity_.head<2>(), height_.velocity();
    reference_acceleration_ << gait_.omega() * gait_.omega() * (com_.head<2>() - pressed_), height_.acceleration();
  }
  base_reference_ = rotation_z(yaw_reference_) * rotation_of(first_.position() * first_turn_);
}

void PointFeet::place_feet(double dt) noexcept {
  const bool stepped = gait_.steps();
  const bool crawls = stepped && gait_.crawls();
  gait_.advance(dt, !crawls || crawl_.may_lift(gait_, anchors(), com_.head<2>(), (com_ + velocity_ / gait_.omega()).head<2>()));
  if (stepped && !gait_.steps()) stand_still();
  double ground = 0.0, feet = 0.0;
  const Eigen::Matrix3d heading = rotation_z(yaw_);
  const Eigen::Vector3d asked = heading * Eigen::Vector3d(velocity_wanted_.x(), velocity_wanted_.y(), 0.0);
  if (crawls) crawl_.update(gait_, anchors(), asked.head<2>(), yaw_reference_, velocity_wanted_.z(), dt);
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    Leg& leg = legs_[i];
    const bool swings = gait_.swings(static_cast<int>(i));
    if (swings != leg.swings) leg.anchor = leg.point;  // it leaves from here, or stands here
    leg.swings = swings;
    if (!swings) {
      leg.anchor += std::min(1.0, dt / (gait_.steps() ? kFollowStep : kFollowStand)) * (leg.point - leg.anchor);
      ground += leg.anchor.z();
      feet += 1.0;
      continue;
    }
    const int number = static_cast<int>(i);
    if (crawls) {
      leg.target.head<2>() = crawl_.foothold(number);
      continue;
    }
    const double left = body_.two() ? gait_.until_load(number) : (1.0 - gait_.swing_done(number)) * gait_.swing_time();
    const double turn = velocity_wanted_.z() * (left + 0.5 * gait_.stance_time());
    const Eigen::Vector3d hip = heading * rotation_z(turn) * Eigen::Vector3d(body_.stance[i].x(), body_.stance[i].y(), 0.0);
    const Eigen::Vector2d below = (com_ + left * velocity_ + hip).head<2>();
    Eigen::Vector2d step = (0.5 * gait_.stance_time() * asked + (velocity_ - asked) / gait_.omega()).head<2>();
    if (body_.two()) {
      const Eigen::Vector2d other = legs_[1 - i].point.head<2>();
      const Eigen::Vector2d now = (com_ + velocity_ / gait_.omega()).head<2>();
      const Eigen::Vector2d capture = other + std::exp(gait_.omega() * left) * (now - other);
      const Eigen::Vector2d away = gait_.from_capture_point(number, velocity_wanted_.head<2>() + trim_, 2.0 * body_.width);
      step = capture + (heading * Eigen::Vector3d(away.x(), away.y(), 0.0)).head<2>() - below;
    }
    if (step.norm() > gait_.farthest()) step *= gait_.farthest() / step.norm();
    // Towards the other side no farther than leaves room below the trunk.
    const Eigen::Vector2d aside = (heading * Eigen::Vector3d(0.0, body_.stance[i].y() > 0.0 ? 1.0 : -1.0, 0.0)).head<2>();
    step += std::max(0.0, -kInwards * body_.width - aside.dot(step)) * aside;
    leg.target.head<2>() = below + step;
  }
  if (feet > 0.0) ground_ = ground / feet;
  for (Leg& leg : legs_) leg.target.z() = ground_ - kBelow * body_.height;
}

// Forces of the feet, and torques of all joints with them.
void PointFeet::push(const Estimator& estimator) noexcept {
  const double w = gait_.omega();
  TrunkWrench wanted;
  const bool steps = gait_.steps();
  const bool falls_on = steps && !gait_.crawls();
  const double level = falls_on ? kTrotLevel * w : kLevelling * w;
  const double rate = falls_on ? kTrotRate * w : 2.0 * kLevelDamping * kLevelling * w;
  const Eigen::Vector3d off = reference_ - com_, drift = reference_velocity_ - velocity_;
  wanted.force.head<2>() = body_.mass * (level * level * off + rate * drift + reference_acceleration_).head<2>();
  wanted.force.z() = body_.mass * std::max(0.0, kGravity + kUp * kUp * w * w * off.z() + 2.0 * kUpDamping * kUp * w * drift.z() +
                                                    reference_acceleration_.z());
  const Eigen::Vector3d turn = rotation_vector(base_reference_ * base_.transpose());
  const Eigen::Vector3d spin = velocity_wanted_.z() * Eigen::Vector3d::UnitZ() - omega_;
  const Eigen::Matrix3d inertia = base_ * body_.inertia * base_.transpose();
  wanted.moment = inertia * (kTurning * kTurning * w * w * turn + 2.0 * kTurnDamping * kTurning * w * spin);
  std::array<PointFoot, kPointFeet> feet;
  pressed_.setZero();
  double all = 0.0;
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    feet[i].arm = legs_[i].point - com_;
    const double done = gait_.stance_done(static_cast<int>(i));
    double share = legs_[i].swings ? 0.0 : 1.0;
    const double ramp = falls_on ? kRamp : kCrawlRamp * gait_.shift_time();
    if (steps) share *= std::clamp(std::min(done, 1.0 - done) * gait_.stance_time() / ramp, 0.0, 1.0);
    if (lifts_ >= 0) share = static_cast<int>(i) == lifts_ ? 1.0 : 0.0;
    feet[i].most = share * kMostForce * body_.mass * kGravity;
    pressed_ += share * legs_[i].point.head<2>();
    all += share;
  }
  if (body_.two() && !(feet[0].most > 0.0 && feet[1].most > 0.0)) wanted.moment.z() = 0.0;  // which no point gives
  pressed_ = all > 0.0 ? Eigen::Vector2d(pressed_ / all) : Eigen::Vector2d(com_.head<2>());
  forces_ = share_.solve(feet, wanted, kRounds);
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    wrench_[i].point = legs_[i].point;
    wrench_[i].force = forces_[i];
  }
  qdd_.setZero();
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  (void)dynamics_.solve(estimator.kinematics(), estimator.configuration(), qdd_, none, none, wrench_, tau_);
}

// Set-points of a leg whose foot is to go a way, at a rate, both seen from the base, world axes.
void PointFeet::lead(const Estimator& estimator, std::size_t i, const Eigen::Vector3d& way,
                     const Eigen::Vector3d& rate) noexcept {
  const Kinematics& k = estimator.kinematics();
  const std::vector<int>& joints = body_.legs[i].joints;
  const auto column = [&](int j) -> Eigen::Vector3d {
    const Eigen::Vector3d& axis = k.axis_in_world(j);
    if (model_->joints[at(j)].kind == JointKind::kPrismatic) return axis;
    return axis.cross(legs_[i].point - k.link_in_world(j + 1).translation());
  };
  Eigen::Matrix3d square = std::pow(kDampedLeg * body_.reach, 2) * Eigen::Matrix3d::Identity();
  for (const int j : joints) square += column(j) * column(j).transpose();
  const Eigen::LDLT<Eigen::Matrix3d> solver(square);
  const double far = way.norm();
  const Eigen::Vector3d w = solver.solve(far > kFarthestWay ? Eigen::Vector3d(way * (kFarthestWay / far)) : way);
  const Eigen::Vector3d r = solver.solve(rate);
  for (const int j : joints) {
    q_[j] = estimator.configuration().q[j] + column(j).dot(w);
    qd_[j] = column(j).dot(r);
  }
}

void PointFeet::lead_legs(const Estimator& estimator, double dt) noexcept {
  const Configuration& now = estimator.configuration();
  q_ = now.q;
  qd_.setZero();
  for (std::size_t i = 0; i < body_.legs.size(); ++i) {
    Leg& leg = legs_[i];
    Eigen::Vector3d way, rate;
    if (leg.swings) {
      const double t = std::clamp(gait_.swing_done(static_cast<int>(i)), 0.0, 1.0), per_s = 1.0 / gait_.swing_time();
      const Eigen::Vector3d whole = leg.target - leg.anchor;
      const QuinticFade left = quintic_fade(t);
      const double bump = 16.0 * t * t * (1.0 - t) * (1.0 - t);
      const double bump_rate = 32.0 * t * (1.0 - t) * (1.0 - 2.0 * t) * per_s;
      const Eigen::Vector3d place = leg.anchor + (1.0 - left.h0) * whole + bump * gait_.lift() * Eigen::Vector3d::UnitZ();
      way = now.base.linear() * base_.transpose() * (place - com_) - (leg.point - com_);
      rate = -left.h0_rate * per_s * whole + bump_rate * gait_.lift() * Eigen::Vector3d::UnitZ() - now.base_velocity -
             now.base_angular_velocity.cross(leg.point - now.base.translation());
    } else {
      way = leg.anchor - leg.point;
      rate = -reference_velocity_ - velocity_wanted_.z() * Eigen::Vector3d::UnitZ().cross(leg.point - com_);
    }
    // A set-point that jumps is a speed to whoever looks ahead.
    if (leg.swings != leg.led) leg.fading = leg.way - way;
    leg.led = leg.swings;
    leg.fading -= std::min(1.0, dt / kFade) * leg.fading;
    leg.way = way + leg.fading;
    lead(estimator, i, leg.way, rate);
    for (const int j : body_.legs[i].joints) {
      kp_[j] = leg_kp_[j] * (leg.swings ? kSwingKp : kStanceKp);
      kd_[j] = leg_kd_[j] * (leg.swings ? kSwingKd : kStanceKd);
    }
  }
}

void PointFeet::update(const Estimator& estimator, const Eigen::VectorXd&, double dt) noexcept {
  if (std::exchange(resumes_, false)) {
    const bool walks = walks_;
    start(estimator);
    walks_ = walks;
  }
  measure(estimator, dt);
  first_.advance(dt);
  decide(dt);
  place_feet(dt);
  move_reference(dt);
  push(estimator);
  lead_legs(estimator, dt);
  add_friction(*model_, qd_, tau_);
  look_for_nan();
}

}  // namespace twinbus::control
