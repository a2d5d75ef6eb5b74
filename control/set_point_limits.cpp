#include "control/set_point_limits.h"

#include <algorithm>
#include <cmath>

namespace twinbus {

void limit_set_points(const Model& model, const RobotState& state, const SetPoint* last, double dt,
                      SetPoint& p) noexcept {
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Joint& j = model.joints[static_cast<std::size_t>(model.bus_joints[i])];
    const bool turns = j.kind == JointKind::kContinuous;
    const bool good = std::isfinite(p.q[i]) && std::isfinite(p.qd[i]) && std::isfinite(p.tau[i]) &&
                      std::isfinite(p.kp[i]) && std::isfinite(p.kd[i]);
    if (!good) {
      p.q[i] = last != nullptr ? last->q[i] : std::clamp(state.q[i], -1e3, 1e3);
      p.qd[i] = p.tau[i] = 0.0;
      p.kp[i] = j.kp;
      p.kd[i] = j.kd;
    }
    if (!turns) p.q[i] = std::clamp(p.q[i], j.lower, j.upper);
    if (last != nullptr) {
      const double rate = j.rate > 0.0 ? std::min(j.rate, j.velocity) : j.velocity;
      if (rate > 0.0) p.q[i] = std::clamp(p.q[i], last->q[i] - rate * dt, last->q[i] + rate * dt);
      if (!turns) p.q[i] = std::clamp(p.q[i], j.lower, j.upper);
    }
    if (j.velocity > 0.0) p.qd[i] = std::clamp(p.qd[i], -j.velocity, j.velocity);
    if (j.effort > 0.0) p.tau[i] = std::clamp(p.tau[i], -j.effort, j.effort);
    p.kp[i] = std::max(0.0, p.kp[i]);
    p.kd[i] = std::max(0.0, p.kd[i]);
  }
}

}  // namespace twinbus
