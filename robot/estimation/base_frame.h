// A robot's posture seen from its base: joints as STATE says, the base at the origin and at rest.

#pragma once

#include "lcmtypes/msg/robot_io.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

inline void set_in_base_frame(const Model& model, const RobotState& state, Configuration& configuration) noexcept {
  set_joints(model, state, configuration);
  configuration.base.setIdentity();
  configuration.base_velocity.setZero();
  configuration.base_angular_velocity.setZero();
}

}  // namespace twinbus::robot
