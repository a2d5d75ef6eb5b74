#include "sim/articulated/richardson.h"

#include <algorithm>

#include "sim/articulated/joint_law.h"

namespace twinbus::inline sim {

namespace {

constexpr double kLever = 0.1;  // at which a turn is looked at [m]
constexpr double kStopSlack = 1e-9;  // [rad or m]

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

double fastest_change(const Configuration& a, const Configuration& b) noexcept {
  const Eigen::Vector3d turn = a.base_angular_velocity - b.base_angular_velocity;
  double most = std::max((a.base_velocity - b.base_velocity).norm(), kLever * turn.norm());
  if (a.qd.size() > 0) most = std::max(most, kLever * (a.qd - b.qd).lpNorm<Eigen::Infinity>());
  return most;
}

}  // namespace

void extrapolate_at_rest(const std::array<Configuration, 2>& coarse, Configuration& y) noexcept {
  lead(coarse[1], 2.0, y);
}

double extrapolate(int order, std::array<Configuration, 2>& coarse, Configuration& y) noexcept {
  if (order == 2) {
    const double correction = fastest_change(y, coarse[0]);
    lead(coarse[0], 1.0, y);
    return correction;
  }
  lead(coarse[1], 2.0, y);
  lead(coarse[0], 1.0, coarse[1]);
  lead(coarse[1], 0.5, y);
  return fastest_change(y, coarse[1]) / 3.0;
}

bool passes_stops(const std::vector<JointLaw>& joints, const Configuration& fine, const Configuration& y) noexcept {
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const auto index = static_cast<Eigen::Index>(j);
    const double allowed = std::max(kStopSlack, joints[j].beyond_stops(fine.q[index]));
    if (!(joints[j].beyond_stops(y.q[index]) <= allowed)) return true;
  }
  return false;
}

}  // namespace twinbus::sim
