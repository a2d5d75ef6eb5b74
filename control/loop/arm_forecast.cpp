#include "control/loop/arm_forecast.h"

#include <algorithm>

namespace twinbus::inline control {

namespace {
constexpr double kForecastBrakeTime = 0.3;  // from full speed to rest [s]
}

bool ArmForecast::advance(bool brakes, double dt) noexcept {
  if (brakes) share_ = std::max(0.0, share_ - dt / kForecastBrakeTime);
  gone_ += share_ * dt;
  posture_.advance(share_ * dt);
  if (path_id_ == 0) return true;
  if (arm_->path_id() != path_id_) return false;
  time_ += share_ * rate_ * dt;
  arm_->place(time_, share_ * rate_, posture_);
  return true;
}

}  // namespace twinbus::control
