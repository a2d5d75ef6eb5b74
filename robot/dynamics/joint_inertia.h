// Inertia matrix of some of a robot's joints, the base and the other joints standing still, by the composite rigid body
// algorithm (Featherstone 2008, table 6.2), and its factorization along the tree (table 6.3).
//
//     H qdd + bias = tau,     H_ij = s_i . I_j s_j     i above or at j, I_j: of everything behind joint j
//
// s: motion of a joint, angular and linear at the base's origin, world axes.  Rotor inertia is on the diagonal.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot/description/model.h"
#include "robot/dynamics/spatial_force.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus {

class JointInertia {
 public:
  explicit JointInertia(const Model& model);

  // kinematics: updated.  joints: model joints, ascending, at most kMaxJoints; rows and columns count in their order.
  void update(const Kinematics& kinematics, std::span<const int> joints) noexcept;
  int size() const noexcept { return count_; }
  double operator()(int row, int column) const noexcept { return h_[where(row, column)]; }

  // y = H x [size]
  void times(const double* x, double* y) const noexcept;
  // L' D L = H + diag(added); added >= 0 [size].
  void factor(const double* added) noexcept;
  // x: right side in, solution with what was factored last out [size].
  void solve(double* x) const noexcept;

 private:
  static constexpr std::size_t where(int row, int column) noexcept {
    return static_cast<std::size_t>(row) * kMaxJoints + static_cast<std::size_t>(column);
  }

  TWINBUS_INLINE Spatial motion_of(const Kinematics& kinematics, int joint) const noexcept;

  const Model* model_;
  std::vector<RigidInertia> composites_;  // of a link and everything behind it
  int count_ = 0;
  std::array<int, kMaxJoints> above_{};  // the nearest of the joints above a row's; -1 none
  std::vector<double> h_, l_;            // [kMaxJoints x kMaxJoints]; l_: D on the diagonal
  std::vector<int> row_;                 // of a model joint; -1 none
};

}  // namespace twinbus
