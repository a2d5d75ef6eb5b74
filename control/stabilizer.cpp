#include "control/stabilizer.h"

#include <algorithm>

namespace twinbus {

namespace {
constexpr double kFullGiveUp =
    0.05;  // [m] of excess at which the com reference is given up at the full rate
constexpr double kReach = 0.3;  // [m] of the reference from the middle of the soles
}  // namespace

void Stabilizer::start(const Eigen::Vector2d& com, const Eigen::Vector2d& velocity,
                       double omega) noexcept {
  com_ = com;
  com_velocity_ = velocity;
  dcm_ = com + velocity / omega;
  zmp_ = com;
  integral_.setZero();
  bias_.setZero();
  error_.setZero();
  excess_.setZero();
  rebase_ = false;
}

void Stabilizer::update(const ComPlan& plan, const Eigen::Vector2d& com, const Eigen::Vector2d& dcm,
                        const std::array<SoleOnGround, 2>& soles, double omega, double dt,
                        bool feedback) noexcept {
  const StabilizerGains& g = gains_;
  const Eigen::Vector2d zmp_plan = plan.position - plan.acceleration / (omega * omega);
  const Eigen::Vector2d dcm_plan = plan.position + plan.velocity / omega;
  const Eigen::Vector2d zmp_pull = zmp_plan + (1.0 + g.reference / omega) * (dcm_ - dcm_plan);
  zmp_ = share_zmp(soles, zmp_pull, g.margin, g.least_load).zmp;
  dcm_ += dt * omega * (dcm_ - zmp_);
  com_velocity_ = omega * (dcm_ - com_);
  com_ += dt * com_velocity_;

  const Eigen::Vector2d raw = dcm - dcm_;
  if (rebase_) {
    bias_ += error_ - (raw + bias_);
    rebase_ = false;
  }
  bias_ *= std::max(0.0, 1.0 - dt / g.rebase);
  error_ = raw + bias_;
  if (!feedback) error_.setZero();

  integral_ += dt * (error_ - integral_ / g.leak);
  const double gain = 1.0 + g.dcm / omega;
  zmp_wanted_ = zmp_ + gain * error_ + g.integral * integral_;
  share_ = share_zmp(soles, zmp_wanted_, g.margin, g.least_load);
  excess_ = zmp_wanted_ - share_.zmp;
  if (!feedback) return;
  dcm_ += dt * g.give_up / gain * excess_;
  com_ += std::min(1.0, excess_.norm() / kFullGiveUp) * dt * g.give_up * (com - com_);
  // A fall must not carry the reference, an unstable pendulum, out of reach.
  const Eigen::Vector2d middle = 0.5 * (soles[0].centre() + soles[1].centre());
  for (Eigen::Vector2d* point : {&com_, &dcm_}) {
    const Eigen::Vector2d away = *point - middle;
    if (!(away.norm() <= kReach))
      *point = middle + away.cwiseMax(-kReach).cwiseMin(kReach).normalized() * kReach;
  }
}

}  // namespace twinbus
