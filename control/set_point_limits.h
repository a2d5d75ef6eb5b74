// Nothing leaves the controller that is not finite and within the robot's limits; the gate of the
// source finds nothing left to clamp.

#pragma once

#include "control/set_point.h"
#include "robot/model.h"
#include "robot/robot_io.h"

namespace twinbus {

// A joint with a number that is not one stays where it was put last (last, else measured), with its
// default gains.  Then position, way since last, velocity and torque are clamped to the joint's limits.
// last: put out dt seconds ago; null at the beginning.
void limit_set_points(const Model& model, const RobotState& state, const SetPoint* last, double dt,
                      SetPoint& set_point) noexcept;

}  // namespace twinbus
