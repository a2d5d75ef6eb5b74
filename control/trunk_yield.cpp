#include "control/trunk_yield.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics.h"

namespace twinbus {

void TrunkYield::start() noexcept {
  angle_.setZero();
  rate_.setZero();
  acceleration_.setZero();
}

void TrunkYield::update(const Eigen::Vector2d& excess, double dt) noexcept {
  const TrunkYieldGains& g = gains_;
  const Eigen::Vector2d push =
      g.share * kGravity / (g.gyration * g.gyration) * Eigen::Vector2d(-excess.y(), excess.x());
  for (int k = 0; k < 2; ++k) {
    double a = std::clamp(push[k], -g.most, g.most);
    a -= 2.0 * g.damping * g.frequency * rate_[k] + g.frequency * g.frequency * angle_[k];
    // Near the limit: not faster than what brakes in time.
    const double room = g.limit - std::copysign(angle_[k], 1.0);
    const double outward = rate_[k] * (angle_[k] >= 0.0 ? 1.0 : -1.0);
    if (outward > 0.0 && outward * outward > 2.0 * g.most * std::max(0.0, room)) {
      a = -std::copysign(g.most, rate_[k]);
    }
    a = std::clamp(a, -2.0 * g.most, 2.0 * g.most);
    acceleration_[k] = a;
    rate_[k] += dt * a;
    angle_[k] += dt * rate_[k];
  }
}

}  // namespace twinbus
