// What the simulated robot's sensors read: encoders, torques, IMU, force sensors at feet and hands.
//
// Ideal by default: noise, bias, quantisation, delay and drift are off unless a setting asks for
// them (sim/settings.h). Foot and hand wrenches are those of the contacts beyond the sensor.

#pragma once

#include <cstdint>
#include <vector>

#include "robot/model.h"
#include "robot/robot_io.h"
#include "sim/random.h"
#include "sim/world.h"

namespace twinbus {

// Noise is the standard deviation of white Gaussian noise, per tick.
struct SensorOptions {
  double encoder_noise = 0.0;    // [rad or m]
  double encoder_quantum = 0.0;  // one count [rad or m]
  double velocity_noise = 0.0;   // [rad/s]
  double torque_noise = 0.0;     // [N m]
  double attitude_noise = 0.0;   // [rad]
  double gyro_noise = 0.0;       // [rad/s]
  double accel_noise = 0.0;      // [m/s^2]
  double force_noise = 0.0;      // [N]
  double moment_noise = 0.0;     // [N m]
  double roll_bias = 0.0;        // of the attitude [rad]
  double pitch_bias = 0.0;
  double gyro_bias = 0.0;   // on every axis [rad/s]
  double accel_bias = 0.0;  // on every axis [m/s^2]
  double yaw_drift = 0.0;   // of the attitude about the vertical [rad/s]
  int delay_ticks = 0;      // of everything, 0 .. kMaxSensorDelay
  std::uint64_t seed = 1;
};

inline constexpr int kMaxSensorDelay = 32;  // ticks

class Sensors {
 public:
  Sensors(const Model& model, const SensorOptions& options);

  // Fills what a robot measures; called once per tick, dt after the last call [s].  forget() first
  // after a jump.
  void measure(const World& world, double dt, RobotState& state) noexcept;
  void forget() noexcept;

 private:
  void measure_imu(const World& world, double dt, RobotState& state) noexcept;
  void measure_wrenches(const World& world, RobotState& state) noexcept;

  const Model* model_;
  SensorOptions options_;
  Random random_;
  double yaw_ = 0.0;  // drifted so far [rad]
  bool has_velocity_ = false;
  Eigen::Vector3d velocity_;         // of the IMU at the last call, world [m/s]
  std::vector<RobotState> history_;  // ring of delay_ticks + 1
  std::size_t newest_ = 0;
  bool history_filled_ = false;
};

}  // namespace twinbus
