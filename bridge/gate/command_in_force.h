// Which command a measured torque comes of, for a source that takes over from another.
//
// The newest command of a client may not have come to act yet, or only in part (the gate lets a set-point move by its rate):
// a client of 50 Hz moves its set-points far at once.  A torque between those of its last two commands is its own
//
//     tau = kp (q_ref - q) + kd (qd_ref - qd) + tau_ref, within the effort limit
//
// (of the same gains; else only that of the one before) and no jump of the switch.  Any other is, and what is missing is added to the newest command.

#pragma once

#include "bridge/gate/gate_limits.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

// Fills in_force.  False: a joint's torque comes of neither; in_force is the newest, with the torque that gives what was measured.
bool find_command_in_force(const RobotState& measured, const JointCommand& before, const JointCommand& newest,
                           const GateLimits& limits, JointCommand& in_force) noexcept;

}  // namespace twinbus::bridge
