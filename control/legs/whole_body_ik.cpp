#include "control/legs/whole_body_ik.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"
#include "common/math/pose_math.h"

namespace twinbus {

namespace {
constexpr double kOvershoot =
    1.1;  // the legs follow the base: what it moves, the centre moves less
constexpr double kNearlyStraight = 0.35, kLeastBend = 0.12;  // of a knee [rad]
constexpr double kDamping = 0.03;
constexpr double kLargestStep = 0.2;  // of a joint in a round [rad]

// Axis times the sine of the angle of a rotation: all that Newton's method needs.
Eigen::Vector3d sine_vector(const Eigen::Matrix3d& r) noexcept {
  return 0.5 * Eigen::Vector3d(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
}
}  // namespace

WholeBodyIk::WholeBodyIk(const Model& model)
    : model_(&model),
      leg_mask_(model.joints.size(), false),
      configuration_(model),
      kinematics_(model) {
  for (int foot = 0; foot < 2; ++foot) {
    leg_[at(foot)] = leg_chain(model, foot);
    if (leg_[at(foot)].count != 6)
      throw std::runtime_error("robot " + model.name +
                               ": a sole does not hang on the base by six joints");
    reach_[at(foot)] = leg_reach(model, foot);
    for (const int joint : leg_[at(foot)].joint) leg_mask_[at(joint)] = true;
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
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  const Sole& s = model_->soles[foot];
  const Eigen::Isometry3d now = kinematics_.link_in_world(s.link) * s.frame;
  Matrix6 jacobian;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const int joint = leg_[foot].joint[static_cast<std::size_t>(k)];
    const Eigen::Vector3d& axis = kinematics_.axis_in_world(joint);
    jacobian.col(k) << axis.cross(now.translation() -
                                  kinematics_.link_in_world(joint + 1).translation()),
        axis;
  }
  Vector6 e;
  e << sole.translation() - now.translation() - shift,
      sine_vector(sole.linear() * now.linear().transpose());
  error_ = std::max(error_, e.norm());
  const LegReach& reach = reach_[foot];
  const double bend = reach.bends * (configuration_.q[reach.knee] - reach.straight);
  Vector6 dq;
  if (bend < kNearlyStraight) {
    const double damping = kDamping * std::min(1.0, (kNearlyStraight - bend) / kNearlyStraight);
    Matrix6 a = jacobian * jacobian.transpose();
    a.diagonal().array() += damping * damping;
    dq.noalias() = jacobian.transpose() * a.ldlt().solve(e);
  } else {
    dq = jacobian.partialPivLu().solve(e);
  }
  for (Eigen::Index k = 0; k < 6; ++k) {
    const int joint = leg_[foot].joint[static_cast<std::size_t>(k)];
    const Joint& limits = model_->joints[at(joint)];
    const double step = std::isfinite(dq[k]) ? std::clamp(dq[k], -kLargestStep, kLargestStep) : 0.0;
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

}  // namespace twinbus
