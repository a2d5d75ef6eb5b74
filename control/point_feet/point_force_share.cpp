#include "control/point_feet/point_force_share.h"

#include <Eigen/Cholesky>

#include "common/math/pose_math.h"

namespace twinbus::inline control {

namespace {
// How much a share of the weight that is missing costs, level and upright, and a moment likewise about x and y, and about z.
constexpr double kLevelWeight = 1.0, kUpWeight = 4.0, kTiltWeight = 6.0, kTurnWeight = 1.0;
constexpr double kEffort = 2e-3;  // of the forces themselves
constexpr double kPenalty = 0.3;  // of ADMM
}  // namespace

Eigen::Vector3d within_cone(const Eigen::Vector3d& force, double friction, double most) noexcept {
  if (!(most > 0.0)) return Eigen::Vector3d::Zero();
  const double across = force.head<2>().norm();
  Eigen::Vector3d inside = force;
  if (across > friction * force.z()) {
    if (friction * across <= -force.z()) return Eigen::Vector3d::Zero();
    const double up = (force.z() + friction * across) / (1.0 + friction * friction);
    inside.z() = up;
    inside.head<2>() *= friction * up / across;
  }
  if (inside.z() > most) {
    inside.z() = most;
    inside.head<2>() = force.head<2>();
    if (across > friction * most) inside.head<2>() *= friction * most / across;
  }
  return inside;
}

PointForceShare::PointForceShare(double weight, double length, double friction) noexcept
    : weight_(weight), length_(length), friction_(friction) {
  reset();
}

void PointForceShare::reset() noexcept {
  shared_.setZero();
  price_.setZero();
  force_.fill(Eigen::Vector3d::Zero());
}

const PointForces& PointForceShare::solve(const std::array<PointFoot, kPointFeet>& feet, const TrunkWrench& wanted,
                                          int rounds) noexcept {
  Eigen::Matrix<double, 6, 3 * kPointFeet> map;
  for (std::size_t i = 0; i < kPointFeet; ++i) {
    const auto column = static_cast<Eigen::Index>(3 * i);
    map.block<3, 3>(0, column).setIdentity();
    map.block<3, 3>(3, column) = skew(feet[i].arm / length_);
  }
  Eigen::Matrix<double, 6, 1> cost, asked;
  cost << kLevelWeight, kLevelWeight, kUpWeight, kTiltWeight, kTiltWeight, kTurnWeight;
  asked << wanted.force / weight_, wanted.moment / (weight_ * length_);
  Eigen::Matrix<double, 12, 12> system = map.transpose() * cost.asDiagonal() * map;
  system.diagonal().array() += kEffort + kPenalty;
  const Eigen::LLT<Eigen::Matrix<double, 12, 12>> solver(system);
  const Vector12 pull = map.transpose() * cost.cwiseProduct(asked);
  for (int round = 0; round < rounds; ++round) {
    const Vector12 free = solver.solve(pull + kPenalty * (shared_ - price_));
    for (std::size_t i = 0; i < kPointFeet; ++i) {
      const auto row = static_cast<Eigen::Index>(3 * i);
      const Eigen::Vector3d wish = free.segment<3>(row) + price_.segment<3>(row);
      const Eigen::Vector3d inside = within_cone(wish, friction_, feet[i].most / weight_);
      shared_.segment<3>(row) = inside;
      price_.segment<3>(row) = wish - inside;
    }
  }
  if (!shared_.allFinite() || !price_.allFinite()) reset();
  for (std::size_t i = 0; i < kPointFeet; ++i) force_[i] = weight_ * shared_.segment<3>(static_cast<Eigen::Index>(3 * i));
  return force_;
}

}  // namespace twinbus::control
