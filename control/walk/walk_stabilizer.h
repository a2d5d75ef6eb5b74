// Keeps a walking robot on its plan: a reference that cannot jump, feedback of the DCM, and who carries the ZMP it asks for.
//
//     p_r = clip(p_plan + (1 + k_r/omega)(xi_r - xi_plan))     xi_r' = omega (xi_r - p_r)    x_r' = omega (xi_r - x_r)
//     p   = p_r + (1 + k/omega)(xi - xi_r) + k_i integral      e = p - clip(p): what the soles cannot do
//     xi_r += dt lambda e / (1 + k/omega)                      the reference gives up what is lost
//
// The plan steps when a foot lands early or a foothold moves; the reference is a pendulum of its own that is pulled to it.

#pragma once

#include <Eigen/Core>

#include "control/walk/walk_gains.h"
#include "control/walk/walk_pattern.h"
#include "control/legs/wrench_share.h"

namespace twinbus::inline control {

class WalkStabilizer {
 public:
  explicit WalkStabilizer(const WalkStabilizerGains& gains) noexcept : gains_(gains) {}

  // The reference begins at a measured centre of mass and DCM [m].
  void start(const Eigen::Vector2d& com, const Eigen::Vector2d& dcm) noexcept;
  // Another source speaks from now on: its first error is let in slowly.
  void rebase() noexcept { rebase_ = true; }
  void update(const WalkPattern& pattern, const Eigen::Vector2d& com, const Eigen::Vector2d& dcm,
              double omega, double dt) noexcept;

  const Eigen::Vector2d& com() const noexcept { return com_; }            // x_r
  const Eigen::Vector2d& velocity() const noexcept { return velocity_; }  // x_r'
  const Eigen::Vector2d& zmp() const noexcept { return zmp_; }            // p_r
  const Eigen::Vector2d& zmp_wanted() const noexcept { return wanted_; }  // p
  const Eigen::Vector2d& error() const noexcept { return error_; }        // xi - xi_r
  const Eigen::Vector2d& excess() const noexcept { return excess_; }      // e
  const ZmpShare& share() const noexcept { return share_; }

 private:
  WalkStabilizerGains gains_;
  Eigen::Vector2d com_ = Eigen::Vector2d::Zero(), velocity_ = com_, dcm_ = com_, zmp_ = com_;
  Eigen::Vector2d wanted_ = com_, error_ = com_, excess_ = com_, integral_ = com_, bias_ = com_;
  bool rebase_ = false;
  ZmpShare share_;
};

// A ZMP (world) shared between the feet of a pattern: on one foot the other carries nothing.
ZmpShare share_walking(const WalkPattern& pattern, const Eigen::Vector2d& zmp) noexcept;

}  // namespace twinbus::control
