// Tells a driver that repeats its last reading from a robot that stands still.
//
// Encoders, gyro and accelerometer that show the same to the last bit, tick after tick, while the posture that is
// commanded goes away from what it was: no real robot does that, nor a simulated one.  Without an IMU nothing is said:
// coarse encoders alone may well stand still.

#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline bridge {

class FrozenSensors {
 public:
  void reset() noexcept { since_ns_ = -1; }

  // What was measured this tick and what is written in answer; true while the sensors are frozen.
  bool look(const RobotState& state, const JointCommand& written, std::int64_t now_ns) noexcept {
    const bool has_imu = (state.sensor_flags & kImuValid) != 0;
    const bool same = has_imu && since_ns_ >= 0 && alike(state.q, state_.q) &&
                      alike(state.qd, state_.qd) && alike(state.gyro, state_.gyro) &&
                      alike(state.accel, state_.accel);
    if (!same) {
      state_ = state;
      written_ = written;
      since_ns_ = now_ns;
      return false;
    }
    if (now_ns - since_ns_ < kLongest_ns) return false;
    for (std::size_t j = 0; j < static_cast<std::size_t>(state.joint_count); ++j) {
      if (std::abs(written.q[j] - written_.q[j]) > kMoved) return true;
    }
    return false;
  }

 private:
  static constexpr std::int64_t kLongest_ns = 200'000'000;
  static constexpr double kMoved = 0.02;  // of a command [rad]

  template <class T>
  static bool alike(const T& a, const T& b) noexcept {
    return std::memcmp(a.data(), b.data(), sizeof(a)) == 0;
  }

  std::int64_t since_ns_ = -1;
  RobotState state_;
  JointCommand written_;
};

}  // namespace twinbus::bridge
