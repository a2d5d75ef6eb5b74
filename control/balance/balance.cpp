#include "control/balance/balance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "robot/kinematics/leg_chain.h"
#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {

constexpr double kUpright = 0.3;  // from a lean that is given no more [s]
constexpr double kSettledZmp = 0.02;  // [m] inside the support polygon: a stop may end

Eigen::Vector3d turn_vector(const Eigen::Matrix3d& r) noexcept {
  const Eigen::AngleAxisd a(r);
  return a.angle() * a.axis();
}

Eigen::Matrix3d yaw_turn(double yaw) noexcept {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

// Four springs at the corners of a sole: roll, pitch [N m/rad].
Eigen::Vector2d sole_turning_stiffness(const Model& model) {
  Eigen::Vector2d turning(1e12, 1e12);
  for (const Sole& sole : model.soles) {
    const double half_width = 0.5 * (sole.left + sole.right);
    const double half_length = 0.5 * (sole.front + sole.back);
    turning = turning.cwiseMin(sole.stiffness *
                               Eigen::Vector2d(half_width * half_width, half_length * half_length));
  }
  return turning.cwiseMax(100.0);
}

// How far half_sitting has the centre of mass ahead of the middle of the soles, which stand flat; `otherwise` without such a pose [m].
double stands_ahead(const Model& model, double otherwise) {
  if (model.find_pose("half_sitting") < 0) return otherwise;
  Kinematics k(model);
  k.update(Configuration(model, "half_sitting"));
  double ahead = 0.0;
  for (const Sole& sole : model.soles) {
    const Eigen::Isometry3d place = k.link_in_world(sole.link) * sole.frame;
    ahead += 0.5 * ((place.inverse() * k.com()).x() - 0.5 * (sole.front - sole.back));
  }
  return ahead;
}

}  // namespace

const char* Balance::why_not(const Model& model) noexcept {
  if (!model.floating_base) return "its base is fixed";
  for (int foot = 0; foot < 2; ++foot) {
    if (model.soles[static_cast<std::size_t>(foot)].link < 0) return "it has no two soles";
    if (!leg_chain(model, foot).balances()) return kNoLegs;
  }
  return nullptr;
}

Balance::Balance(const Model& model, const BalanceGains& gains)
    : Behavior(model),
      model_(&model),
      gains_(gains),
      stabilizer_(gains.stabilizer),
      trunk_(gains.trunk),
      arms_(model, gains.arms),
      foot_(gains.foot),
      standing_(model),
      dynamics_(model),
      mass_(model.total_mass()),
      rates_(q_),
      offset_(q_),
      offset_rate_(q_) {
  wrench_.resize(2);
  if (const char* why = why_not(model))
    throw std::runtime_error("robot " + model.name + " cannot balance: " + why);
  for (int foot = 0; foot < 2; ++foot) {
    const LegChain leg = leg_chain(model, foot);
    for (const int j : leg) {
      leg_[static_cast<std::size_t>(j)] = true;
      kp_[j] *= gains.leg_kp;
      kd_[j] *= gains.leg_kd;
    }
  }
  find_waist();
  stands_ahead_ = std::clamp(stands_ahead(model, gains.home_forward), gains.home_forward, -gains.home_forward);
  for (std::size_t s = 0; s < 2; ++s) {
    const Sole& sole = model.soles[s];
    soles_[s].front = sole.front;
    soles_[s].back = sole.back;
    soles_[s].left = sole.left;
    soles_[s].right = sole.right;
    const Eigen::Vector2d soft = sole_turning_stiffness(model);
    soles_[s].most_moment =
        gains.sole_tilt / (mass_ * kGravity) * Eigen::Vector2d(soft.y(), soft.x());
    if (const int free = free_axis(model, static_cast<int>(s)); free == 0 || free == 1) soles_[s].most_moment[1 - free] = 0.0;
    wrench_[s].link = sole.link;
  }
}

// The joints between the base and the arms that turn about x and about y.
void Balance::find_waist() noexcept {
  const auto parent = [&](int link) {
    return model_->joints[static_cast<std::size_t>(link) - 1].parent;
  };
  const auto is_above = [&](int link, int hand) {
    while (hand > link) hand = parent(hand);
    return hand == link;
  };
  int link = model_->hands[0].link;
  if (link < 0 || model_->hands[1].link < 0) return;
  for (; link > 0; link = parent(link)) {
    if (!is_above(link, model_->hands[1].link)) continue;
    const Joint& joint = model_->joints[static_cast<std::size_t>(link) - 1];
    if (joint.kind == JointKind::kPrismatic || joint.mimic >= 0) continue;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double along = joint.axis[static_cast<Eigen::Index>(axis)];
      if (std::abs(along) < 0.99) continue;
      waist_[axis] = link - 1;
      waist_sign_[axis] = along > 0.0 ? 1.0 : -1.0;
    }
  }
}

