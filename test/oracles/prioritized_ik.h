// Inverse kinematics of the whole body with priorities: feet stay, the centre of mass is over them,
// hands reach as far as that leaves them free, and what is left over goes towards a posture.
//
// Each step solves, level by level, damped least squares in what no higher level needs:
//
//     dq = sum over k of B_k z_k,   z_k = argmin |e_k - J_k (dq_above + B_k z)|^2 + damping^2 |z|^2
//
// B_k is an orthonormal basis of the rows of J_k that higher levels leave, so a lower level never
// moves a higher one to first order, however badly it is missed; further steps of the higher levels
// alone mend the second.  A step counts if the highest level that it changes got better.  Joints at
// limits that would go on outwards are held, and all levels share what remains.

#pragma once

#include <array>
#include <span>
#include <vector>

#include "robot/kinematics/kinematics.h"

namespace twinbus {

enum class IkTaskKind {
  kPose,      // position and rotation of a frame of a link
  kPosition,  // of the frame's origin only
  kRotation,  // of the frame only
  kCom,       // target.translation() is for the centre of mass
  kPosture    // joints towards `posture`
};

struct IkTask {
  IkTaskKind kind = IkTaskKind::kPose;
  int level = 0;  // 0 is the highest; at most PrioritizedIk::kMaxLevels - 1
  int link = -1;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();   // in the link
  Eigen::Isometry3d target = Eigen::Isometry3d::Identity();  // in world
  Eigen::Vector3d axes =
      Eigen::Vector3d::Ones();               // weight of x, y, z in world of positions; 0: free
  double weight = 1.0;                       // within its level
  const Eigen::VectorXd* posture = nullptr;  // [joint_count]
};

struct PrioritizedIkOptions {
  int iterations = 100;
  double tolerance = 1e-6;       // of each level that is not a posture [m], rotations weighted
  double rotation_weight = 0.3;  // [m/rad]
  double damping = 0.1;          // times the error of the level
  double largest_step = 0.4;     // of a joint in one step [rad or m]
  double limit_margin = 0.0;     // [rad or m]
};

struct PrioritizedIkResult {
  bool reached = false;   // every level that is not a posture
  int first_missed = -1;  // level
  int iterations = 0;
  std::array<double, 8> error{};  // per level, weighted [m]: by how much it is missed
};

class PrioritizedIk {
 public:
  static constexpr int kMaxLevels = 8;
  static constexpr int kMaxRows = 96;  // of all levels together, three per position or rotation

  explicit PrioritizedIk(const Model& model);

  // A joint that must not move, until set free again.
  void hold(int joint, bool held) noexcept;
  // The base may move (that of a floating one may from the start).
  void free_base(bool free) noexcept { base_free_ = free; }

  // configuration: where to start, then the solution.  Joints end within limits.  What is asked of
  // the tasks: known links, finite targets, levels in range, no more than kMaxRows rows; else nothing
  // moves and nothing is reached.
  PrioritizedIkResult solve(std::span<const IkTask> tasks, const PrioritizedIkOptions& options,
                            Configuration& configuration) noexcept;

 private:
  using Columns = Eigen::MatrixXd;  // [6 + joint_count] per row of a task: Jacobians, transposed
  struct Level {
    int first = 0, count = 0;  // rows
    bool posture = false;
  };

  bool sound(std::span<const IkTask> tasks) const noexcept;
  void linearise(std::span<const IkTask> tasks, const PrioritizedIkOptions& options,
                 const Configuration& configuration) noexcept;
  void add_rows(const IkTask& task, const PrioritizedIkOptions& options,
                const Configuration& configuration) noexcept;
  void add_row(double error, double weight) noexcept;
  // Only levels before `end`.
  void solve_levels(const PrioritizedIkOptions& options, int end) noexcept;
  bool hold_at_limits(const PrioritizedIkOptions& options,
                      const Configuration& configuration) noexcept;
  // One step of at most trust; its size comes back.
  double step(std::span<const IkTask> tasks, const PrioritizedIkOptions& options, int end,
              double trust, Configuration& configuration) noexcept;
  void move(double share, const PrioritizedIkOptions& options,
            Configuration& configuration) const noexcept;
  double low(int joint, const PrioritizedIkOptions& options) const noexcept;
  double high(int joint, const PrioritizedIkOptions& options) const noexcept;
  int first_posture() const noexcept;  // level
  PrioritizedIkResult result(const PrioritizedIkOptions& options) const noexcept;

  const Model* model_;
  Kinematics kinematics_;
  bool base_free_;
  std::vector<char> held_, fixed_;  // by the caller; columns that stay in this step
  std::array<Level, kMaxLevels> levels_;
  int rows_ = 0;
  Eigen::MatrixXd jacobian_, com_jacobian_;
  Eigen::VectorXd row_;               // [6 + joint_count], of the row that is being added
  Columns task_, projected_, basis_;  // [6 + joint_count x kMaxRows]
  Eigen::VectorXd error_, step_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxRows, kMaxRows>
      normal_;
  Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxRows, 1> right_;
  Configuration trial_;
};

}  // namespace twinbus
