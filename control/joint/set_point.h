// What a mode wants of every joint on the bus this tick: torque = tau + kp (q - q_measured) + kd
// (qd - qd_measured).

#pragma once

#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline control {

struct SetPoint {
  PerJoint<double> q{};    // [rad or m]
  PerJoint<double> qd{};   // [rad/s or m/s]
  PerJoint<double> tau{};  // [N m or N]
  PerJoint<double> kp{};
  PerJoint<double> kd{};
};

}  // namespace twinbus::control
