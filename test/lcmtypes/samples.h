// One valid value of every struct that goes over the bus, no two numbers of it alike where its rules let them differ.
//
// Made from the .lcm files (lcmtypes/generate.py); here is what fills the fields, and what ties fields to one another.

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>

#include "lcmtypes/msg/messages.h"

namespace twinbus {

template <class T>
T sample();

// Counts up from one field to the next.
class Filler {
 public:
  explicit Filler(int first) : count_(first) {}

  // A number, a flag, an enumeration or an array of them.
  template <class T>
  void operator()(T& x) {
    ++count_;
    if constexpr (std::is_enum_v<T>) {
      x = static_cast<T>(1);
    } else if constexpr (std::is_same_v<T, bool>) {
      x = true;
    } else if constexpr (std::is_arithmetic_v<T>) {
      x = static_cast<T>(std::is_integral_v<T> ? count_ % 100 + 1 : 0.01 * count_);
    } else {
      for (auto& y : x) (*this)(y);
    }
  }
  template <class T>
  void between(T& x, double low, double high) {
    if constexpr (std::is_arithmetic_v<T>) {
      const double share = 0.25 + 0.5 * (++count_ % 10) / 10.0;
      x = static_cast<T>(low + share * (high - low));
    } else {
      for (auto& y : x) between(y, low, high);
    }
  }
  template <class T>
  void rotation(T& quaternion) {
    quaternion = {0.5, 0.5, -0.5, 0.5};
  }
  template <class T>
  void text(T& x) {
    constexpr char kWords[] = "switch refused: posture";
    std::copy_n(kWords, std::min(x.size(), std::size(kWords)) - 1, x.begin());
  }

 private:
  int count_;
};

template <class T>
void cross_sample(T&) {}
inline void cross_sample(RobotState& x) {
  x.sensor_flags = 0x3ff;
  x.attitude = {0.5F, 0.5F, -0.5F, 0.5F};
}
inline void cross_sample(ArmGoal& x) {
  x.kind = ArmGoalKind::kPose;
  x.orientation = {0.5, 0.5, 0.5, -0.5};
}
inline void cross_sample(ArmPathPiece& x) {
  for (std::size_t i = 0; i < x.joint.size(); ++i) x.joint[i] = static_cast<std::int16_t>(i + 6);
}
inline void cross_sample(ObstaclesPiece& x) {
  for (auto& attitude : x.attitude) attitude = {0.5F, 0.5F, -0.5F, 0.5F};
}

}  // namespace twinbus

#include "lcmtypes/bus/message_samples.h"
