#include "control/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "control/walk/listed_steps.h"
#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr int kFirstRounds = 10;
constexpr double kLeastLoad = 0.05;  // of the weight, on feet that tell where the ground is
constexpr double kWeighing = 1.0;    // in which what the robot carries is weighed [s]
constexpr double kLightest = 0.7, kHeaviest = 1.5;  // that it is taken for, of its own weight
constexpr double kRestSpeed = 0.02;                 // of the centre of mass [m/s]
constexpr double kRestPlace = 0.006;  // of it and the ZMP, from the middle of the feet [m]
constexpr double kFlatTilt = 0.035;   // of a sole on ground that feet without force sensors may walk on [rad]
constexpr double kFlatStep = 0.008;   // between such soles [m]
constexpr double kTiltFilter = 0.03;  // [s]
constexpr double kUnfeltShare = 0.4;  // of the fastest walk
constexpr double kUnfelt = 0.1;       // no force at all for so long: the sensors are not there [s]

// Whether the feet have force sensors; whether the soles that stand, do so on flat ground.
bool feels(const Estimator& estimator) noexcept {
  return estimator.sole_force(0).z() != 0.0 || estimator.sole_force(1).z() != 0.0;
}

bool stands_flat(const Estimator& estimator) noexcept {
  const auto tilt = [&](int f) { return estimator.sole_in_world(f).linear().col(2).head<2>().norm(); };
  const double step = (estimator.sole_in_world(0).translation() - estimator.sole_in_world(1).translation()).z();
  return std::max(tilt(0), tilt(1)) < kFlatTilt && std::abs(step) < kFlatStep;
}
}  // namespace

Walk::Walk(const Model& model, const WalkGains& gains)
    : Behavior(model),
      model_(&model),
      gains_(gains),
      pattern_(gait_of(model, model.walking, gains.stabilizer.margin), gains.swing),
      stabilizer_(gains.stabilizer),
      feet_(model, gains.feet),
      ik_(model),
      dynamics_(model),
      mass_(model.total_mass()),
      ground_(gains.ground) {
  wrench_.resize(2);
  for (std::size_t f = 0; f < 2; ++f) wrench_[f].link = model.soles[f].link;
  for (int j = 0; j < model.joint_count(); ++j) leg_[at(j)] = ik_.is_leg(j);
}

double Walk::omega() const noexcept {
  return std::sqrt(std::max(2.0, kGravity + vertical_acceleration()) /
                   std::max(0.2, height_.position()));
}

Eigen::Vector3d Walk::com_reference() const noexcept {
  return {stabilizer_.com().x(), stabilizer_.com().y(), height_.position() + ground_.height()};
}

Eigen::Vector3d Walk::reference_velocity() const noexcept {
  return {stabilizer_.velocity().x(), stabilizer_.velocity().y(), height_.velocity() + ground_.velocity()};
}

Eigen::Vector3d Walk::reference_acceleration() const noexcept {
  const double w = omega();
  Eigen::Vector3d acceleration(0.0, 0.0, vertical_acceleration());
  acceleration.head<2>() = w * w * (stabilizer_.com() - stabilizer_.zmp());
  return acceleration;
}

bool Walk::resting() const noexcept {
  return pattern_.settled() && com_velocity_.head<2>().norm() < kRestSpeed &&
         (pattern_.rest() - pattern_.middle()).norm() < kRestPlace &&
         (stabilizer_.com() - pattern_.middle()).norm() < kRestPlace;
}

// Upright with the heading of the feet, but for what is left of the attitude at the start.
Eigen::Matrix3d Walk::attitude() const noexcept {
  return rotation_z(heading_) * rotation_of(first_.position() * first_turn_);
}

const char* Walk::follow(const StepList& list) noexcept {
  if (!pattern_.settled())
    return "a list of footsteps begins where the robot stands, and it walks; it goes on as it was";
  if (const char* why = check_steps(gait(), list).why) return why;
  std::array<Foothold, kMostSteps> places;
  const int count = place_steps(list, {pattern_.foot(0), pattern_.foot(1)}, places);
  pattern_.follow(places.data(), count, 1 - first_foot(list));
  return nullptr;
}

