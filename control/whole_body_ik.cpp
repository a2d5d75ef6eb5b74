#include "control/whole_body_ik.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace twinbus {

namespace {
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr double kOverShift = 1.1;  // legs that follow the base take part of its shift back
constexpr double kMostStep = 0.2;   // [rad] a round
constexpr double kHealthyShare =
    0.25;  // of the bent leg's determinant, below which the step is damped
constexpr double kMostDamping = 0.03;
constexpr double kLimitMargin = 0.01;  // [rad] kept from joint limits

Eigen::Vector3d rotation_vector(const Eigen::Matrix3d& r) noexcept {
  const Eigen::AngleAxisd turn(r);
  return turn.angle() * turn.axis();
}
}  // namespace

LegChain leg_chain(const Model& model, int foot) {
  LegChain chain;
  int link = model.soles[static_cast<std::size_t>(foot)].link;
  if (link < 0) return chain;
  std::array<int, 6> back{};
  while (link > 0) {
    if (chain.count == 6) return {};
    const int joint = link - 1;
    if (model.joints[static_cast<std::size_t>(joint)].mimic >= 0) return {};
    back[static_cast<std::size_t>(chain.count++)] = joint;
    link = model.joints[static_cast<std::size_t>(joint)].parent;
  }
  for (int k = 0; k < chain.count; ++k) {
    chain.joint[static_cast<std::size_t>(k)] = back[static_cast<std::size_t>(chain.count - 1 - k)];
  }
  return chain;
}

WholeBodyIk::WholeBodyIk(const Model& model)
    : model_(&model),
      configuration_(model),
      kinematics_(model),
      leg_mask_(model.joints.size(), false) {
  for (int foot = 0; foot < 2; ++foot) {
    const auto f = static_cast<std::size_t>(foot);
    leg_[f] = leg_chain(model, foot);
    if (leg_[f].count != 6) {
      throw std::runtime_error("robot " + model.name + ": the " + (foot == 0 ? "left" : "right") +
                               " sole does not hang on the base by six joints; balance needs that");
    }
    for (int joint : leg_[f].joint) leg_mask_[static_cast<std::size_t>(joint)] = true;
  }
  // A healthy determinant: every leg joint mid-range or slightly bent tells what "not straight" is.
  for (std::size_t f = 0; f < 2; ++f) {
    double best = 0.0;
    for (double bend : {0.6, 1.0, 1.3}) {
      Configuration bent(model);
      for (int joint : leg_[f].joint) {
        const Joint& j = model.joints[static_cast<std::size_t>(joint)];
        const double reach = std::isfinite(j.upper) && j.upper > -j.lower ? bend : -bend;
        if (std::abs(j.axis.y()) > 0.9) bent.q[joint] = std::clamp(reach, j.lower, j.upper);
      }
      kinematics_.update(bent);
      const Eigen::Vector3d sole =
          (kinematics_.link_in_world(model.soles[f].link) * model.soles[f].frame).translation();
      Matrix6 jacobian;
      for (int k = 0; k < 6; ++k) {
        const int joint = leg_[f].joint[static_cast<std::size_t>(k)];
        const Eigen::Vector3d axis = kinematics_.axis_in_world(joint);
        jacobian.col(k) << axis.cross(sole - kinematics_.link_in_world(joint + 1).translation()),
            axis;
      }
      best = std::max(best, std::abs(jacobian.determinant()));
    }
    healthy_[f] = best;
  }
}

void WholeBodyIk::start(const Configuration& configuration) noexcept {
  configuration_.base = configuration.base;
  configuration_.q = configuration.q;
  configuration_.qd.setZero();
  configuration_.base_velocity.setZero();
  configuration_.base_angular_velocity.setZero();
}

double WholeBodyIk::step_leg(std::size_t foot, const Eigen::Vector3d& base_shift,
                             const Eigen::Isometry3d& target) noexcept {
  const Sole& sole = model_->soles[foot];
  const Eigen::Isometry3d now = kinematics_.link_in_world(sole.link) * sole.frame;
  Matrix6 jacobian;
  for (int k = 0; k < 6; ++k) {
    const int joint = leg_[foot].joint[static_cast<std::size_t>(k)];
    const Eigen::Vector3d& axis = kinematics_.axis_in_world(joint);
    jacobian.col(k) << axis.cross(now.translation() -
                                  kinematics_.link_in_world(joint + 1).translation()),
        axis;
  }
  Vector6 error;
  error.head<3>() = target.translation() - now.translation() - base_shift;
  error.tail<3>() = rotation_vector(target.linear() * now.linear().transpose());

  Vector6 step;
  const Eigen::PartialPivLU<Matrix6> lu(jacobian);
  const double health = std::abs(lu.determinant()) / (kHealthyShare * healthy_[foot]);
  if (health < 1.0) {
    const double damping = kMostDamping * (1.0 - health);
    Matrix6 normal = jacobian * jacobian.transpose();
    normal.diagonal().array() += damping * damping;
    step = jacobian.transpose() * normal.ldlt().solve(error);
  } else {
    step = lu.solve(error);
  }
  for (int k = 0; k < 6; ++k) {
    const int index = leg_[foot].joint[static_cast<std::size_t>(k)];
    const Joint& joint = model_->joints[static_cast<std::size_t>(index)];
    double& q = configuration_.q[index];
    q += std::clamp(step[k], -kMostStep, kMostStep);
    if (joint.kind != JointKind::kContinuous && joint.upper - joint.lower > 2.0 * kLimitMargin) {
      q = std::clamp(q, joint.lower + kLimitMargin, joint.upper - kLimitMargin);
    }
  }
  return error.norm();
}

double WholeBodyIk::solve(const Eigen::Vector3d& com, const Eigen::Matrix3d& base,
                          const std::array<Eigen::Isometry3d, 2>& soles, int rounds) noexcept {
  configuration_.base.linear() = base;
  kinematics_.update(configuration_);
  double error = 0.0;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::Vector3d shift = kOverShift * (com - kinematics_.com());
    error = shift.norm();
    configuration_.base.translation() += shift;
    for (std::size_t foot = 0; foot < 2; ++foot)
      error = std::max(error, step_leg(foot, shift, soles[foot]));
    kinematics_.update(configuration_);
  }
  return error;
}

}  // namespace twinbus
