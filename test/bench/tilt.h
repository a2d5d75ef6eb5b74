// How far a measured robot leans.

#pragma once

#include <algorithm>
#include <cmath>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

// Between its vertical and the world's [degrees].
inline double tilt_of(const RobotState& s) {
  const double x = static_cast<double>(s.attitude[1]), y = static_cast<double>(s.attitude[2]);
  return 57.29578 * std::acos(std::clamp(1.0 - 2.0 * (x * x + y * y), -1.0, 1.0));
}

}  // namespace twinbus
