// Torque that carries the robot at rest in a posture: gravity against the ground under both soles, against the point feet
// that stand (point_load_share.h), or against nothing.

#pragma once

#include <vector>

#include "control/legs/point_load_share.h"
#include "control/legs/wrench_share.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class StaticTorque {
 public:
  explicit StaticTorque(const Model& model);

  // q [joint_count]: the posture that is held; the base is where the estimator says.  tau
  // [joint_count].
  void solve(const Estimator& estimator, const Eigen::VectorXd& q, Eigen::VectorXd& tau) noexcept;

 private:
  // Whether point feet carry the robot, and how: fills on_points_.
  bool stands_on_points(const Estimator& estimator) noexcept;

  const Model* model_;
  double mass_;
  Configuration configuration_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  Eigen::VectorXd no_acceleration_;
  std::vector<ExternalWrench> standing_, hanging_, on_points_;  // on_points_: of all point feet, those in the air without force
  PointLoads loads_;
};

}  // namespace twinbus::control
