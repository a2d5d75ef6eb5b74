// How rough the ground is that a walking robot finds: what no plane foretold of its landings.
//
// Of a landing two things may differ from a plane of gradient k: how much higher the foot came down than the other one,
// where a sole turned as g_l touches the plane with its toe or its heel, and how the sole that carried the robot meanwhile was
// turned, times its length:
//
//     e = max(|dh - k . dp - max over toe and heel of (k - g_l) . edge|, length |s - k|)
//
// A slope is believed some steps after it began (GroundSlope): the latest landings are then judged anew, and what the plane that
// is believed now foretells of them, or ground between it and the one before, as where one foot stands below the edge and one
// above it, was no roughness.  Without that a robot would go on along a slope as along rubble.

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>

namespace twinbus::inline control {

class GroundRoughness {
 public:
  struct Landing {
    Eigen::Vector2d way = Eigen::Vector2d::Zero();  // dp: from the foot that carried to the one that landed, world [m]
    double rise = 0.0;                              // dh [m]
    Eigen::Vector2d landed = Eigen::Vector2d::Zero();    // g_l: of the sole that landed, as it did
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  // s: under the sole that carried
    Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  // of the sole that landed, world
    double toe = 0.0, heel = 0.0;  // of both, before and behind their frames; 0: a sole that does not tell how the ground is [m]
  };

  void reset() noexcept { *this = {}; }

  // believed: k, with what that landing told.
  void landed(const Landing& landing, const Eigen::Vector2d& believed) noexcept {
    older_ = kRemembers * std::max(older_, error_.back());
    for (std::size_t i = kLatest - 1; i > 0; --i) {
      latest_[i] = latest_[i - 1];
      error_[i] = kRemembers * error_[i - 1];
    }
    latest_[0] = landing;
    error_[0] = off(landing, before_, believed);
    double remembered = 1.0;
    for (std::size_t i = 0; i < kLatest; ++i, remembered *= kRemembers)
      error_[i] = std::min(error_[i], remembered * off(latest_[i], before_, believed));
    before_ = believed;
  }
  // What the landings met, the older the less [m].
  double roughness() const noexcept { return std::max(older_, *std::max_element(error_.begin(), error_.end())); }

 private:
  static constexpr std::size_t kLatest = 6;     // landings that a slope may still explain
  static constexpr double kRemembers = 0.9;     // share of a roughness that the next landing leaves

  // How much higher it comes down on a plane.
  static double foretold(const Landing& landing, const Eigen::Vector2d& plane) noexcept {
    const double along = (plane - landing.landed).dot(landing.forward);
    return plane.dot(landing.way) + std::max(landing.toe * along, -landing.heel * along);
  }
  // e, of the nearest plane between these two.
  static double off(const Landing& landing, const Eigen::Vector2d& a, const Eigen::Vector2d& b) noexcept {
    const double ha = foretold(landing, a), hb = foretold(landing, b);
    const double step = std::max({0.0, std::min(ha, hb) - landing.rise, landing.rise - std::max(ha, hb)});
    const Eigen::Vector2d along = b - a;
    const double there = std::clamp((landing.gradient - a).dot(along) / std::max(1e-12, along.squaredNorm()), 0.0, 1.0);
    return std::max(step, (landing.toe + landing.heel) * (landing.gradient - a - there * along).norm());
  }

  std::array<Landing, kLatest> latest_{};  // the last one first
  std::array<double, kLatest> error_{};    // of them, as remembered [m]
  double older_ = 0.0;                     // [m]
  Eigen::Vector2d before_ = Eigen::Vector2d::Zero();  // believed at the landing before
};

}  // namespace twinbus::control
