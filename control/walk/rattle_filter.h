// The load of soles as an admittance is given it: as measured, until it rattles; from then on behind a filter.
//
// The admittance moves a sole at a rate that is proportional to the load that is missed.  A ground that springs answers with a
// load that grows with the way.  One that damps more than it springs (soft rubber, MuJoCo's contact) answers with a load that
// is proportional to the rate, in the same tick: the loop then has a gain of over 1 without any delay, and the load jumps to
// and fro from tick to tick.  A filter of some ticks takes that gain below 1; where the ground springs it would cost a fifth of
// the ZMP's margin, so it waits until it is needed.

#pragma once

#include <Eigen/Core>

namespace twinbus::inline control {

class RattleFilter {
 public:
  RattleFilter() = default;
  // largest: of the load, by which jumps are measured [N m or N]; time: of the filter [s].
  RattleFilter(const Eigen::Vector2d& largest, double time) noexcept : largest_(largest), time_(time) {}

  void start() noexcept { *this = RattleFilter(largest_, time_); }
  // measured: moments about roll and pitch [N m], or a force and nothing [N]; loaded: it is carried; dt [s].
  Eigen::Vector2d update(const Eigen::Vector2d& measured, bool loaded, double dt) noexcept;

  // Mean of the jumps to and fro, as a share of the largest load: at most 0.25 over our scenes on ground that springs, 0.6 on
  // MuJoCo's without the filter.
  double rattle() const noexcept { return rattle_; }

 private:
  Eigen::Vector2d largest_ = Eigen::Vector2d::Ones();
  double time_ = 0.0;
  Eigen::Vector2d last_ = Eigen::Vector2d::Zero(), late_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d jump_ = Eigen::Vector2d::Zero();  // share of the largest load
  double rattle_ = 0.0;
  bool was_loaded_ = false, filters_ = false;
};

}  // namespace twinbus::control
