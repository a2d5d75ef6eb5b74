#include "control/balance/stabilizer.h"

#include <algorithm>

namespace twinbus::inline control {

void Stabilizer::start() noexcept {
  integral_.setZero();
  bias_.setZero();
  error_.setZero();
  wanted_.setZero();
  lean_.setZero();
  share_ = ZmpShare();
  rebase_ = false;
  fresh_ = true;
}

void Stabilizer::update(const ComPlan& plan, const Eigen::Vector2d& capture,
                        const Eigen::Vector2d& lean, const std::array<SoleOnGround, 2>& soles,
                        double omega, double dt) noexcept {
  const StabilizerGains& g = gains_;
  const Eigen::Vector2d zmp_plan = plan.position - plan.acceleration / (omega * omega);
  const Eigen::Vector2d dcm_plan = plan.position + plan.velocity / omega;
  const Eigen::Vector2d raw = capture - dcm_plan;
  if (rebase_) {
    bias_ += error_ - (raw + bias_);
    rebase_ = false;
  }
  bias_ *= std::max(0.0, 1.0 - dt / g.rebase);
  error_ = raw + bias_;

  wanted_ = zmp_plan + (1.0 + g.dcm / omega) * error_ + g.integral * integral_;
  lean_ = wanted_ - share_zmp(soles, wanted_, g.margin, g.least_load).zmp;
  if (lean_.norm() < 1e-4) {  // what is out of reach is no lasting error
    integral_ += dt * (error_ - integral_ / g.leak);
  } else {
    integral_ *= std::max(0.0, 1.0 - dt / g.leak);
  }
  ZmpShare share = share_zmp(soles, wanted_ - lean, g.margin, g.least_load);
  const double quick = fresh_ ? 1.0 : dt / (dt + g.cop_filter);
  fresh_ = false;
  share.zmp.setZero();
  for (std::size_t s = 0; s < 2; ++s) {
    share.cop[s] = share_.cop[s] + quick * (share.cop[s] - share_.cop[s]);
    share.zmp += (s == 0 ? share.left : 1.0 - share.left) *
                 (soles[s].position + soles[s].turn(share.cop[s]));
  }
  share_ = share;
}

}  // namespace twinbus::control
