// What the simulated robot's sensors read: encoders, torques, IMU, force sensors at feet and hands.
//
// Ideal by default: noise, bias, counts, saturation, rate, delay and drift are off unless a setting
// asks for them (sim/scene/settings.h). Foot and hand wrenches are those of the contacts beyond the sensor.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "robot/description/model.h"
#include "lcmtypes/msg/robot_io.h"
#include "common/math/random.h"
#include "sim/world/felt_feet.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// How one kind of sensor differs from an ideal one, in its own unit; 0: not at all.
struct Imperfection {
  double noise = 0.0;    // standard deviation of white Gaussian noise, per sample
  double bias = 0.0;     // on every axis and joint
  double quantum = 0.0;  // one count
  double limit = 0.0;    // it reads no further than this, either way

  // What is read for `value`, in the order of a real sensor: bias, noise, saturation, counts.
  double read(double value, Random& random) const noexcept {
    value += bias;
    if (noise > 0.0) value += noise * random.normal();
    if (limit > 0.0) value = std::clamp(value, -limit, limit);
    if (quantum > 0.0) value = quantum * std::round(value / quantum);
    return value;
  }
};

struct SensorOptions {
  Imperfection encoder;   // [rad or m]
  Imperfection velocity;  // of the joints [rad/s]
  Imperfection torque;    // of the joints [N m]
  // Roll and pitch of the attitude [rad]; noise turns about any axis, bias is given below.
  Imperfection inclination;
  Imperfection gyro;       // [rad/s]
  Imperfection accel;      // [m/s^2]
  Imperfection force;      // of feet and hands [N]
  Imperfection moment;     // of feet and hands [N m]
  double roll_bias = 0.0;  // of the attitude [rad]
  double pitch_bias = 0.0;
  double yaw_drift = 0.0;  // of the attitude about the vertical [rad/s]
  // Samples a second; the last one is held in between. 0: one with every tick [Hz].
  double encoder_rate = 0.0, imu_rate = 0.0, force_rate = 0.0;
  bool foot_forces = true;  // the feet have force sensors
  int delay_ticks = 0;  // of everything, 0 .. kMaxSensorDelay
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
  const FeltFeet& feet() const noexcept { return feet_; }

 private:
  // Tells when the next sample of a slow sensor is due.
  struct SampleClock {
    double left = -1.0;  // until then [s]; below zero before the first one
    bool due(double dt, double rate) noexcept;
  };

  void measure_joints(const World& world) noexcept;
  void measure_imu(const World& world, double dt) noexcept;
  void measure_wrenches(const World& world) noexcept;

  const Model* model_;
  FeltFeet feet_;
  SensorOptions options_;
  Random random_;
  SampleClock encoders_, imu_, forces_;
  RobotState sample_;  // the newest of every sensor
  double yaw_ = 0.0;   // drifted so far [rad]
  bool has_velocity_ = false;
  Eigen::Vector3d velocity_;         // of the IMU at the last call, world [m/s]
  std::vector<RobotState> history_;  // ring of delay_ticks + 1
  std::size_t newest_ = 0;
  bool history_filled_ = false;
};

}  // namespace twinbus::sim
