#include "robot/kinematics/leg_motion.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {
constexpr double kBent = 0.3;  // of every joint where no pose is known: no leg is straight then [rad]

// to: six numbers, how a joint moves a point, then how it turns what is there.
void put_column(const Kinematics& k, int joint, const Eigen::Vector3d& point, double* to) noexcept {
  const Eigen::Vector3d& axis = k.axis_in_world(joint);
  const double* at = k.link_in_world(joint + 1).matrix().data() + 12;
  const double x = point.x() - at[0], y = point.y() - at[1], z = point.z() - at[2];
  to[0] = axis.y() * z - axis.z() * y;
  to[1] = axis.z() * x - axis.x() * z;
  to[2] = axis.x() * y - axis.y() * x;
  for (int i = 0; i < 3; ++i) to[3 + i] = axis[i];
}
}  // namespace

int free_axis(const Model& model, int foot) {
  const LegChain chain = leg_chain(model, foot);
  if (chain.count != 5) return -1;
  Configuration c(model, "half_sitting");
  const bool known = model.find_pose("half_sitting") >= 0;
  for (const int joint : chain) {
    const Joint& limits = model.joints[at(joint)];
    if (!known) c.q[joint] = std::clamp(kBent, limits.lower, limits.upper);
  }
  Kinematics k(model);
  k.update(c);
  const Sole& sole = model.soles[at(foot)];
  const Eigen::Isometry3d pose = k.link_in_world(sole.link) * sole.frame;
  LegMotion::Matrix6 all = LegMotion::Matrix6::Zero();
  for (int j = 0; j < chain.count; ++j) put_column(k, chain.joint[at(j)], pose.translation(), all.col(j).data());
  Eigen::Vector3d gained;
  for (int axis = 0; axis < 3; ++axis) {
    all.col(5).tail<3>() = pose.linear().col(axis);
    gained[axis] = std::abs(all.determinant());
  }
  int best = 0;
  gained.maxCoeff(&best);
  return best;
}

bool leans(const Model& model) { return free_axis(model, 0) == 0; }

LegMotion::LegMotion(const Model& model, int foot) : chain_(leg_chain(model, foot)), free_(free_axis(model, foot)) {
  if (!chain_.balances()) throw std::runtime_error("robot " + model.name + ": " + kNoLegs);
}

void LegMotion::update(const Kinematics& kinematics, const Eigen::Isometry3d& sole) noexcept {
  const Eigen::Vector3d point = sole.translation();
  for (int j = 0; j < chain_.count; ++j) put_column(kinematics, chain_.joint[at(j)], point, by_joint_.col(j).data());
  if (free_ >= 0) {
    free_in_world_ = sole.linear().col(free_);
    by_joint_.col(5).tail<3>() = free_in_world_;
  }
  if (chain_.count == 7) {
    jacobian_.noalias() = by_joint_ * by_joint_.transpose();
  } else {
    jacobian_ = by_joint_.leftCols<6>();
  }
}

Eigen::Matrix<double, 3, 6> LegMotion::by_coordinates(const Matrix37& by_joints) const noexcept {
  if (chain_.count == 7) return by_joints * by_joint_.transpose();
  return by_joints.leftCols<6>();
}

LegMotion::Vector6 LegMotion::damped(const Vector6& e, double damping) const noexcept {
  Matrix6 a = chain_.count == 7 ? jacobian_ : Matrix6(jacobian_ * jacobian_.transpose());
  a.diagonal().array() += damping * damping;
  if (chain_.count == 7) return a.ldlt().solve(e);
  return jacobian_.transpose() * a.ldlt().solve(e);
}

LegMotion::Vector7 LegMotion::unseen(const Vector7& rates) const noexcept {
  if (chain_.count != 7) return Vector7::Zero();
  const Vector6 x = jacobian_.partialPivLu().solve(by_joint_ * rates);
  const Vector7 left = rates - by_joint_.transpose() * x;
  return left.allFinite() ? left : Vector7::Zero();
}

Eigen::Vector3d LegMotion::held(const Eigen::Vector3d& turn) const noexcept {
  if (free_ < 0) return turn;
  return turn - free_in_world_ * free_in_world_.dot(turn);
}

}  // namespace twinbus::robot
