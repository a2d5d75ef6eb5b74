// Brings masked joints to rest on the spot and lets them go again smoothly: what the controller
// does itself with a guard's hold mask, so that the gate has nothing left to do.

#pragma once

#include <array>
#include <cstdint>

#include "control/joint/min_jerk.h"
#include "control/joint/set_point.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class MaskBrake {
 public:
  explicit MaskBrake(const Model& model) noexcept : model_(&model) {}

  void reset() noexcept { phase_.fill(Phase::kFree); }
  // set_point: what is asked in, what may be done out.
  void apply(SetPoint& set_point, std::int64_t mask, double dt) noexcept;

 private:
  enum class Phase : std::int8_t { kFree, kHeld, kReturning };

  const Model* model_;
  std::array<Phase, kMaxJoints> phase_{};
  std::array<MinJerk, kMaxJoints> offset_{};
  PerJoint<double> q_{}, qd_{};  // as last put out
};

}  // namespace twinbus::control
