// Whether the legs can squat so deep: the posture at the bottom, soles where they are, within the joints' limits, and what
// carrying the robot there takes within their efforts.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "control/legs/whole_body_ik.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/pair_torque.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class SquatCheck {
 public:
  // Throws std::runtime_error unless both legs have five to seven joints and a knee.
  explicit SquatCheck(const Model& model);

  // depth: of the centre of mass below where it is [m].  Null, or a sentence that lives for ever: why not.
  const char* why_not(const Estimator& estimator, double depth) noexcept;

 private:
  const Model* model_;
  PairTorque torque_;
  WholeBodyIk ik_;
  InverseDynamics dynamics_;
  Eigen::VectorXd still_, tau_;
  std::vector<ExternalWrench> wrench_;
};

}  // namespace twinbus::control
