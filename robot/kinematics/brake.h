// How hard a joint is braked when something holds it: the gate, the loop and the guard that looks
// ahead agree on it here.

#pragma once

#include <algorithm>

#include "robot/description/model.h"

namespace twinbus {

inline constexpr double kBrakeTime = 0.1;  // from full speed to rest [s]
inline constexpr double kSlowestFull =
    0.5;  // a joint slower than this is braked as if it were so fast [rad/s or m/s]

// [rad/s^2 or m/s^2]
inline double brake_deceleration(const Joint& joint) noexcept {
  return std::max(joint.velocity, kSlowestFull) / kBrakeTime;
}

}  // namespace twinbus