double Balance::omega() const noexcept {
  const double height = std::max(0.2, motion_.position().z());
  return std::sqrt(std::max(2.0, kGravity + motion_.acceleration().z()) / height);
}

void Balance::forget() noexcept {
  com_velocity_.setZero();
  turn_rate_.setZero();
  spun_velocity_.setZero();
  rates_.setZero();
}

void Balance::watch(const Estimator& estimator, double dt) noexcept {
  const Eigen::Matrix3d world_in_ground = estimator.ground_in_world().linear().transpose();
  const Configuration& now = estimator.configuration();
  const double share = dt / (dt + gains_.velocity_filter);
  com_velocity_ +=
      share * (world_in_ground * estimator.com_velocity() - com_velocity_);
  turn_rate_ += share * (world_in_ground * now.base_angular_velocity - turn_rate_);
  spun_velocity_ += share * (world_in_ground.topLeftCorner<2, 2>() * estimator.spun_velocity() -
                             spun_velocity_);
  rates_ += dt / (dt + gains_.rate_filter) * (now.qd - rates_);
}

// Centre of mass, DCM and the attitude of the base in the ground frame.
void Balance::measure(const Estimator& estimator) noexcept {
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  com_ = world_in_ground * estimator.kinematics().com();
  dcm_ = com_.head<2>() + spun_velocity_ / omega();
  const Eigen::Matrix3d base = world_in_ground.linear() * estimator.configuration().base.linear();
  const double yaw = yaw_of(base);
  turn_ = turn_vector(yaw_turn(-yaw) * base);
  turn_.z() = yaw;
}

void Balance::take_soles(const Estimator& estimator, double share) noexcept {
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  for (std::size_t s = 0; s < 2; ++s) {
    const Eigen::Isometry3d sole = world_in_ground * estimator.sole_in_world(static_cast<int>(s));
    soles_[s].position += share * (sole.translation().head<2>() - soles_[s].position);
    soles_[s].yaw +=
        share * std::remainder(yaw_of(sole.linear()) - soles_[s].yaw, 6.283185307179586);
  }
}

void Balance::start(const Estimator& estimator) noexcept {
  take_soles(estimator, 1.0);
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  com_ = world_in_ground * estimator.kinematics().com();
  motion_.start(com_, com_, Eigen::Vector3d::Zero(), 0.001);  // so that omega() knows the height
  measure(estimator);
  first_turn_ = turn_;
  lean_wanted_.setZero();
  lean_rate_wanted_.setZero();
  lean_given_ = false;
  first_.rest(1.0);
  first_.aim(0.0, gains_.settle);
  home_ << 0.5 * (soles_[0].centre() + soles_[1].centre()), com_.z();
  home_.x() += stands_ahead_;
  motion_.start(home_, com_, com_velocity_, gains_.way_home);
  stabilizer_.start();
  start_trunk(estimator);
  arms_.start();
  foot_.start();
  finite_ = true;
}

// The filtered velocities go on: the new source moves as the last one did, and its first unfiltered
// velocities are noise.
void Balance::rebase() noexcept { stabilizer_.rebase(); }

// Momentum rate about the centre of mass [N m] of an acceleration while the centre of mass rests and the soles stand:
// qdd of the joints that are not of a leg as they are in qdd_, and a turning of the base.
Eigen::Vector3d Balance::momentum_rate(const Estimator& estimator,
                                       const Eigen::Vector3d& turning) noexcept {
  const Kinematics& k = estimator.kinematics();
  const Configuration& now = estimator.configuration();
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d arm = k.com() - k.link_in_world(0).translation();
  const auto rate = [&](const Eigen::Vector3d& base, const Eigen::Vector3d& turn) {
    return dynamics_.solve(k, now, qdd_, base, turn, no_wrench_, tau_);
  };
  const Eigen::Matrix<double, 6, 1> own = rate(zero, zero);
  const Eigen::Vector3d shift =
      (own.head<3>() - mass_ * kGravity * Eigen::Vector3d::UnitZ()) / mass_;
  const Eigen::Vector3d base = standing_.solve(-shift, turning, qdd_);
  const Eigen::Matrix<double, 6, 1> w = rate(base, turning);
  return w.tail<3>() - arm.cross(Eigen::Vector3d(w.head<3>()));
}

