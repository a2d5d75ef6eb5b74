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

namespace twinbus::inline robot {

class JointInertia {
 public:
  explicit JointInertia(const Model& model);

  // kinematics: updated.  joints: model joints, ascending, at most kMaxJoints; rows and columns count in their order.
  void update(const Kinematics& kinematics, std::span<const int> joints) noexcept;
  int size() const noexcept { return count_; }
  double operator()(int row, int column) const noexcept { return h_[where(row, column)]; }

  // L' D L = H + diag(added); added >= 0 [size].  Number: double, or a vector of doubles that are a case each.
  // l: D, then what is left of the diagonal of L, row by row [kFactor].
  static constexpr int kFactor = kMaxJoints * (kMaxJoints + 1) / 2;
  template <class Number>
  TWINBUS_INLINE void factor(const Number* added, Number* l) const noexcept {
    for (int i = 0; i < count_; ++i) l[i] = h_[where(i, i)] + added[i];
    Number* const rows = l + kMaxJoints;
    for (int n = 0; n < entries_; ++n) rows[n] = Number{} + left_[static_cast<std::size_t>(n)];
    for (int k = count_ - 1; k >= 0; --k) {
      // What is above a joint above comes after it, in its row as in this one.
      const Row row = row_of(k);
      const Number part = 1.0 / l[k];
      for (int p = row.first; p < row.end; ++p) {
        const int i = column(p);
        const Number own = rows[p], share = own * part;
        l[i] -= share * own;
        Number* const above = rows + row_of(i).first;
        for (int q = p + 1; q < row.end; ++q) above[q - p - 1] -= share * rows[q];
        rows[p] = share;
      }
    }
  }
  // x: right side in, solution with that factor out [size].
  template <class Number>
  TWINBUS_INLINE void solve(const Number* l, Number* x) const noexcept {
    const Number* const rows = l + kMaxJoints;
    for (int i = count_ - 1; i >= 0; --i) {
      const Number own = x[i];
      for (int p = row_of(i).first; p < row_of(i).end; ++p) x[column(p)] -= rows[p] * own;
    }
    for (int i = 0; i < count_; ++i) {
      Number own = x[i] / l[i];
      for (int p = row_of(i).first; p < row_of(i).end; ++p) own -= rows[p] * x[column(p)];
      x[i] = own;
    }
  }

 private:
  static constexpr std::size_t where(int row, int column) noexcept {
    return static_cast<std::size_t>(row) * kMaxJoints + static_cast<std::size_t>(column);
  }

  struct Row {
    int first, end;
  };
  Row row_of(int row) const noexcept { return rows_[static_cast<std::size_t>(row)]; }
  int column(int entry) const noexcept { return columns_[static_cast<std::size_t>(entry)]; }
  TWINBUS_INLINE Spatial motion_of(const Kinematics& kinematics, int joint) const noexcept;

  const Model* model_;
  std::vector<RigidInertia> composites_;  // of a link and everything behind it
  int count_ = 0;
  std::vector<double> h_;                 // [kMaxJoints x kMaxJoints]
  std::vector<int> row_;                  // of a model joint; -1 none
  std::array<Row, kMaxJoints> rows_{};    // of the entries: joints above a row's, the nearest first
  int entries_ = 0;
  std::vector<int> columns_;
  std::vector<double> left_;              // H there
};

}  // namespace twinbus::robot
