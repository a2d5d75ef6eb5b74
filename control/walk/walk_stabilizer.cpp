#include "control/walk/walk_stabilizer.h"

#include <algorithm>

#include "common/math/index.h"
#include "robot/stop_plan/sole_share.h"

namespace twinbus::inline control {

namespace {
constexpr double kRebase =
    0.3;  // time in which a step of the error at a change of source is let in [s]
}

ZmpShare share_walking(const WalkPattern& pattern, const Eigen::Vector2d& zmp) noexcept {
  const Gait& gait = pattern.gait();
  std::array<SolePlace, 2> soles;
  std::array<Eigen::Vector2d, 2> on;
  for (int f = 0; f < 2; ++f) {
    const Foothold& foot = pattern.foot(f);
    const Eigen::Vector2d forward = foot.turn({1.0, 0.0});
    soles[at(f)] = {foot.position, forward.x(), forward.y()};
    on[at(f)] = zmp_on(gait, foot, f);
  }
  const SoleShare share = share_on_soles(soles, on, {gait.sole_low, gait.sole_high},
                                         pattern.single() ? pattern.support() : -1, zmp);
  return {share.left, share.cop, share.zmp};
}

void WalkStabilizer::start(const Eigen::Vector2d& com, const Eigen::Vector2d& dcm) noexcept {
  com_ = com;
  dcm_ = zmp_ = wanted_ = dcm;
  velocity_.setZero();
  error_.setZero();
  excess_.setZero();
  integral_.setZero();
  bias_.setZero();
  rebase_ = false;
  share_ = {};
}

void WalkStabilizer::update(const WalkPattern& pattern, const Eigen::Vector2d& com,
                            const Eigen::Vector2d& dcm, double omega, double dt) noexcept {
  const WalkStabilizerGains& g = gains_;
  zmp_ = pattern.zmp() + (1.0 + g.to_plan / omega) * (dcm_ - pattern.dcm());
  zmp_ = share_walking(pattern, zmp_).zmp;
  dcm_ += dt * omega * (dcm_ - zmp_);
  velocity_ = omega * (dcm_ - com_);
  com_ += dt * velocity_;

  const Eigen::Vector2d raw = dcm - dcm_;
  if (rebase_) {
    bias_ += error_ - (raw + bias_);
    rebase_ = false;
  }
  bias_ *= std::max(0.0, 1.0 - dt / kRebase);
  error_ = raw + bias_;
  integral_ += dt * (error_ - integral_ / g.leak);
  const double gain = 1.0 + g.dcm / omega;
  wanted_ = zmp_ + gain * error_ + g.integral * integral_;
  share_ = share_walking(pattern, wanted_);
  excess_ = wanted_ - share_.zmp;
  const double lost = excess_.norm();
  dcm_ += dt * g.give_up / gain * excess_;
  com_ += dt * g.give_up * std::min(1.0, lost / g.far) * (com - com_);

  const Eigen::Vector2d foot =
      pattern.single() ? pattern.foot(pattern.support()).position : pattern.middle();
  const Eigen::Vector2d away = com_ - foot;
  if (away.norm() > g.reach) com_ = foot + away * (g.reach / away.norm());
}

}  // namespace twinbus::control
