// Is the target of a switch close enough to the active source?  Each way of not being so has its
// own refusal.

#pragma once

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

// doc/protocol.md section 4.
struct SwitchTolerance {
  double position = 0.05;  // [rad or m]
  double velocity = 0.5;   // [rad/s or m/s]
  double tilt = 0.05;      // roll and pitch [rad]
  double gyro = 0.3;       // [rad/s]
  double load = 0.2;       // of the total foot force
  double loaded = 30.0;    // a foot carries weight from here on [N]
};

// Compares what both measure: joints, tilt, angular velocity, feet.  A sensor that either lacks is
// left out. kNone if they are close enough; a number that is not finite is never close.
Refusal compare_measured(const RobotState& active, const RobotState& target,
                         const SwitchTolerance& tolerance = {}) noexcept;

}  // namespace twinbus
