// Where the base is, from what a robot can measure: IMU, encoders and foot forces.
//
// Used by the controller and by a simulator that tracks another source, so that both mean the same.  World: z up, origin
// and heading where the first state was; goes on across a switch.  Slip-aware estimation comes with walking.

#pragma once

#include <Eigen/Geometry>

#include "robot/kinematics.h"
#include "robot/model.h"
#include "robot/robot_io.h"

namespace twinbus {

class Estimator {
 public:
  explicit Estimator(const Model& model);

  // Starts again: the base stands with its loaded soles on the ground plane z = 0, midway at x = y = 0, heading 0.
  void reset() noexcept;

  // One call per tick.  A new run_id (a switch) re-bases heading and position so that the estimate does not jump.
  void update(const RobotState& state) noexcept;

  const Configuration& configuration() const noexcept { return configuration_; }  // base pose and velocity, joints
  const Kinematics& kinematics() const noexcept { return kinematics_; }           // updated for it
  // Sole frames, and the frame midway between them with z up: the ground frame of arm_goal_t.
  const Eigen::Isometry3d& sole_in_world(int foot) const noexcept { return sole_[static_cast<std::size_t>(foot)]; }
  const Eigen::Isometry3d& ground_in_world() const noexcept { return ground_; }
  // Force and torque on a sole about its sole frame's origin, in world [N, N m]; zero when not measured.
  const Eigen::Vector3d& sole_force(int foot) const noexcept { return force_[static_cast<std::size_t>(foot)]; }
  const Eigen::Vector3d& sole_torque(int foot) const noexcept { return torque_[static_cast<std::size_t>(foot)]; }
  bool loaded(int foot) const noexcept { return loaded_[static_cast<std::size_t>(foot)]; }
  // Measured zero-moment point in world, z of the ground; com projection when no foot is loaded.
  const Eigen::Vector3d& zmp() const noexcept { return zmp_; }
  // Distance of a ground point (world) to the edge of the convex hull of the loaded soles, positive inside [m].
  double support_margin(const Eigen::Vector3d& point) const noexcept;

 private:
  const Model* model_;
  Configuration configuration_;
  Kinematics kinematics_;
  std::array<Eigen::Isometry3d, 2> sole_;
  Eigen::Isometry3d ground_;
  std::array<Eigen::Vector3d, 2> force_, torque_;
  std::array<bool, 2> loaded_{};
  Eigen::Vector3d zmp_;
};

}  // namespace twinbus
