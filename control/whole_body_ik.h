// Base position and twelve leg angles from the centre of mass, the base orientation and two sole
// poses.
//
// Exactly determined, so no weights: each round moves the base by the error of the centre of mass
// and takes one Newton step per leg.  Near a straight knee the step is damped, so a leg that cannot
// reach stays finite.  The other joints are given.  Works for any robot whose soles hang on the
// base by six joints each.

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "robot/kinematics.h"
#include "robot/model.h"

namespace twinbus {

// Joints from the base to a sole, base first.
struct LegChain {
  std::array<int, 6> joint{};
  int count = 0;  // 6, or the leg is not one this file can solve
};
LegChain leg_chain(const Model& model, int foot);

class WholeBodyIk {
 public:
  // Throws std::runtime_error unless both legs have six joints.
  explicit WholeBodyIk(const Model& model);

  // The first guess; base pose and joints in any frame, which becomes the frame of everything else.
  void start(const Configuration& configuration) noexcept;
  // A given joint that is not of a leg.
  void set_joint(int joint, double q) noexcept { configuration_.q[joint] = q; }
  // Soles left, right.  Returns the largest error left [m, rad].
  double solve(const Eigen::Vector3d& com, const Eigen::Matrix3d& base,
               const std::array<Eigen::Isometry3d, 2>& soles, int rounds) noexcept;

  const Configuration& configuration() const noexcept { return configuration_; }
  Configuration& configuration() noexcept { return configuration_; }
  const Kinematics& kinematics() const noexcept { return kinematics_; }
  bool is_leg(int joint) const noexcept { return leg_mask_[static_cast<std::size_t>(joint)]; }

 private:
  double step_leg(std::size_t foot, const Eigen::Vector3d& base_shift,
                  const Eigen::Isometry3d& target) noexcept;

  const Model* model_;
  Configuration configuration_;
  Kinematics kinematics_;
  std::array<LegChain, 2> leg_;
  std::vector<bool> leg_mask_;
  std::array<double, 2> healthy_{};  // determinant of the leg Jacobian in a bent posture
};

}  // namespace twinbus
