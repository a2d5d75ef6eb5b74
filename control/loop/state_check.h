// Is a state, finite already, one that a robot could be in?  What no robot can be in must not reach
// filters and integrators.

#pragma once

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline control {

class StateCheck {
 public:
  explicit StateCheck(const Model& model) noexcept
      : count_(static_cast<std::size_t>(model.bus_count())) {
    for (std::size_t i = 0; i < count_; ++i) {
      const Joint& joint = model.joints[at(model.bus_joints[i])];
      const bool turns = joint.kind == JointKind::kContinuous;
      low_[i] = turns ? -kMostPosition : std::max(-kMostPosition, joint.lower - kBeyond);
      high_[i] = turns ? kMostPosition : std::min(kMostPosition, joint.upper + kBeyond);
    }
  }

  [[nodiscard]] bool is_sane(const RobotState& state) const noexcept {
    if (state.joint_count != static_cast<int>(count_)) return false;
    bool good = true;
    for (std::size_t i = 0; i < count_; ++i) {
      good &= state.q[i] > low_[i] && state.q[i] < high_[i];
      good &= std::abs(state.qd[i]) < 200.0F && std::abs(state.tau[i]) < 1e6F;
    }
    float norm = 0.0F;
    for (const float a : state.attitude) norm += a * a;
    good &= norm > 0.5F && norm < 1.5F;
    for (const float g : state.gyro) good &= std::abs(g) < 100.0F;
    for (const float a : state.accel) good &= std::abs(a) < 2000.0F;
    for (const auto& wrench : state.wrench) {
      for (const float w : wrench) good &= std::abs(w) < 1e5F;
    }
    return good;
  }

 private:
  static constexpr double kMostPosition = 1e4;  // [rad or m]
  static constexpr double kBeyond = 1.0;        // of a joint's limits [rad or m]

  std::size_t count_;
  PerJoint<double> low_{}, high_{};  // bus order
};

}  // namespace twinbus::control
