#include "control/balance/angular_momentum_lean.h"

namespace twinbus::inline control {

void TrunkYield::start(const Eigen::Vector2d& base, const Eigen::Vector2d& waist,
                       const Eigen::Vector2d& most_waist) noexcept {
  base_ = base.cwiseMax(1e-3);
  waist_ = waist.cwiseMax(0.0);
  most_waist_ = most_waist.cwiseMax(0.0);
  target_.setZero();
  acceleration_.setZero();
  waist_angle_.setZero();
  waist_rate_.setZero();
  waist_acceleration_.setZero();
}

Eigen::Vector2d TrunkYield::lean(const Eigen::Vector2d& angle, double height) const noexcept {
  const Eigen::Vector2d a =
      (base_.cwiseProduct(angle) + waist_.cwiseProduct(waist_angle_)) / height;
  return {a.y(), -a.x()};
}

void TrunkYield::update(const Eigen::Vector2d& wanted, const Eigen::Vector2d& angle,
                        const Eigen::Vector2d& rate, double height, double dt) noexcept {
  const TrunkYieldGains& g = gains_;
  const Eigen::Vector2d turned = height * Eigen::Vector2d(-wanted.y(), wanted.x());
  const Eigen::Vector2d both = turned.cwiseQuotient(base_ + g.waist * waist_);
  const Eigen::Vector2d within = both.cwiseMax(-g.limit).cwiseMin(g.limit);
  target_ += dt / (dt + g.filter) * (within - target_);
  acceleration_ =
      g.frequency * g.frequency * (target_ - angle) - 2.0 * g.damping * g.frequency * rate;
  acceleration_ = acceleration_.cwiseMax(-g.most).cwiseMin(g.most);

  const Eigen::Vector2d bend = (g.waist * target_).cwiseMax(-most_waist_).cwiseMin(most_waist_);
  waist_acceleration_ =
      g.waist_rate * g.waist_rate * (bend - waist_angle_) - 2.0 * g.waist_rate * waist_rate_;
  waist_rate_ += dt * waist_acceleration_;
  waist_angle_ += dt * waist_rate_;
}

}  // namespace twinbus::control
