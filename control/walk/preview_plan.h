// Reference of the DCM by preview control: a cart on a table for each axis that runs ahead of what the pattern plans.
//
// The closed form (dcm_plan.h) has no memory: every tick it starts from the plan.  These carts have one, so what a plan
// that jumps does to them is a bounded jerk; they know the ZMP of the next seconds, as far as the footholds are planned.

#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "control/walk/dcm_plan.h"
#include "control/walk/preview_control.h"

namespace twinbus::inline control {

class PreviewPlan {
 public:
  // height: of the centre of mass [m].  Allocates.
  explicit PreviewPlan(double height);

  // Both carts stand there.
  void rest(const Eigen::Vector2d& at) noexcept;
  // After what nobody saw coming, a robot that is caught: the carts go on where they are as the closed form has it.
  void begin(const Eigen::Vector2d& dcm, const Eigen::Vector2d& zmp) noexcept;
  // The jerk of the last plan for a tick.
  void advance(double dt) noexcept;
  // What the ZMP is to be from now on: at least one piece; after the last it stays.
  void plan(std::span<const ZmpPiece> ahead) noexcept;

  Eigen::Vector2d zmp() const noexcept { return {control_.zmp(cart_[0]), control_.zmp(cart_[1])}; }
  Eigen::Vector2d dcm() const noexcept { return {control_.dcm(cart_[0]), control_.dcm(cart_[1])}; }

 private:
  PreviewControl control_;
  std::array<Cart, 2> cart_;
  std::array<double, 2> jerk_{};               // [m/s^3]
  std::array<std::vector<double>, 2> wanted_;  // ZMPs [m]
};

}  // namespace twinbus::control
