#include "control/loop/set_point_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "common/simd/vec4.h"
#include "robot/kinematics/brake.h"

namespace twinbus::inline control {

namespace {
constexpr double kNone = std::numeric_limits<double>::infinity();

double or_none(double limit) noexcept { return limit > 0.0 ? limit : kNone; }
}  // namespace

SetPointLimits::SetPointLimits(const Model& model)
    : pairs_(model), count_(static_cast<std::size_t>(model.bus_count())) {
  for (std::size_t i = 0; i < count_; ++i) {
    const Joint& j = model.joints[at(model.bus_joints[i])];
    const bool turns = j.kind == JointKind::kContinuous;
    lower_[i] = turns ? -kNone : j.lower;
    upper_[i] = turns ? kNone : j.upper;
    rate_[i] = or_none(j.rate > 0.0 ? std::min(j.rate, j.velocity) : j.velocity);
    velocity_[i] = or_none(j.velocity);
    effort_[i] = or_none(j.effort);
    kp_[i] = j.kp;
    kd_[i] = j.kd;
  }
}

TWINBUS_AVX2_CLONES
void SetPointLimits::apply(const RobotState& state, const SetPoint* last, double dt,
                           SetPoint& p) const noexcept {
  // Finite numbers times zero are zero; a sum that overflows only has every joint looked at.
  bool good = true;
  for (std::size_t i = 0; i < count_; ++i) {
    good &= 0.0 * p.q[i] + 0.0 * p.qd[i] + 0.0 * p.tau[i] + 0.0 * p.kp[i] + 0.0 * p.kd[i] == 0.0;
  }
  for (std::size_t i = 0; i < count_ && !good; ++i) {
    if (std::isfinite(p.q[i]) && std::isfinite(p.qd[i]) && std::isfinite(p.tau[i]) &&
        std::isfinite(p.kp[i]) && std::isfinite(p.kd[i]))
      continue;
    p.q[i] = last != nullptr ? last->q[i] : std::clamp(state.q[i], -1e3, 1e3);
    p.qd[i] = p.tau[i] = 0.0;
    p.kp[i] = kp_[i];
    p.kd[i] = kd_[i];
  }
  for (std::size_t i = 0; i < count_; ++i) {
    p.q[i] = std::min(std::max(p.q[i], lower_[i]), upper_[i]);
  }
  if (last != nullptr) {
    for (std::size_t i = 0; i < count_; ++i) {
      const double way = rate_[i] * dt;
      const double near = std::min(std::max(p.q[i], last->q[i] - way), last->q[i] + way);
      p.q[i] = std::min(std::max(near, lower_[i]), upper_[i]);
      const double step = kTorqueStep * effort_[i];
      const double tau = static_cast<double>(static_cast<float>(last->tau[i]));  // as it was sent
      p.tau[i] = std::min(std::max(p.tau[i], tau - step), tau + step);
    }
  }
  for (std::size_t i = 0; i < count_; ++i) {
    p.qd[i] = std::min(std::max(p.qd[i], -velocity_[i]), velocity_[i]);
    p.tau[i] = std::min(std::max(p.tau[i], -effort_[i]), effort_[i]);
    p.kp[i] = std::max(0.0, p.kp[i]);
    p.kd[i] = std::max(0.0, p.kd[i]);
  }
  pairs_.limit(state.q, p.tau);
}

}  // namespace twinbus::control