void Balance::start_trunk(const Estimator& estimator) noexcept {
  Eigen::Vector2d base(0.2 * 0.2, 0.2 * 0.2);  // of a robot that tells nothing [m^2]
  Eigen::Vector2d waist = Eigen::Vector2d::Zero();
  Eigen::Vector2d most = Eigen::Vector2d::Zero();
  if (standing_.update(estimator.kinematics())) {
    const Eigen::Matrix3d& heading = estimator.ground_in_world().linear();
    qdd_.setZero();
    const Eigen::Vector3d still = momentum_rate(estimator, Eigen::Vector3d::Zero());
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector3d unit = heading.col(axis);
      qdd_.setZero();
      base[axis] = unit.dot(momentum_rate(estimator, unit) - still) / mass_;
      const int joint = waist_[static_cast<std::size_t>(axis)];
      if (joint < 0) continue;
      const Joint& j = model_->joints[static_cast<std::size_t>(joint)];
      qdd_.setZero();
      qdd_[joint] = waist_sign_[static_cast<std::size_t>(axis)];
      waist[axis] = unit.dot(momentum_rate(estimator, Eigen::Vector3d::Zero()) - still) / mass_;
      most[axis] = 0.8 * std::min({-j.lower, j.upper, gains_.trunk.limit * gains_.trunk.waist});
    }
  }
  trunk_.start(base, waist, most);
}

bool Balance::resting() const noexcept {
  return motion_.resting() && com_velocity_.head<2>().norm() < 0.02;
}

bool Balance::stopped(const Estimator& estimator) const noexcept {
  return resting() && estimator.support_margin(estimator.zmp()) > kSettledZmp;
}

BehaviorReport Balance::report(const Estimator&) const noexcept {
  return {com_, com_velocity_, motion_.position(), dcm_, stabilizer_.zmp_wanted()};
}

// The wrench on each sole, in the ground frame.
void Balance::push_soles(const Estimator& estimator, double dt) noexcept {
  const ZmpShare& share = stabilizer_.share();
  const BalanceGains& g = gains_;
  const double rise =
      motion_.acceleration().z() + g.height * g.height * (motion_.position().z() - com_.z()) +
      2.0 * g.height_damping * g.height * (motion_.velocity().z() - com_velocity_.z());
  const double weight = mass_ * std::clamp(kGravity + rise, 0.4 * kGravity, 1.6 * kGravity);
  const Eigen::Vector2d spin = mass_ * trunk_.moment_per_mass();  // L'
  const double height = std::max(0.2, com_.z());
  const Eigen::Vector2d horizontal = weight / height * (com_.head<2>() - share.zmp) +
                                     Eigen::Vector2d(-spin.y(), spin.x()) / height;
  const double yaw_error = turn_.z() - first_.position() * first_turn_.z();
  const double twist = mass_ * g.yaw_gyration * g.yaw_gyration *
                       (-g.yaw * g.yaw * yaw_error - 2.0 * g.yaw_damping * g.yaw * turn_rate_.z());
  acceleration_ << horizontal / mass_, weight / mass_ - kGravity;
  angular_acceleration_ << trunk_.acceleration(), 0.0;

  const Eigen::Vector2d line = soles_[0].centre() - soles_[1].centre();
  const Eigen::Vector2d couple =
      twist / std::max(0.01, line.squaredNorm()) * Eigen::Vector2d(-line.y(), line.x());
  const Eigen::Matrix3d to_ground = estimator.ground_in_world().linear().transpose();
  std::array<FootLoad, 2> wanted, measured;
  for (std::size_t s = 0; s < 2; ++s) {
    const int foot = static_cast<int>(s);
    const double part = s == 0 ? share.left : 1.0 - share.left;
    const Eigen::Vector2d arm = soles_[s].turn(share.cop[s]);
    // Not more than the friction of this sole holds.
    Eigen::Vector2d push = part * horizontal + (s == 0 ? couple : -couple);
    const double most = 0.8 * std::max(0.1, model_->soles[s].friction) * part * weight;
    if (push.norm() > most) push *= most / push.norm();
    wrench_[s].force << push, part * weight;
    wrench_[s].torque = Eigen::Vector3d(arm.x(), arm.y(), 0.0).cross(wrench_[s].force);
    wanted[s].force = foot_forces_[s] = part * weight;
    wanted[s].moment = soles_[s].unturn(wrench_[s].torque.head<2>());
    measured[s].force = estimator.sole_force(foot).z();
    measured[s].moment = soles_[s].unturn((to_ground * estimator.sole_torque(foot)).head<2>());
  }
  const bool known = measured[0].force != 0.0 || measured[1].force != 0.0;  // else the feet have no force sensors
  foot_.update(wanted, measured, known && (estimator.loaded(0) || estimator.loaded(1)), dt);
  for (std::size_t s = 0; s < 2; ++s) {
    wrench_[s].torque.head<2>() += soles_[s].turn(foot_.moment(static_cast<int>(s)));
  }
}

