// Whether a standing robot still stands on the way to a pose that moves its legs: both soles as they are to each other, the
// centre of mass over them.
//
// Quasi-static: a posture of joints on a straight way, as Posture moves them.  What the arms touch is the guard's.

#pragma once

#include "robot/description/model.h"
#include "robot/estimation/estimator.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline control {

class PoseCheck {
 public:
  // The robot has two soles.
  explicit PoseCheck(const Model& model);

  // from, to: of the joints on the bus [rad or m]; mask: bit per joint that goes to `to`.  Null, or a sentence that lives for
  // ever: why not.
  const char* why_not(const Estimator& estimator, const PerJoint<double>& from,
                      const PerJoint<double>& to, std::int64_t mask) noexcept;

 private:
  const Model* model_;
  Configuration way_;
  Kinematics kinematics_;
};

}  // namespace twinbus::control
