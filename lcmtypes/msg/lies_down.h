// Whether a robot lies, by its own sensor of attitude: what is known of a fall without a simulator.

#pragma once

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline lcmtypes {

// Cosine of the tilt: z axis of a rotation w x y z, along the vertical.
inline double upright(const RobotState& state) noexcept {
  const double x = static_cast<double>(state.attitude[1]), y = static_cast<double>(state.attitude[2]);
  return 1.0 - 2.0 * (x * x + y * y);
}

// Tilted by more than 60 degrees; false without a sensor.
inline bool lies_down(const RobotState& state) noexcept { return (state.sensor_flags & kImuValid) != 0 && upright(state) < 0.5; }

}  // namespace twinbus::lcmtypes
