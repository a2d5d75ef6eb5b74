#include "bridge/handover/switch_check.h"

#include <algorithm>
#include <cmath>

namespace twinbus::inline bridge {

namespace {

// How far both may be apart: doc/protocol.md section 4.
constexpr double kPosition = 0.05;  // [rad or m]
constexpr double kVelocity = 0.5;   // [rad/s or m/s]
constexpr double kTilt = 0.05;      // roll and pitch [rad]
constexpr double kGyro = 0.3;       // [rad/s]
constexpr double kLoad = 0.2;       // of the total foot force
constexpr double kLoaded = 30.0;    // a foot carries weight from here on [N]

// Direction of gravity seen by the IMU tells roll and pitch without heading.
void roll_pitch(const RobotState& state, double& roll, double& pitch) noexcept {
  const double w = static_cast<double>(state.attitude[0]);
  const double x = static_cast<double>(state.attitude[1]);
  const double y = static_cast<double>(state.attitude[2]);
  const double z = static_cast<double>(state.attitude[3]);
  roll = std::atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y));
  pitch = std::asin(std::clamp(2.0 * (w * y - z * x), -1.0, 1.0));
}

double force(const RobotState& state, int limb) noexcept {
  const auto& w = state.wrench[static_cast<std::size_t>(limb)];
  return std::hypot(static_cast<double>(w[0]), static_cast<double>(w[1]),
                    static_cast<double>(w[2]));
}

bool has_foot(const RobotState& state, int limb) noexcept {
  return state.wrench_kind[static_cast<std::size_t>(limb)] == WrenchKind::kMeasured &&
         (state.sensor_flags & wrench_valid(static_cast<Limb>(limb))) != 0;
}

}  // namespace

Refusal compare_measured(const RobotState& active, const RobotState& target) noexcept {
  if (active.joint_count != target.joint_count) return Refusal::kModelHash;
  for (int j = 0; j < active.joint_count; ++j) {
    const auto i = static_cast<std::size_t>(j);
    if (!(std::abs(active.q[i] - target.q[i]) <= kPosition)) return Refusal::kPosture;
  }
  for (int j = 0; j < active.joint_count; ++j) {
    const auto i = static_cast<std::size_t>(j);
    const double difference = static_cast<double>(active.qd[i]) - static_cast<double>(target.qd[i]);
    if (!(std::abs(difference) <= kVelocity)) return Refusal::kVelocity;
  }
  if ((active.sensor_flags & target.sensor_flags & kImuValid) != 0) {
    double roll = 0.0, pitch = 0.0, target_roll = 0.0, target_pitch = 0.0;
    roll_pitch(active, roll, pitch);
    roll_pitch(target, target_roll, target_pitch);
    const double roll_difference = std::remainder(roll - target_roll, 2.0 * M_PI);
    if (!(std::abs(roll_difference) <= kTilt)) return Refusal::kAttitude;
    if (!(std::abs(pitch - target_pitch) <= kTilt)) return Refusal::kAttitude;
    for (std::size_t i = 0; i < 3; ++i) {
      const double difference =
          static_cast<double>(active.gyro[i]) - static_cast<double>(target.gyro[i]);
      if (!(std::abs(difference) <= kGyro)) return Refusal::kGyro;
    }
  }
  double total = 0.0, target_total = 0.0;
  for (int foot = 0; foot < kMaxFeet; ++foot) {
    if (!has_foot(active, foot) || !has_foot(target, foot)) continue;
    const double f = force(active, foot);
    const double g = force(target, foot);
    if (!std::isfinite(f + g) || (f > kLoaded) != (g > kLoaded))
      return Refusal::kFeet;
    total += f;
    target_total += g;
  }
  if (!(std::abs(total - target_total) <= kLoad * total + 1e-9)) return Refusal::kLoad;
  return Refusal::kNone;
}

}  // namespace twinbus::bridge
