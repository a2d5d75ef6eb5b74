// Where a robot at rest stands: the base pose at which the springs under its soles carry it, and
// the joint torques that go with it, so that a simulation starts without a jump.

#pragma once

#include <Eigen/Core>
#include <array>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline sim {

struct Standing {
  Configuration configuration;  // at rest
  Eigen::VectorXd tau;          // [joint_count] that keeps it at rest, within the limits [N m or N]
  Eigen::VectorXd needed;       // the same, whatever the limits
  std::array<std::array<double, 4>, 2> corner_force{};  // normal, left and right sole [N]
  bool balanced = false;  // false: the centre of mass is outside the soles; the robot will tip
};

// q: [joint_count].  mass: of the whole robot, for model.mass_scale.  stiffness: of one corner of
// each sole [N/m]. The soles' midpoint is put at x = y = 0, heading 0.  fixed_base: the base is put
// hanging above the ground and the torques carry the links alone.
Standing stand(const Model& model, const Eigen::VectorXd& q, double mass_scale,
               const std::array<double, 2>& stiffness, const std::array<double, 2>& ground_height,
               bool fixed_base);

// Moves the base up or down and tilts it so that the corner springs come nearest to the normal
// forces wanted [N]; joints stay.  kinematics: scratch.
void fit_base_to_corner_forces(const Model& model,
                               const std::array<std::array<double, 4>, 2>& force,
                               const std::array<double, 2>& stiffness,
                               const std::array<double, 2>& ground_height, Kinematics& kinematics,
                               Configuration& configuration) noexcept;

// Normal forces at the corners of a sole that have the resultant force fz [N] and torque mx, my [N
// m] about the sole frame's origin: the distribution of a plane on springs.  A corner never pulls.
std::array<double, 4> corner_forces(const Sole& sole, double fz, double mx, double my) noexcept;

}  // namespace twinbus::sim
