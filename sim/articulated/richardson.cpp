#include "sim/articulated/richardson.h"

namespace twinbus {

namespace {

// y += by (y - other), the attitude too.
void lead(const Configuration& other, double by, Configuration& y) noexcept {
  y.q += by * (y.q - other.q);
  y.qd += by * (y.qd - other.qd);
  y.base.translation() += by * (y.base.translation() - other.base.translation());
  y.base_velocity += by * (y.base_velocity - other.base_velocity);
  y.base_angular_velocity += by * (y.base_angular_velocity - other.base_angular_velocity);
  Eigen::AngleAxisd beyond(Eigen::Matrix3d(y.base.linear() * other.base.linear().transpose()));
  beyond.angle() *= by;
  const Eigen::Quaterniond attitude(beyond * Eigen::Quaterniond(y.base.linear()));
  y.base.linear() = attitude.normalized().toRotationMatrix();
}

}  // namespace

void extrapolate_at_rest(const std::array<Configuration, 2>& coarse, Configuration& y) noexcept {
  lead(coarse[1], 2.0, y);
}

void extrapolate(int order, std::array<Configuration, 2>& coarse, Configuration& y) noexcept {
  if (order == 2) {
    lead(coarse[0], 1.0, y);
    return;
  }
  lead(coarse[1], 2.0, y);
  lead(coarse[0], 1.0, coarse[1]);
  lead(coarse[1], 0.5, y);
}

}  // namespace twinbus
