// How hard a joint is braked when something holds it, and how fast its torque may change: the gate, the loop and the guard
// that looks ahead agree on it here.

#pragma once

#include <algorithm>
#include <cmath>

#include "robot/description/model.h"

namespace twinbus::inline robot {

inline constexpr double kBrakeTime = 0.1;  // from full speed to rest [s]
inline constexpr double kSlowestFull =
    0.5;  // a joint slower than this is braked as if it were so fast [rad/s or m/s]

inline constexpr double kTorqueStep = 0.1;  // largest change of a joint's torque from tick to tick, of its effort

// Gains of a hold.
inline double hold_kp(const Joint& joint) noexcept { return joint.stop_kp > 0.0 ? joint.stop_kp : joint.kp; }
inline double hold_kd(const Joint& joint) noexcept { return joint.stop_kd > 0.0 ? joint.stop_kd : joint.kd; }

// The largest gains that the gate lets through.
inline constexpr double kGainRange = 10.0;  // of the joint's own
inline double most_kp(const Joint& joint) noexcept { return joint.kp > 0.0 ? kGainRange * joint.kp : 1e6; }
inline double most_kd(const Joint& joint) noexcept { return joint.kd > 0.0 ? kGainRange * joint.kd : 1e5; }

// How fast a set-point may move [rad/s or m/s].
inline double set_point_rate(const Joint& joint) noexcept { return joint.rate > 0.0 ? joint.rate : 1.05 * joint.velocity; }

// A servo with less than this share of the stiffness of a hold does not go where its set-point is.  Nor does a set-point that
// is farther than this from its joint say where a brake ends: both are braked from where the joint is and as fast as it is.
inline constexpr double kSoftShare = 0.9;
inline constexpr double kFarSetPoint = 0.03;  // [rad or m]

inline bool is_soft(double kp, const Joint& joint) noexcept { return kp < kSoftShare * std::min(joint.kp, hold_kp(joint)); }

// Where a brake begins, with at least the gains of a hold.  A set-point that its joint follows is braked as it is; the less
// the joint follows, the more of the brake begins at the joint itself.  Nothing jumps in between: who foretells the brake
// knows the joint better than the set-point.
inline constexpr double kFollowed = 0.01;      // from its set-point, a joint follows it [rad or m]
inline constexpr double kFollowedFor = 0.05;   // as far apart as that are speeds that differ by it in this time [s]
struct BrakeStart {
  double q, v;     // [rad or m], [rad/s or m/s]
  double share;    // of the set-point in it, and of its torque beside the servo's
};
inline BrakeStart brake_start(double set_q, double set_v, double q, double v, double fastest, bool soft) noexcept {
  const double apart = std::abs(set_q - q) + kFollowedFor * std::abs(set_v - v);
  const double share = soft ? 0.0 : std::clamp((kFarSetPoint - apart) / (kFarSetPoint - kFollowed), 0.0, 1.0);
  return {q + share * (set_q - q), std::clamp(v + share * (set_v - v), -fastest, fastest), share};
}

// [rad/s^2 or m/s^2]
inline double brake_deceleration(const Joint& joint) noexcept {
  return std::max(joint.velocity, kSlowestFull) / kBrakeTime;
}

// One tick of coming to rest: position and velocity after dt [s] of that deceleration.
inline void brake_step(double deceleration, double dt, double& q, double& v) noexcept {
  const double slower = std::copysign(std::max(0.0, std::abs(v) - deceleration * dt), v);
  q += 0.5 * (v + slower) * dt;
  v = slower;
}
inline void brake_step(double deceleration, double dt, double& q, float& v) noexcept {
  double speed = static_cast<double>(v);
  brake_step(deceleration, dt, q, speed);
  v = static_cast<float>(speed);
}

}  // namespace twinbus::robot
