// What the gate needs of the model.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/dynamics/pair_torque.h"

namespace twinbus::inline bridge {

// Arrays are per joint on the bus.
struct GateLimits {
  explicit GateLimits(const Model& model);  // the model must outlive this
  const Model* robot;
  PairTorque pairs;  // of joints that share motors
  int joint_count = 0;
  std::int64_t model_hash = 0;
  std::int64_t arms = 0;  // bit per joint
  std::int64_t legs = 0;
  std::int64_t all = 0;
  double period = 0.0;  // [s]
  std::int64_t period_ns = 0;
  std::int64_t command_timeout_ns = 0;
  std::int64_t guard_timeout_ns = 0;
  double blend_s = 0.0;
  bool damp_when_off = true;
  PerJoint<double> lower{}, upper{};      // [rad or m]
  PerJoint<double> velocity{}, effort{};  // [rad/s or m/s], [N m or N]
  PerJoint<double> step{};                // largest change of a position in one period [rad or m]
  PerJoint<double> brake{};  // deceleration of a joint brought to rest [rad/s^2 or m/s^2]
  PerJoint<float> kp{}, kd{}, kp_max{}, kd_max{}, stop_kp{}, stop_kd{};
};

}  // namespace twinbus::bridge