// Torques of all joints while the ground pushes so.
void Balance::feed_forward(const Estimator& estimator) noexcept {
  const Configuration& now = estimator.configuration();
  const Eigen::Isometry3d& ground = estimator.ground_in_world();
  for (std::size_t s = 0; s < 2; ++s) {
    wrench_[s].force = (ground.linear() * wrench_[s].force).eval();
    wrench_[s].torque = (ground.linear() * wrench_[s].torque).eval();
    wrench_[s].point =
        ground * Eigen::Vector3d(soles_[s].position.x(), soles_[s].position.y(), 0.0);
  }
  qdd_.setZero();
  offset_.setZero();
  offset_rate_.setZero();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (waist_[axis] < 0) continue;
    const auto i = static_cast<Eigen::Index>(axis);
    offset_[waist_[axis]] = waist_sign_[axis] * trunk_.waist()[i];
    offset_rate_[waist_[axis]] = waist_sign_[axis] * trunk_.waist_rate()[i];
    qdd_[waist_[axis]] = waist_sign_[axis] * trunk_.waist_acceleration()[i];
  }
  for (int arm = 0; arm < 2; ++arm) {
    const int joint = arms_.joint(arm);
    if (joint < 0) continue;
    offset_[joint] = arms_.angle(arm);
    offset_rate_[joint] = arms_.rate(arm);
    qdd_[joint] = arms_.acceleration(arm);
  }
  Eigen::Vector3d base_acceleration = Eigen::Vector3d::Zero();
  Eigen::Vector3d turning = Eigen::Vector3d::Zero();
  if (standing_.update(estimator.kinematics())) {
    turning = ground.linear() * angular_acceleration_;
    base_acceleration = standing_.solve(ground.linear() * acceleration_, turning, qdd_);
    standing_.keep_posture(now, qdd_);
  }
  (void)dynamics_.solve(estimator.kinematics(), now, qdd_, base_acceleration, turning, wrench_,
                        tau_);
  const double lead = gains_.lead * model_->period();
  // What is measured; at the start, which who fades to it keeps, without its noise.
  qd_ = now.qd + first_.position() * (rates_ - now.qd);
  q_ = now.q + lead * qd_;
}

void Balance::update(const Estimator& estimator, const Eigen::VectorXd&, double dt) noexcept {
  motion_.advance(dt);
  first_.advance(dt);
  measure(estimator);
  take_soles(estimator, std::min(1.0, dt * gains_.follow_feet));
  const double height = std::max(0.2, com_.z());
  if (!std::exchange(lean_given_, false)) {
    lean_rate_wanted_ = -lean_wanted_ / kUpright;
    lean_wanted_ += dt * lean_rate_wanted_;
  }
  const Eigen::Vector2d tilt = turn_.head<2>() - first_.position() * first_turn_.head<2>() - lean_wanted_;
  const Eigen::Vector2d lean = trunk_.lean(tilt, height);
  const ComPlan plan{.position = motion_.position().head<2>(),
                     .velocity = motion_.velocity().head<2>(),
                     .acceleration = motion_.acceleration().head<2>()};
  stabilizer_.update(plan, dcm_ + lean, lean, soles_, omega(), dt);
  trunk_.update(stabilizer_.lean_wanted(), tilt, turn_rate_.head<2>() - lean_rate_wanted_, height, dt);
  arms_.update(-trunk_.target().x() - trunk_.waist().x(), dt);  // to the left
  push_soles(estimator, dt);
  feed_forward(estimator);
  look_for_nan();
}

}  // namespace twinbus::control
