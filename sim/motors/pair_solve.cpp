#include "sim/motors/pair_solve.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "robot/parallel/drive_torque.h"

namespace twinbus::inline sim {

namespace {

constexpr double kRounding = 1e-9;  // of a limit
// Which motors are at a limit, and at which.
constexpr std::array<std::array<int, 2>, 9> kPieces = {
    {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};

}  // namespace

void PairSolve::begin(const Eigen::Matrix2d& jacobian, const Eigen::Vector2d& limit, const Eigen::Vector2d& force,
                      const Eigen::Vector2d& gain) noexcept {
  jacobian_ = jacobian;
  to_motors_ = jacobian.transpose().inverse();
  limit_ = limit;
  force_ = force;
  gain_ = gain;
  mobility_.setZero();
  limited_ = false;
}

bool PairSolve::settled(const Eigen::Vector2d& applied, const Eigen::Vector2d& qd) const noexcept {
  const LimitedTorque given = limit_at_motors(jacobian_, limit_, force_ - gain_.cwiseProduct(qd));
  if (!limited_) return !given.limited;
  return (applied - given.tau).cwiseAbs().maxCoeff() <= kSettled * limit_.maxCoeff();
}

Eigen::Vector2d PairSolve::next(const Eigen::Vector2d& applied, const Eigen::Vector2d& qd) noexcept {
  if (limited_) {
    const Eigen::Vector2d more = applied - applied_;
    if (more.squaredNorm() > 0.0) mobility_ += (qd - qd_ - mobility_ * more) * more.transpose() / more.squaredNorm();
  }
  limited_ = true;
  applied_ = applied;
  qd_ = qd;
  // The motors want w - W m when they give m.
  const Eigen::Vector2d still = qd - mobility_ * applied;
  const Eigen::Vector2d w = to_motors_ * (force_ - gain_.cwiseProduct(still));
  const Eigen::Matrix2d by_motors = to_motors_ * gain_.asDiagonal() * mobility_ * jacobian_.transpose();
  for (const std::array<int, 2>& piece : kPieces) {
    Eigen::Matrix2d matrix = by_motors + Eigen::Matrix2d::Identity();
    Eigen::Vector2d right = w;
    for (int i = 0; i < 2; ++i) {
      const int side = piece[static_cast<std::size_t>(i)];
      if (side == 0) continue;
      matrix.row(i) = Eigen::RowVector2d::Unit(i);
      right[i] = side * limit_[i];
    }
    if (!(std::abs(matrix.determinant()) > kRounding)) continue;
    const Eigen::Vector2d m = matrix.inverse() * right, wanted = w - by_motors * m;
    bool good = m.allFinite();
    for (int i = 0; i < 2 && good; ++i) {
      const int side = piece[static_cast<std::size_t>(i)];
      const double slack = kRounding * limit_[i];
      good = side == 0 ? std::abs(m[i]) <= limit_[i] + slack : side * wanted[i] >= limit_[i] - slack;
    }
    if (good) return jacobian_.transpose() * m;
  }
  return limit_at_motors(jacobian_, limit_, force_ - gain_.cwiseProduct(qd)).tau;
}

}  // namespace twinbus::sim
