// Joint angles for a place of the centre of mass, an attitude of the base and two poses of the soles.
//
// Exactly determined: base position and six coordinates a leg (robot/kinematics/leg_motion.h): a leg of five joints lets one
// axis of its sole follow, one of seven stays near half_sitting.  A round moves the base by what the centre of mass misses and
// takes one Newton step per leg; a knee that is nearly straight gives up exactness instead of its speed (damped least
// squares), and no joint leaves its limits.

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "robot/kinematics/kinematics.h"
#include "robot/kinematics/leg_motion.h"
#include "control/legs/leg_reach.h"

namespace twinbus::inline control {

class WholeBodyIk {
 public:
  // Throws std::runtime_error unless both legs have five to seven joints and a knee.
  explicit WholeBodyIk(const Model& model);

  // Begins at a posture.
  void start(const Configuration& now) noexcept;
  // q [joint_count]: of the joints that are not of a leg; what they move the centre of mass by is seen with the next
  // update().  Velocities of the result are not touched.
  void solve(const Eigen::Vector3d& com, const Eigen::Matrix3d& base,
             const std::array<Eigen::Isometry3d, 2>& soles, const Eigen::VectorXd& q,
             int rounds) noexcept;

  Configuration& configuration() noexcept { return configuration_; }
  const Configuration& configuration() const noexcept { return configuration_; }
  // After its velocities have been set: kinematics of it.
  void update() noexcept;
  const Kinematics& kinematics() const noexcept { return kinematics_; }
  bool is_leg(int joint) const noexcept { return leg_mask_[static_cast<std::size_t>(joint)]; }
  double error() const noexcept { return error_; }  // of the last round's start [m, rad]

 private:
  void step_leg(std::size_t foot, const Eigen::Isometry3d& sole,
                const Eigen::Vector3d& shift) noexcept;

  const Model* model_;
  std::array<LegMotion, 2> leg_;
  std::array<LegReach, 2> reach_;
  std::vector<bool> leg_mask_;
  Configuration home_;
  Configuration configuration_;
  Kinematics kinematics_;
  bool current_ = false;  // the kinematics are those of the configuration
  double error_ = 0.0;
};

}  // namespace twinbus::control
