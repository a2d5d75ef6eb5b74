// The foot in the air: horizontally the smoothest way to a target that may move at any tick, vertically an arc that ends
// on the ground at rest; if no ground is there in time, it feels for it downwards.

#pragma once

#include <Eigen/Core>

#include "control/walk/footsteps.h"

namespace twinbus::inline control {

struct SwingGains {
  double early = 0.04;    // the target is reached so long before touchdown [s]
  double below = 0.001;   // the ground is aimed at so far below where it is [m]
  double search = 0.5;    // downwards, of a foot that found no ground in time [m/s]
  double rush = 20.0;     // with which it gets so fast [m/s^2]
  double deepest = 0.05;  // so far below [m]
};

class SwingFoot {
 public:
  explicit SwingFoot(const SwingGains& gains = {}) noexcept : gains_(gains) {}

  void start(const Foothold& from) noexcept;
  // left: until touchdown [s]; lift: of the arc [m].
  void advance(const Foothold& target, double left, double lift, double dt) noexcept;

  const Foothold& place() const noexcept { return place_; }
  const Eigen::Vector2d& velocity() const noexcept { return velocity_; }
  double height() const noexcept { return place_.height; }  // of the sole [m]
  double progress() const noexcept { return progress_; }    // 0..1; 1: it is time for the ground
  bool lost() const noexcept { return place_.height < aim_ - gains_.deepest; }

 private:
  SwingGains gains_;
  Foothold place_;
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero(), acceleration_ = Eigen::Vector2d::Zero();
  double from_height_ = 0.0, aim_ = 0.0;  // of the ground it left, and where it should be [m]
  double progress_ = 0.0, search_ = 0.0;  // search_: downwards [m/s]
};

}  // namespace twinbus::control
