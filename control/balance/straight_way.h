// A posture on the straight way from one set of joint positions to another, as Posture moves them.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline control {

// from, to: of the joints on the bus [rad or m]; mask: bit per joint that goes to `to`; share: 0 .. 1 of the way.  Joints stay
// within their limits, mimic joints follow; the base is left as it is.
void place_on_way(const Model& model, const PerJoint<double>& from, const PerJoint<double>& to, std::int64_t mask, double share,
                  Configuration& place) noexcept;

}  // namespace twinbus::control
