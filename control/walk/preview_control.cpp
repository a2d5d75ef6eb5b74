#include "control/walk/preview_control.h"

#include <cmath>
#include <stdexcept>

#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline control {

namespace {
constexpr int kMostRounds = 20000;  // of the Riccati equation
constexpr double kConverged = 1e-13;
}  // namespace

PreviewControl::PreviewControl(double height, double every, int count, double jerk)
    : omega_(std::sqrt(kGravity / height)), every_(every) {
  if (!(height > 0.0 && every > 0.0 && count > 0 && jerk > 0.0 && std::isfinite(omega_)))
    throw std::invalid_argument("PreviewControl: height, times and weight must be positive");
  const double t = every;
  Eigen::Matrix3d a;
  a << 1.0, t, 0.5 * t * t, 0.0, 1.0, t, 0.0, 0.0, 1.0;
  const Eigen::Vector3d b(t * t * t / 6.0, 0.5 * t * t, t);
  const Eigen::Vector3d c(1.0, 0.0, -1.0 / (omega_ * omega_));

  // P = A'PA - A'Pb (r + b'Pb)^-1 b'PA + cc'
  Eigen::Matrix3d p = c * c.transpose();
  double weight = 0.0;
  for (int i = 0; i < kMostRounds; ++i) {
    weight = 1.0 / (jerk + b.dot(p * b));
    gain_ = weight * b.transpose() * p * a;
    const Eigen::Matrix3d next = a.transpose() * p * (a - b * gain_) + c * c.transpose();
    const double change = (next - p).norm();
    p = 0.5 * (next + next.transpose());
    if (change < kConverged * p.norm()) break;
  }
  const Eigen::Matrix3d closed = (a - b * gain_).transpose();
  Eigen::Vector3d later = c;
  share_.resize(static_cast<std::size_t>(count));
  for (double& share : share_) {
    share = weight * b.dot(later);
    later = (closed * later).eval();
  }
  // What comes after the last is taken to be as the last: all shares together are then the gain of the position.
  double sum = 0.0;
  for (const double share : share_) sum += share;
  share_.back() += gain_[0] - sum;
}

double PreviewControl::jerk(const Cart& cart, const double* wanted) const noexcept {
  double u = -gain_.dot(Eigen::RowVector3d(cart.position, cart.velocity, cart.acceleration));
  for (std::size_t i = 0; i < share_.size(); ++i) u += share_[i] * wanted[i];
  return u;
}

Cart PreviewControl::advance(const Cart& cart, double jerk, double dt) noexcept {
  const double acceleration = cart.acceleration + dt * jerk;
  const double velocity = cart.velocity + dt * (cart.acceleration + 0.5 * dt * jerk);
  const double position =
      cart.position + dt * (cart.velocity + dt * (0.5 * cart.acceleration + dt * jerk / 6.0));
  return {position, velocity, acceleration};
}

}  // namespace twinbus::control
