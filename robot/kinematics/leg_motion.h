// How a leg moves its sole, by six coordinates whatever the number of its joints.
//
//     [v; w] = J x          of the sole, world
//
// Six joints: x are their rates.  Five: the sixth coordinate turns the sole about that axis of its frame which the leg cannot
// hold (forward, without an ankle that rolls); no joint follows it, the ground does.  Seven: qd = J_q^T x, J = J_q J_q^T, the
// shortest way; what a posture asks beyond that, the sole does not see.

#pragma once

#include <Eigen/Core>

#include "robot/kinematics/kinematics.h"
#include "robot/kinematics/leg_chain.h"

namespace twinbus::inline robot {

// The axis of its frame, 0 forward, 1 left, 2 up, about which a leg of five joints turns its sole least; -1 of other legs.
int free_axis(const Model& model, int foot);
// Whether no ankle rolls the soles: they carry at the edges that they lean to.
bool leans(const Model& model);

class LegMotion {
 public:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Vector7 = Eigen::Matrix<double, 7, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Matrix37 = Eigen::Matrix<double, 3, 7>;

  // Throws std::runtime_error unless the leg has five, six or seven joints.
  LegMotion(const Model& model, int foot);

  const LegChain& chain() const noexcept { return chain_; }

  // sole: pose of the sole, world.
  void update(const Kinematics& kinematics, const Eigen::Isometry3d& sole) noexcept;
  const Matrix6& jacobian() const noexcept { return jacobian_; }
  // Coordinates that move the sole by e, damped: of a leg that is nearly straight.
  Vector6 damped(const Vector6& e, double damping) const noexcept;
  // What the joints move (a column each) by the six coordinates.
  Eigen::Matrix<double, 3, 6> by_coordinates(const Matrix37& by_joints) const noexcept;
  // Of joint k of the chain.
  double rate(std::size_t k, const Vector6& x) const noexcept {
    const auto column = static_cast<Eigen::Index>(k);
    return chain_.count == 7 ? by_joint_.col(column).dot(x) : x[column];
  }
  // Of its joints while the sole pushes so, force and moment about it [count].
  Vector7 torques(const Vector6& wrench) const noexcept { return -by_joint_.transpose() * wrench; }
  // The part of rates [count of seven joints] that leaves the sole where it is; of other legs none.
  Vector7 unseen(const Vector7& rates) const noexcept;
  // What the leg can do of a turn of the sole, world.
  Eigen::Vector3d held(const Eigen::Vector3d& turn) const noexcept;

 private:
  LegChain chain_;
  int free_;
  Eigen::Vector3d free_in_world_ = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 6, 7> by_joint_ = Eigen::Matrix<double, 6, 7>::Zero();
  Matrix6 jacobian_ = Matrix6::Identity();
};

}  // namespace twinbus::robot
