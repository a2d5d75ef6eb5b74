// Where a planned motion begins.

#pragma once

#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline planner {

// A set-point this near to its joint is where the motion goes on from, not where the servo's error has left the joint; one
// farther away is none to start from.  As far as the guard believes a set-point [rad or m].
inline constexpr double kServoError = 0.1;

// measured: the robot as the estimator has it after `state`.  A command of another run than the state's, or none, leaves it.
Configuration plan_start(const Model& model, const Configuration& measured, const RobotState& state,
                         const JointCommand& command);

}  // namespace twinbus::planner
