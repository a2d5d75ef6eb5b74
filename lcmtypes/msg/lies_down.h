// Whether a robot lies, by the estimate that its source makes of its base: what is known of a fall without a simulator and without the
// robot's description, which says how its IMU is built in.

#pragma once

#include <cmath>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

inline constexpr double kLiesTilt = 1.0471975511965976;  // 60 degrees [rad]

// A free base that is tilted by more than that.
inline bool lies_down(const Estimate& estimate) noexcept {
  const double x = estimate.base_attitude[1], y = estimate.base_attitude[2];
  return estimate.velocity_from != VelocityFrom::kFixed && 1.0 - 2.0 * (x * x + y * y) < std::cos(kLiesTilt);
}

}  // namespace twinbus::lcmtypes
