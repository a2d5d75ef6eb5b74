#include "control/legs/whole_body_ik.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
constexpr double kOvershoot =
    1.1;  // the legs follow the base: what it moves, the centre moves less
constexpr double kNearlyStraight = 0.35, kLeastBend = 0.12;  // of a knee [rad]
constexpr double kDamping = 0.03;
constexpr double kLargestStep = 0.2;  // of a joint in a round [rad]
constexpr double kHomewards = 0.01;   // of what a seventh joint leaves free, in a round

// Axis times the sine of the angle of a rotation: all that Newton's method needs.
Eigen::Vector3d sine_vector(const Eigen::Matrix3d& r) noexcept {
  return 0.5 * Eigen::Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
}
}  // namespace

WholeBodyIk::WholeBodyIk(const Model& model)
    : model_(&model),
      leg_{LegMotion(model, 0), LegMotion(model, 1)},
      leg_mask_(model.joints.size(), false),
      home_(model, "half_sitting"),
      configuration_(model),
      kinematics_(model) {
  for (int foot = 0; foot < 2; ++foot) {
    reach_[at(foot)] = leg_reach(model, foot);
    for (const int joint : leg_[at(foot)].chain()) leg_mask_[at(joint)] = true;
  }
}

void WholeBodyIk::start(const Configuration& now) noexcept {
  configuration_.base = now.base;
  configuration_.q = now.q;
  configuration_.qd.setZero();
  configuration_.base_velocity.setZero();
  configuration_.base_angular_velocity.setZero();
  current_ = false;
}

void WholeBodyIk::update() noexcept {
  kinematics_.update(configuration_);
  current_ = true;
}

void WholeBodyIk::step_leg(std::size_t foot, const Eigen::Isometry3d& sole,
                           const Eigen::Vector3d& shift) noexcept {
  LegMotion& leg = leg_[foot];
  const Sole& s = model_->soles[foot];
  const Eigen::Isometry3d now = kinematics_.link_in_world(s.link) * s.frame;
  leg.update(kinematics_, now);
  LegMotion::Vector6 e;
  e << sole.translation() - now.translation() - shift,
      leg.held(sine_vector(sole.linear() * now.linear().transpose()));
  error_ = std::max(error_, e.norm());
  const LegReach& reach = reach_[foot];
  const double bend = reach.bends * (configuration_.q[reach.knee] - reach.straight);
  LegMotion::Vector6 dx;
  if (bend < kNearlyStraight) {
    const double damping = kDamping * std::min(1.0, (kNearlyStraight - bend) / kNearlyStraight);
    dx = leg.damped(e, damping);
  } else {
    dx = leg.jacobian().partialPivLu().solve(e);
  }
  LegMotion::Vector7 homewards = LegMotion::Vector7::Zero();
  if (leg.chain().count == 7) {  // others have no choice
    for (int k = 0; k < leg.chain().count; ++k) {
      const int joint = leg.chain().joint[at(k)];
      homewards[k] = kHomewards * (home_.q[joint] - configuration_.q[joint]);
    }
    homewards = leg.unseen(homewards);
  }
  for (int k = 0; k < leg.chain().count; ++k) {
    const int joint = leg.chain().joint[at(k)];
    const Joint& limits = model_->joints[at(joint)];
    const double dq = leg.rate(at(k), dx) + homewards[k];
    const double step = std::isfinite(dq) ? std::clamp(dq, -kLargestStep, kLargestStep) : 0.0;
    double& q = configuration_.q[joint];
    q += step;
    if (joint == reach.knee) {
      const double bent = std::max(reach.bends * (q - reach.straight), kLeastBend);
      q = reach.straight + reach.bends * bent;
    }
    q = std::clamp(q, limits.lower, limits.upper);
  }
}

void WholeBodyIk::solve(const Eigen::Vector3d& com, const Eigen::Matrix3d& base,
                        const std::array<Eigen::Isometry3d, 2>& soles, const Eigen::VectorXd& q,
                        int rounds) noexcept {
  if (!current_) update();
  for (int j = 0; j < model_->joint_count(); ++j) {
    if (!leg_mask_[at(j)]) configuration_.q[j] = q[j];
  }
  configuration_.base.linear() = base;
  for (int round = 0; round < rounds; ++round) {
    if (round > 0) update();
    // Where the kinematics have their base: what is asked is brought there, so that they need no update before.
    const Eigen::Isometry3d into = kinematics_.link_in_world(0) * configuration_.base.inverse();
    const Eigen::Vector3d shift = kOvershoot * (into * com - kinematics_.com());
    error_ = shift.norm();
    for (std::size_t foot = 0; foot < 2; ++foot) step_leg(foot, into * soles[foot], shift);
    configuration_.base.translation() += into.linear().transpose() * shift;
  }
  current_ = false;
}

}  // namespace twinbus::control
