#include "robot/stop_plan/sole_share.h"

#include <algorithm>

namespace twinbus::inline robot {

SoleShare share_on_soles(const std::array<SolePlace, 2>& soles, const std::array<Eigen::Vector2d, 2>& on,
                         const SoleArea& area, int carries, const Eigen::Vector2d& zmp) noexcept {
  SoleShare share;
  if (carries >= 0) {
    share.left = carries == 0 ? 1.0 : 0.0;
  } else {
    const Eigen::Vector2d line = on[0] - on[1];
    share.left = std::clamp((zmp - on[1]).dot(line) / std::max(1e-6, line.squaredNorm()), 0.0, 1.0);
  }
  const Eigen::Vector2d rest = zmp - (on[1] + share.left * (on[0] - on[1]));
  for (std::size_t f = 0; f < 2; ++f) {
    const SolePlace& sole = soles[f];
    share.cop[f] = sole.unturn(on[f] + rest - sole.position).cwiseMax(area.low).cwiseMin(area.high);
    share.zmp += (f == 0 ? share.left : 1.0 - share.left) * (sole.position + sole.turn(share.cop[f]));
  }
  return share;
}

}  // namespace twinbus::robot
