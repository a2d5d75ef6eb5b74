#include "control/balance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace twinbus {

namespace {

double yaw_of(const Eigen::Matrix3d& r) noexcept { return std::atan2(r(1, 0), r(0, 0)); }

Eigen::Matrix3d turn(const Eigen::Vector3d& vector) noexcept {
  const double angle = vector.norm();
  if (!(angle > 1e-12)) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Eigen::Vector3d turn_vector(const Eigen::Matrix3d& r) noexcept {
  const Eigen::AngleAxisd a(r);
  return a.angle() * a.axis();
}

Eigen::Matrix3d yaw_turn(double yaw) noexcept {
  return Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

double in_series(double a, double b) noexcept { return a * b / (a + b); }

// Four springs at the corners of a sole.
FootStiffness sole_stiffness(const Model& model) {
  FootStiffness stiffness{.vertical = 1e12, .turning = {1e12, 1e12}};
  for (const Sole& sole : model.soles) {
    const double half_width = 0.5 * (sole.left + sole.right);
    const double half_length = 0.5 * (sole.front + sole.back);
    stiffness.vertical = std::min(stiffness.vertical, sole.stiffness);
    stiffness.turning = stiffness.turning.cwiseMin(
        sole.stiffness * Eigen::Vector2d(half_width * half_width, half_length * half_length));
  }
  stiffness.vertical = std::max(stiffness.vertical, 1e4);
  stiffness.turning = stiffness.turning.cwiseMax(100.0);
  return stiffness;
}

// With the servos of the bent leg.
double series_stiffness(const Model& model, const BalanceGains& gains) {
  constexpr double kKneeLever = 0.2;  // [m]
  const LegChain leg = leg_chain(model, 0);
  double softest = 1e12;
  for (int k = 0; k + 2 < leg.count; ++k) {
    const Joint& joint = model.joints[static_cast<std::size_t>(leg.joint[static_cast<std::size_t>(k)])];
    softest = std::min(softest, std::max(1.0, gains.leg_kp * joint.kp));
  }
  return in_series(sole_stiffness(model).vertical, softest / (kKneeLever * kKneeLever));
}

}  // namespace

const char* Balance::why_not(const Model& model) noexcept {
  if (!model.floating_base) return "its base is fixed";
  for (int foot = 0; foot < 2; ++foot) {
    if (model.soles[static_cast<std::size_t>(foot)].link < 0) return "it has no two soles";
    if (leg_chain(model, foot).count != 6) return "a sole does not hang on the base by six joints";
  }
  return nullptr;
}

Balance::Balance(const Model& model, const BalanceGains& gains)
    : model_(&model),
      gains_(gains),
      stabilizer_(gains.stabilizer),
      trunk_(gains.trunk),
      foot_(gains.foot, sole_stiffness(model), series_stiffness(model, gains)),
      ik_(model),
      dynamics_(model),
      mass_(model.total_mass()),
      last_(model),
      q_(Eigen::VectorXd::Zero(model.joint_count())),
      qd_(q_),
      qdd_(q_),
      tau_(q_),
      kp_(q_),
      kd_(q_),
      wrench_(2),
      motion_state_(model),
      motion_kinematics_(model) {
  if (const char* why = why_not(model))
    throw std::runtime_error("robot " + model.name + " cannot balance: " + why);
  for (int j = 0; j < model.joint_count(); ++j) {
    kp_[j] = model.joints[static_cast<std::size_t>(j)].kp;
    kd_[j] = model.joints[static_cast<std::size_t>(j)].kd;
  }
  for (int foot = 0; foot < 2; ++foot) {
    const LegChain leg = leg_chain(model, foot);
    for (int k = 0; k < leg.count; ++k) {
      const int j = leg.joint[static_cast<std::size_t>(k)];
      kp_[j] *= k >= 4 ? gains.ankle_kp : gains.leg_kp;
      kd_[j] *= k >= 4 ? gains.ankle_kd : gains.leg_kd;
    }
  }
  for (std::size_t s = 0; s < 2; ++s) {
    const Sole& sole = model.soles[s];
    soles_[s].front = sole.front;
    soles_[s].back = sole.back;
    soles_[s].left = sole.left;
    soles_[s].right = sole.right;
    const FootStiffness soft = sole_stiffness(model);
    soles_[s].most_moment = gains.sole_tilt / (mass_ * kGravity) *
                            Eigen::Vector2d(soft.turning.y(), soft.turning.x());
    wrench_[s].link = sole.link;
  }
}

double Balance::omega() const noexcept {
  const double height = std::max(0.2, motion_.position().z());
  return std::sqrt(std::max(2.0, kGravity + motion_.acceleration().z()) / height);
}

// Centre of mass, its velocity and the DCM in the ground frame.
void Balance::measure(const Estimator& estimator, double dt, bool fresh) noexcept {
  const Eigen::Isometry3d world_in_ground = estimator.ground_in_world().inverse();
  const Kinematics& k = estimator.kinematics();
  com_ = world_in_ground * k.com();
  const Eigen::Vector3d velocity = world_in_ground.linear() * k.com_velocity();
  const Eigen::Vector3d spin = world_in_ground.linear() * k.angular_momentum();
  const double w = omega();
  const double height = std::max(0.2, com_.z());
  const Eigen::Vector2d momentum =
      gains_.momentum / (mass_ * height * w) * Eigen::Vector2d(spin.y(), -spin.x());
  const double share = fresh ? 1.0 : dt / (dt + gains_.velocity_filter);
  com_velocity_ += share * (velocity - com_velocity_);
  momentum_ += share * (momentum - momentum_);
  dcm_ = com_.head<2>() + com_velocity_.head<2>() / w + momentum_;
  const Eigen::Matrix3d base = world_in_ground.linear() * estimator.configuration().base.linear();
  tilt_ = turn_vector(yaw_turn(-yaw_of(base)) * base).head<2>();
  const Eigen::Vector3d turning = world_in_ground.linear() * estimator.configuration().base_angular_velocity;
  tilt_rate_ += share * (turning.head<2>() - tilt_rate_);
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
  Configuration& configuration = motion_state_;
  configuration.base = world_in_ground * estimator.configuration().base;
  configuration.q = estimator.configuration().q;
  ik_.start(configuration);
  for (std::size_t s = 0; s < 2; ++s) {
    const Eigen::Isometry3d sole = world_in_ground * estimator.sole_in_world(static_cast<int>(s));
    first_height_[s] = sole.translation().z();
    first_turn_[s] = turn_vector(sole.linear() * yaw_turn(-soles_[s].yaw));
  }
  first_base_turn_ = turn_vector(configuration.base.linear());
  first_.rest(1.0);
  first_.aim(0.0, gains_.settle);

  com_ = world_in_ground * estimator.kinematics().com();
  motion_.start(com_, com_, Eigen::Vector3d::Zero(), 0.001);  // so that omega() knows the height
  measure(estimator, model_->period(), true);
  home_ << 0.5 * (soles_[0].centre() + soles_[1].centre()), com_.z();
  home_.x() += gains_.home_forward;
  motion_.start(home_, com_, com_velocity_, gains_.way_home);
  stabilizer_.start(com_.head<2>(), com_velocity_.head<2>(), omega());
  trunk_.start();
  foot_.start();
  last_ = ik_.configuration();
  q_ = ik_.configuration().q;
  qd_.setZero();
  qdd_.setZero();
  fresh_ = true;
  finite_ = true;
}

void Balance::rebase(const Estimator& estimator) noexcept {
  measure(estimator, model_->period(), true);
  stabilizer_.rebase();
}

Eigen::Vector3d Balance::com_reference() const noexcept {
  return {stabilizer_.com_reference().x(), stabilizer_.com_reference().y(), motion_.position().z()};
}

bool Balance::resting() const noexcept {
  return motion_.resting() && stabilizer_.com_velocity_reference().norm() < 0.01 &&
         com_velocity_.head<2>().norm() < 0.02;
}

// What each sole is to carry, and the compliance that makes it so.
void Balance::load_soles(const Estimator& estimator, double dt) noexcept {
  const ZmpShare& share = stabilizer_.share();
  const double w = omega();
  const double weight = mass_ * std::max(0.0, kGravity + motion_.acceleration().z());
  // Change of angular momentum that turns the base to where it should be.
  const double inertia = mass_ * gains_.turning_gyration * gains_.turning_gyration;
  const Eigen::Vector2d tilt_error =
      tilt_ - trunk_.angle() - first_.position() * first_base_turn_.head<2>();
  const Eigen::Vector2d spin =
      gains_.feedback
          ? Eigen::Vector2d(inertia * (trunk_.acceleration() - gains_.upright * gains_.upright * tilt_error -
                       2.0 * gains_.upright_damping * gains_.upright * (tilt_rate_ - trunk_.rate())))
          : Eigen::Vector2d::Zero();
  const double height = std::max(0.2, com_.z());
  const Eigen::Vector2d horizontal = mass_ * w * w * (com_.head<2>() - share.zmp) +
                                     Eigen::Vector2d(-spin.y(), spin.x()) / height;
  const Eigen::Matrix3d to_ground = estimator.ground_in_world().linear().transpose();
  std::array<FootLoad, 2> wanted;
  std::array<FootLoad, 2> measured;
  for (std::size_t s = 0; s < 2; ++s) {
    const double part = s == 0 ? share.left : 1.0 - share.left;
    const Eigen::Vector2d arm = soles_[s].turn(share.cop[s]);
    // Not more than the friction of this sole holds.
    Eigen::Vector2d push = part * horizontal;
    const double most = 0.8 * std::max(0.1, model_->soles[s].friction) * part * weight;
    if (push.norm() > most) push *= most / push.norm();
    wrench_[s].point << soles_[s].position, 0.0;
    wrench_[s].force << push, part * weight;
    wrench_[s].torque = Eigen::Vector3d(arm.x(), arm.y(), 0.0).cross(wrench_[s].force);
    wanted[s].force = part * weight;
    wanted[s].moment = soles_[s].unturn(wrench_[s].torque.head<2>());
    const int foot = static_cast<int>(s);
    measured[s].force = estimator.sole_force(foot).z();
    measured[s].moment = soles_[s].unturn((to_ground * estimator.sole_torque(foot)).head<2>());
  }
  const bool valid = gains_.feedback && (estimator.loaded(0) || estimator.loaded(1));
  foot_.update(wanted, measured, valid, dt);
  for (std::size_t s = 0; s < 2; ++s) {
    wrench_[s].torque.head<2>() += soles_[s].turn(foot_.moment(static_cast<int>(s)));
  }
}

std::array<Eigen::Isometry3d, 2> Balance::sole_targets() const noexcept {
  std::array<Eigen::Isometry3d, 2> target;
  const double first = first_.position();
  for (std::size_t s = 0; s < 2; ++s) {
    const int foot = static_cast<int>(s);
    const Eigen::Vector2d angle = gains_.feedback ? foot_.angle(foot) : Eigen::Vector2d::Zero();
    const double height = gains_.feedback ? foot_.height(foot) : 0.0;
    target[s].linear() =
        turn(first * first_turn_[s]) * yaw_turn(soles_[s].yaw) * turn({angle.x(), angle.y(), 0.0});
    target[s].translation() << soles_[s].position, first * first_height_[s] + height;
  }
  return target;
}

// Joint velocities and accelerations of the command, then the torque that moves the robot so while
// the ground pushes as shared.
void Balance::feed_forward(double dt) noexcept {
  const Configuration& now = ik_.configuration();
  const double slow = dt / (dt + gains_.acceleration_filter);
  if (fresh_) {
    qd_.setZero();
    qdd_.setZero();
  } else {
    for (Eigen::Index j = 0; j < qd_.size(); ++j) {
      const double rate = (now.q[j] - last_.q[j]) / dt;
      qdd_[j] += slow * ((rate - qd_[j]) / dt - qdd_[j]);
      qd_[j] = rate;
    }
  }
  motion_state_.base = now.base;
  motion_state_.q = now.q;
  motion_state_.qd = qd_;
  const Eigen::Vector2d& v = stabilizer_.com_velocity_reference();
  motion_state_.base_velocity << v.x(), v.y(), motion_.velocity().z();
  motion_state_.base_angular_velocity << trunk_.rate().x(), trunk_.rate().y(), 0.0;
  motion_kinematics_.update(motion_state_);
  const double w = omega();
  Eigen::Vector3d acceleration;
  acceleration << w * w * (stabilizer_.com_reference() - stabilizer_.zmp_reference()),
      motion_.acceleration().z();
  const Eigen::Vector3d turning(trunk_.acceleration().x(), trunk_.acceleration().y(), 0.0);
  (void)dynamics_.solve(motion_kinematics_, motion_state_, qdd_, acceleration, turning, wrench_,
                        tau_);
}

void Balance::update(const Estimator& estimator, const Eigen::VectorXd& q_given,
                     double dt) noexcept {
  motion_.advance(dt);
  first_.advance(dt);
  measure(estimator, dt, fresh_);
  take_soles(estimator, std::min(1.0, dt * gains_.follow_feet));
  const Eigen::Vector3d& p = motion_.position();
  const ComPlan plan{.position = p.head<2>(),
                     .velocity = motion_.velocity().head<2>(),
                     .acceleration = motion_.acceleration().head<2>()};
  stabilizer_.update(plan, com_.head<2>(), dcm_, soles_, omega(), dt, gains_.feedback);
  trunk_.update(gains_.feedback ? stabilizer_.excess() : Eigen::Vector2d::Zero(), dt);
  load_soles(estimator, dt);

  for (int j = 0; j < model_->joint_count(); ++j) {
    if (!ik_.is_leg(j)) ik_.set_joint(j, q_given[j]);
  }
  const Eigen::Vector3d yield(trunk_.angle().x(), trunk_.angle().y(), 0.0);
  const Eigen::Matrix3d base = turn(yield) * turn(first_.position() * first_base_turn_);
  last_ = ik_.configuration();
  ik_.solve(com_reference(), base, sole_targets(), gains_.ik_rounds);
  feed_forward(dt);
  q_ = ik_.configuration().q;
  fresh_ = false;
  finite_ = q_.allFinite() && qd_.allFinite() && tau_.allFinite();
}

}  // namespace twinbus
