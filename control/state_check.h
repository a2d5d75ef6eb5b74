// Is a state, finite already, one that a robot could be in?  What no robot can be in must not reach
// filters and integrators.

#pragma once

#include <cmath>

#include "robot/model.h"
#include "robot/robot_io.h"

namespace twinbus {

inline bool is_sane(const RobotState& state, const Model& model) noexcept {
  if (state.joint_count != model.bus_count()) return false;
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[i])];
    const bool turns = joint.kind == JointKind::kContinuous;
    if (!(std::abs(state.q[i]) < 1e4)) return false;
    if (!turns && !(state.q[i] > joint.lower - 1.0 && state.q[i] < joint.upper + 1.0)) return false;
    if (!(std::abs(state.qd[i]) < 200.0F)) return false;
    if (!(std::abs(state.tau[i]) < 1e6F)) return false;
  }
  float norm = 0.0F;
  for (float a : state.attitude) norm += a * a;
  if (!(norm > 0.5F && norm < 1.5F)) return false;
  for (float g : state.gyro) {
    if (!(std::abs(g) < 100.0F)) return false;
  }
  for (float a : state.accel) {
    if (!(std::abs(a) < 2000.0F)) return false;
  }
  for (const auto& wrench : state.wrench) {
    for (float w : wrench) {
      if (!(std::abs(w) < 1e5F)) return false;
    }
  }
  return true;
}

}  // namespace twinbus
