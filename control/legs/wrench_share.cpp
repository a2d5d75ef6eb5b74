#include "control/legs/wrench_share.h"

#include <algorithm>
#include <cmath>

namespace twinbus::inline control {

Eigen::Vector2d SoleOnGround::turn(const Eigen::Vector2d& in_sole) const noexcept {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {c * in_sole.x() - s * in_sole.y(), s * in_sole.x() + c * in_sole.y()};
}

Eigen::Vector2d SoleOnGround::unturn(const Eigen::Vector2d& in_ground) const noexcept {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {c * in_ground.x() + s * in_ground.y(), -s * in_ground.x() + c * in_ground.y()};
}

namespace {
// Between low and high, and not farther from their middle than `most`.
double within(double value, double low, double high, double most) noexcept {
  const double middle = 0.5 * (low + high);
  const double half = std::min(std::max(0.0, 0.5 * (high - low)), most);
  return std::clamp(value, middle - half, middle + half);
}
}  // namespace

ZmpShare share_zmp(const std::array<SoleOnGround, 2>& soles, const Eigen::Vector2d& zmp,
                   double margin, double least_load) noexcept {
  const Eigen::Vector2d left = soles[0].centre();
  const Eigen::Vector2d right = soles[1].centre();
  const Eigen::Vector2d line = left - right;
  const double length2 = std::max(1e-6, line.squaredNorm());

  ZmpShare share;
  share.left = std::clamp((zmp - right).dot(line) / length2, least_load, 1.0 - least_load);
  const Eigen::Vector2d rest = zmp - (right + share.left * line);
  share.zmp.setZero();
  for (std::size_t s = 0; s < 2; ++s) {
    const SoleOnGround& sole = soles[s];
    Eigen::Vector2d local = sole.unturn((s == 0 ? left : right) + rest - sole.position);
    const double load = std::max(0.01, s == 0 ? share.left : 1.0 - share.left);
    const Eigen::Vector2d most = sole.most_moment / load;
    local.x() = within(local.x(), -sole.back + margin, sole.front - margin, most.x());
    local.y() = within(local.y(), -sole.right + margin, sole.left - margin, most.y());
    share.cop[s] = local;
    share.zmp += (s == 0 ? share.left : 1.0 - share.left) * (sole.position + sole.turn(local));
  }
  return share;
}

}  // namespace twinbus::control
