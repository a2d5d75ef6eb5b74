// How base and legs move when the centre of mass and the trunk do and the soles stay where they are.
//
// With the soles at rest six coordinates a leg (robot/kinematics/leg_motion.h) leave nothing free: for base acceleration a and
// turning alpha
//
//     x_f = -J_f^-1 [a + alpha x r_f; alpha]                    per leg, so that its sole rests
//     a_com = a + alpha x r_com + sum_f C_f x_f                   C_f: of the centre of mass by the leg
//
// are linear, and a follows from a_com by three equations.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/kinematics/leg_motion.h"

namespace twinbus::inline control {

class StandingMotion {
 public:
  // Throws std::runtime_error unless both legs have five to seven joints.
  explicit StandingMotion(const Model& model);

  // For the posture of kinematics, world.  False when a leg is too straight to say: then nothing else is
  // asked before an update that is true.
  bool update(const Kinematics& kinematics) noexcept;
  // Velocity products are left out.  Fills the legs' entries of qdd [joint_count] and returns a, of link 0's origin.
  Eigen::Vector3d solve(const Eigen::Vector3d& com_acceleration, const Eigen::Vector3d& turning,
                        Eigen::VectorXd& qdd) const noexcept;
  // Adds to qdd what brings the seventh joint's freedom back to half_sitting: the soles do not see it.
  void keep_posture(const Configuration& now, Eigen::VectorXd& qdd) const noexcept;

  bool is_leg(int joint) const noexcept { return leg_mask_[static_cast<std::size_t>(joint)]; }

 private:
  using Matrix6 = LegMotion::Matrix6;
  using Matrix36 = Eigen::Matrix<double, 3, 6>;

  const Model* model_;
  double mass_;
  std::array<LegMotion, 2> leg_;
  Configuration home_;
  std::vector<bool> leg_mask_;
  std::array<Matrix6, 2> inverse_{Matrix6::Zero(), Matrix6::Zero()};         // J_f^-1
  std::array<Matrix36, 2> com_by_sole_{Matrix36::Zero(), Matrix36::Zero()};  // C_f J_f^-1
  std::array<Eigen::Vector3d, 2> sole_{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};  // r_f
  Eigen::Vector3d com_ = Eigen::Vector3d::Zero();                                          // r_com
  Eigen::Matrix3d com_by_base_ = Eigen::Matrix3d::Identity();  // inverse
};

}  // namespace twinbus::control