void Walk::measure(const Estimator& estimator, double dt, bool fresh) noexcept {
  const Kinematics& k = estimator.kinematics();
  const double share = fresh ? 1.0 : dt / (dt + gains_.velocity_filter);
  com_ = k.com();
  com_velocity_ += share * (estimator.com_velocity() - com_velocity_);
  dcm_ = com_.head<2>() + estimator.dcm_velocity() / omega();
  // Without force sensors the feet are taken to carry what they are asked to.
  unfelt_ = feels(estimator) ? 0.0 : fresh ? kUnfelt : unfelt_ + dt;
  feels_ = unfelt_ < kUnfelt;
  double carried = 0.0, lower = 0.0;  // by feet that stand; load times what they are too low
  for (int f = 0; f < 2; ++f) {
    const Eigen::Isometry3d& sole = estimator.sole_in_world(f);
    Foothold& foot = measured_feet_[at(f)];
    foot.position = sole.translation().head<2>();
    foot.set_yaw(yaw_of(sole.linear()));
    const Eigen::Vector3d up = sole.linear().col(2);
    foot.gradient = -up.head<2>() / std::max(0.5, up.z());
    const double force = std::max(0.0, feels_ ? estimator.sole_force(f).z() : wanted_[at(f)].force);
    foot.height = sole.translation().z() + force / std::max(1e3, model_->soles[at(f)].stiffness);
    if (!fresh && !pattern_.swings(f)) {
      carried += force;
      lower += force * (pattern_.foot(f).height - foot.height);
    }
    if (!feels_) continue;
    measured_[at(f)].force = estimator.sole_force(f).z();
    measured_[at(f)].moment =
        pattern_.foot(f).unturn(Eigen::Vector2d(estimator.sole_torque(f).head<2>()));
  }
  if (!feels_) measured_ = wanted_;
  // On average over a step the feet press as hard as the robot weighs, with what it carries.
  const double weight = mass_ * kGravity;
  const double pressed = std::max(0.0, measured_[0].force) + std::max(0.0, measured_[1].force);
  const double quick = fresh ? 1.0 : dt / (dt + kWeighing);
  if (feels_ && pressed > 0.0)
    load_ = std::clamp(load_ + quick * (pressed / weight - load_), kLightest, kHeaviest);
  // The estimator has the loaded soles on one plane; here they stand as high as they landed.
  if (carried > kLeastLoad * mass_ * kGravity) shift_ = lower / carried;
  for (Foothold& foot : measured_feet_) foot.height += shift_;
}

const char* Walk::why_no_walk(const Estimator& estimator) const noexcept {
  if (feels(estimator) || stands_flat(estimator)) return nullptr;
  return "without force sensors at its feet the robot walks on flat ground only, and here it is not; the mode stays as it is";
}

const char* Walk::caution(const Estimator& estimator) const noexcept {
  if (feels(estimator)) return nullptr;
  return "the feet have no force sensors: it walks at two fifths of its fastest at most, and stops where the ground is not flat";
}

const char* Walk::why_stopped() const noexcept {
  return steep_ ? "the ground is not flat, and feet without force sensors do not turn with it: the robot stops" : nullptr;
}

void Walk::leave_walk(bool at_once, bool tidy, bool again) noexcept {
  if (at_once && !(again && tidy)) halt();
  want(Eigen::Vector3d::Zero());
  if (tidy && !again) pattern_.square();  // before it rests, the feet come side by side
}

BehaviorReport Walk::report(const Estimator& estimator) const noexcept {
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  const auto flat = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    return (world_in_ground * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
  };
  return {world_in_ground * com_, world_in_ground.linear() * com_velocity_, world_in_ground * com_reference(), flat(dcm_),
          flat(stabilizer_.zmp_wanted())};
}

void Walk::want(const Eigen::Vector3d& velocity) noexcept {
  if (steep_) return;
  Eigen::Vector3d possible = gait().possible(velocity);
  if (!feels_) {
    const double share = Gait::share_of(possible, gait().most_velocity);
    if (share > kUnfeltShare) possible *= kUnfeltShare / share;
  }
  pattern_.want(possible);
}

// Feet that feel nothing do not turn with the ground: on a slope or on tiles the next steps would fell the robot.
void Walk::watch_ground(double dt) noexcept {
  if (feels_ || steep_) return;
  double tilt = 0.0;
  for (int f = 0; f < 2; ++f) {
    if (!pattern_.swings(f)) tilt = std::max(tilt, measured_feet_[at(f)].gradient.norm());
  }
  tilt_ += dt / (dt + kTiltFilter) * (tilt - tilt_);
  if (tilt_ < kFlatTilt) return;
  steep_ = true;
  pattern_.halt();
}

// A foot in the air that feels nothing has landed when its time is over: a sole that is all but on the ground does not carry.
std::array<bool, 2> Walk::touching(const Estimator& estimator) const noexcept {
  std::array<bool, 2> touching{estimator.loaded(0), estimator.loaded(1)};
  for (int f = 0; f < 2 && !feels_; ++f) {
    if (pattern_.swings(f)) touching[at(f)] = pattern_.swing().progress() >= 1.0;
  }
  return touching;
}

