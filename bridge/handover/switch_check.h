// Is the target of a switch close enough to the active source?  Each way of not being so has its
// own refusal.

#pragma once

#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

// Compares what both measure: joints, tilt, angular velocity, feet.  A sensor that either lacks is
// left out. kNone if they are close enough; a number that is not finite is never close.
Refusal compare_measured(const RobotState& active, const RobotState& target) noexcept;

}  // namespace twinbus::bridge
