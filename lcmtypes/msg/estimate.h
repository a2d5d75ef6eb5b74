// Where the base is, how it moves and which feet carry it: the struct behind estimate_t, without the bus.  Points, axes and
// units of every field: lcmtypes/estimate_t.lcm.

#pragma once

#include <array>
#include <cstdint>

namespace twinbus {

inline constexpr int kMaxFeet = 6;

enum class LoadFrom : std::int8_t { kUnknown = 0, kForces = 1, kTorques = 2, kHeights = 3 };
enum class VelocityFrom : std::int8_t { kUnknown = 0, kFeetAndAccelerometer = 1, kAccelerometer = 2, kFeet = 3, kFixed = 4 };

template <class T>
using PerFoot = std::array<T, kMaxFeet>;

struct Estimate {
  std::int64_t tick = 0;  // of the STATE that it belongs to
  std::int64_t run_id = 0;
  std::array<double, 3> base_position{};  // origin of the base link, world [m]
  std::array<double, 4> base_attitude{1, 0, 0, 0};
  std::array<float, 3> base_velocity{};  // of that origin, axes of the world [m/s]
  std::array<float, 3> base_angular_velocity{};
  std::array<float, 3> velocity_in_base{};
  std::array<float, 3> angular_velocity_in_base{};
  std::array<float, 3> imu_velocity{};
  std::array<float, 3> position_deviation{};
  std::array<float, 3> attitude_deviation{};
  std::array<float, 3> velocity_deviation{};
  std::array<float, 3> angular_velocity_deviation{};
  PerFoot<float> foot_load{};
  PerFoot<float> foot_certainty{};
  PerFoot<std::array<float, 3>> foot_position{};
  PerFoot<std::int16_t> foot_joint{-1, -1, -1, -1, -1, -1};
  std::int16_t foot_count = 0;
  PerFoot<bool> foot_stands{};
  LoadFrom load_from = LoadFrom::kUnknown;
  VelocityFrom velocity_from = VelocityFrom::kUnknown;
};

}  // namespace twinbus
