// Torque that carries the robot at rest in a posture: gravity against the ground under both soles,
// or against nothing.

#pragma once

#include <vector>

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
  const Model* model_;
  double mass_;
  Configuration configuration_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  Eigen::VectorXd no_acceleration_;
  std::vector<ExternalWrench> standing_, hanging_;
};

}  // namespace twinbus::control
