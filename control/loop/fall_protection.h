// A fall that no step catches any more is met, not fought: knees bend, arms come before the body, gains go down.
//
// The arms go where the robot's own pose `brace` says (SRDF group_state); a robot without one keeps its arms and bends its
// knees.  What is given up is balance: nobody should ask for it before the robot is really lost.

#pragma once

#include "control/joint/posture.h"
#include "control/joint/set_point.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class Brace {
 public:
  explicit Brace(const Model& model);

  // The trunk leans, or is about to lean, farther than it does while a step or the ankles still help.
  static bool is_lost(const Estimator& estimator) noexcept;

  // last: the set-points that were put out before.
  void start(const SetPoint* last, const RobotState& state, Posture& posture) noexcept;
  // One tick; the posture has advanced.
  void update(const Estimator& estimator, const Posture& posture, double dt,
              SetPoint& set_point) noexcept;
  // The robot lies, or stands after all, and moves no more.
  bool over() const noexcept { return quiet_ >= kQuiet || time_ >= kLongest; }

 private:
  static constexpr double kQuiet = 0.3, kLongest = 3.0;  // [s]

  const Model* model_;
  PerJoint<double> q_{};
  std::int64_t mask_ = 0;  // bit per bus joint that goes to q_
  double time_ = 0.0, quiet_ = 0.0;
};

}  // namespace twinbus::control
