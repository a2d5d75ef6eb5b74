// What the servo of one joint is asked for.

#pragma once

#include "lcmtypes/msg/status.h"

namespace twinbus::inline sim {

// torque = tau + kp (q - q_now) + kd (qd - qd_now), within the effort limit.
struct ServoTarget {
  double q = 0.0;    // [rad or m]
  double qd = 0.0;   // [rad/s or m/s]
  double tau = 0.0;  // [N m or N]
  double kp = 0.0;   // >= 0
  double kd = 0.0;   // >= 0
};

// kNotFinite or kOutOfRange (negative gain, absurd size) for a target that no servo may have.
Status check_target(const ServoTarget& target) noexcept;

}  // namespace twinbus::sim