void Walk::start(const Estimator& estimator) noexcept {
  shift_ = tilt_ = 0.0;
  steep_ = false;
  height_.rest(std::max(0.2, estimator.kinematics().com().z()));
  measure(estimator, model_->period(), true);
  pattern_.start(measured_feet_);
  ground_.rest(pattern_.ground());
  height_.rest(height_.position() - ground_.height());
  measure(estimator, model_->period(), true);
  heading_ = pattern_.heading();
  const Eigen::Matrix3d base = estimator.configuration().base.linear();
  first_turn_ = rotation_vector(rotation_z(-heading_) * base);
  first_.rest(1.0);
  first_.aim(0.0, gains_.settle);
  height_.aim(gait().com_height, gains_.settle);
  stabilizer_.start(com_.head<2>(), dcm_);
  feet_.start(pattern_, {estimator.sole_in_world(0), estimator.sole_in_world(1)}, measured_);
  ik_.start(estimator.configuration());
  ik_.solve(com_, attitude(), feet_.target(), estimator.configuration().q, kFirstRounds);
  q_ = ik_.configuration().q;
  qd_.setZero();
  qdd_.setZero();
  fresh_ = true;
  finite_ = true;
}

// The wrench of each sole, world, about its frame; and the same in sole axes for the feet.
void Walk::load_feet(const Eigen::Isometry3d* measured_base, double dt) noexcept {
  share_load();
  const double left = stabilizer_.share().left;
  BaseError base;
  base.asked = ik_.configuration().base;
  base.asked.linear() = attitude();
  base.measured = measured_base != nullptr ? *measured_base : base.asked;
  feet_.update(pattern_, wanted_, measured_, {left, 1.0 - left}, base, dt);
}

void Walk::share_load() noexcept {
  const ZmpShare& share = stabilizer_.share();
  const double mass = load_ * mass_;
  const double weight = mass * (kGravity + vertical_acceleration());
  const double w = omega();
  const Eigen::Vector2d horizontal = mass * w * w * (com_.head<2>() - share.zmp);
  for (std::size_t f = 0; f < 2; ++f) {
    const double part = f == 0 ? share.left : 1.0 - share.left;
    const Foothold& foot = pattern_.foot(static_cast<int>(f));
    const Eigen::Vector2d arm = foot.turn(share.cop[f]);
    Eigen::Vector2d push = part * horizontal;
    const double most = 0.8 * std::max(0.1, model_->soles[f].friction) * part * weight;
    if (push.norm() > most) push *= most / push.norm();
    wrench_[f].force << push, part * weight;
    wrench_[f].torque = Eigen::Vector3d(arm.x(), arm.y(), 0.0).cross(wrench_[f].force);
    wanted_[f].force = part * weight;
    wanted_[f].moment = foot.unturn(Eigen::Vector2d(wrench_[f].torque.head<2>()));
  }
}

void Walk::feed_forward(double dt) noexcept {
  const Eigen::VectorXd& q = ik_.configuration().q;
  const double share = dt / (dt + gains_.acceleration_filter);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double rate = fresh_ ? 0.0 : (q[j] - q_[j]) / dt;
    qdd_[j] += share * ((rate - qd_[j]) / dt - qdd_[j]);
    qd_[j] = rate;
  }
  q_ = q;
  Configuration& c = ik_.configuration();
  c.qd = qd_;
  c.base_velocity = reference_velocity();
  c.base_angular_velocity.setZero();
  ik_.update();
  const Kinematics& k = ik_.kinematics();
  for (std::size_t f = 0; f < 2; ++f) {
    const Sole& sole = model_->soles[f];
    wrench_[f].point = (k.link_in_world(sole.link) * sole.frame).translation();
  }
  (void)dynamics_.solve(k, c, qdd_, reference_acceleration(), Eigen::Vector3d::Zero(), wrench_, tau_);
}

void Walk::update(const Estimator& estimator, const Eigen::VectorXd& q_given, double dt) noexcept {
  height_.advance(dt);
  first_.advance(dt);
  measure(estimator, dt, fresh_);
  watch_ground(dt);
  pattern_.advance(touching(estimator), measured_feet_, dt);
  ground_.advance(pattern_.ground_at(stabilizer_.com()), dt);
  const double w = omega();
  if (std::exchange(resumes_, false)) pattern_.walk_on(dcm_, w);
  pattern_.plan(dcm_, w);
  stabilizer_.update(pattern_, com_.head<2>(), dcm_, w, dt);
  if (stabilizer_.excess().norm() > gains_.step_when) pattern_.capture(dcm_, w);
  heading_ += wrap_angle(pattern_.heading() - heading_) * std::min(1.0, dt / gains_.turn);

  Eigen::Isometry3d base = estimator.configuration().base;
  base.translation().z() += shift_;
  load_feet(&base, dt);
  ik_.solve(com_reference(), attitude(), feet_.target(), q_given, gains_.rounds);
  feed_forward(dt);
  fresh_ = false;
  look_for_nan();
}

}  // namespace twinbus::control
