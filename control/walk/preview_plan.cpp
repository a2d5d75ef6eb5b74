#include "control/walk/preview_plan.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace twinbus::inline control {

namespace {
constexpr double kEvery = 0.01;   // between two ZMPs that are looked at [s]
constexpr double kHorizon = 1.6;  // they reach so far [s]
constexpr double kJerk = 1e-6;    // r [s^6]
}  // namespace

PreviewPlan::PreviewPlan(double height)
    : control_(height, kEvery, static_cast<int>(std::lround(kHorizon / kEvery)), kJerk) {
  for (auto& wanted : wanted_) wanted.resize(static_cast<std::size_t>(control_.count()));
}

void PreviewPlan::rest(const Eigen::Vector2d& at) noexcept {
  cart_ = {Cart{at.x()}, Cart{at.y()}};
  jerk_ = {};
}

void PreviewPlan::begin(const Eigen::Vector2d& dcm, const Eigen::Vector2d& zmp) noexcept {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    cart_[axis] = control_.cart(cart_[axis].position, dcm[i], zmp[i]);
  }
}

void PreviewPlan::advance(double dt) noexcept {
  for (std::size_t axis = 0; axis < 2; ++axis)
    cart_[axis] = PreviewControl::advance(cart_[axis], jerk_[axis], dt);
}

void PreviewPlan::plan(std::span<const ZmpPiece> ahead) noexcept {
  assert(!ahead.empty());
  std::size_t k = 0;
  double time = 0.0;  // since the piece began
  for (std::size_t i = 0; i < wanted_[0].size(); ++i) {
    time += kEvery;
    while (k + 1 < ahead.size() && time > ahead[k].duration) time -= ahead[k++].duration;
    const ZmpPiece& piece = ahead[k];
    const double share = std::min(1.0, time / piece.duration);
    const Eigen::Vector2d zmp = piece.from + share * (piece.to - piece.from);
    wanted_[0][i] = zmp.x();
    wanted_[1][i] = zmp.y();
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    jerk_[axis] = control_.jerk(cart_[axis], wanted_[axis].data());
}

}  // namespace twinbus::control
