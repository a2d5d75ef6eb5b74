// Joint angles that put a frame of a link where it is wanted: damped least squares with joint
// limits, for one chain, from seeds in closed form where the chain allows it.
//
// Solves    minimise |W (target - pose(q))|^2 + damping^2 |dq|^2    step by step, holding joints at
// their limits as long as they push outwards.  The chain runs from a base link to a link behind it;
// targets are given in the base link's frame, so neither a Kinematics object nor the base pose is
// needed.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "robot/kinematics/closed_form.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

struct IkOptions {
  int iterations = 60;
  double position_tolerance = 1e-6;  // [m]
  double rotation_tolerance = 1e-6;  // [rad]
  double rotation_weight = 0.3;      // [m/rad]; 0: only the position counts
  // Further tries from other postures when the target is missed.  With restarts the
  // first try is the closed form nearest to the start.
  int restarts = 0;
  double limit_margin = 0.0;  // stays this far inside the limits [rad or m]
};

struct IkResult {
  bool reached = false;
  int iterations = 0;
  double position_error = 0.0;  // [m]
  double rotation_error = 0.0;  // [rad]
};

class InverseKinematics {
 public:
  static constexpr int kMaxChain = 16;

  // frame: in the link.  Throws std::runtime_error if link does not hang on base_link, or by more
  // than kMaxChain joints.
  InverseKinematics(const Model& model, int base_link, int link, const Eigen::Isometry3d& frame);

  // Model joint indices of the chain, base first.  Mimic joints on the way stay as they are in q.
  const std::vector<int>& joints() const noexcept { return joints_; }
  // This joint of the chain (model index) stays there from now on [rad or m].
  void hold(int joint, double place) noexcept;

  // q [joint_count]: the starting posture, then the solution; only joints of the chain change, and
  // they stay within their limits.  When the target cannot be reached the nearest posture found is
  // left in q.
  IkResult solve(const Eigen::Isometry3d& target, const IkOptions& options,
                 Eigen::VectorXd& q) noexcept;

  // The frame in the base link's frame.
  Eigen::Isometry3d pose(const Eigen::VectorXd& q) const noexcept;

 private:
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, kMaxChain>;
  using Step = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxChain, 1>;
  using Normal =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxChain, kMaxChain>;

  IkResult descend(const Eigen::Isometry3d& target, const IkOptions& options,
                   bool may_give_up) noexcept;
  // From now_, a try like any other; the result is in now_.  sure: the target is out of reach.
  bool closed_form(const Eigen::Isometry3d& target, const IkOptions& options, bool& sure) noexcept;
  Eigen::Isometry3d pose_and_axes(const Eigen::VectorXd& q) noexcept;
  Step step(const Eigen::Matrix<double, 6, 1>& error, double damping, const IkOptions& options,
            const Eigen::VectorXd& q) noexcept;
  double low(std::size_t i, const IkOptions& options) const noexcept;
  double high(std::size_t i, const IkOptions& options) const noexcept;

  const Model* model_;
  std::vector<int> path_;    // all joints on the way, base first
  std::vector<int> joints_;  // those that may move
  std::array<double, kMaxChain> held_;  // where one of them stays; not finite: it moves
  Eigen::Isometry3d frame_;
  std::array<Eigen::Vector3d, kMaxChain> axis_, origin_;  // of joints_, base link's frame
  Jacobian jacobian_;
  ClosedForm closed_;
  std::array<double, kMaxChain> seed_step_{};  // of restarts, of the width between the limits
  Eigen::VectorXd trial_, now_, best_;
};

}  // namespace twinbus::robot
