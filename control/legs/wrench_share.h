// A zero-moment point shared between two feet on the ground, closed form.
//
// The load share is the place of the ZMP on the line between the sole centres; what is left over
// moves both centres of pressure by the same vector, clipped to the soles less a margin.

#pragma once

#include <Eigen/Core>
#include <array>

namespace twinbus::inline control {

struct SoleOnGround {                                  // in the ground frame
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // of the sole frame [m]
  double yaw = 0.0;                                    // [rad]
  // Farthest a centre of pressure may be from the middle, forward and sideways, times the load share
  // [m]: a soft sole tilts under an off-centre load.
  Eigen::Vector2d most_moment = Eigen::Vector2d::Constant(1e9);
  double front = 0.0, back = 0.0, left = 0.0, right = 0.0;  // edges from the sole frame [m]

  Eigen::Vector2d turn(const Eigen::Vector2d& in_sole) const noexcept;  // sole axes -> ground axes
  Eigen::Vector2d unturn(const Eigen::Vector2d& in_ground) const noexcept;
  Eigen::Vector2d centre() const noexcept {
    return position + turn({0.5 * (front - back), 0.5 * (left - right)});
  }
};

struct ZmpShare {
  double left = 0.5;  // load share of the left foot, 0..1
  // In the axes of each sole, from its frame [m].
  std::array<Eigen::Vector2d, 2> cop{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  Eigen::Vector2d zmp = Eigen::Vector2d::Zero();  // what this gives, in the ground frame [m]
};

// soles: left, right.  margin: kept from the edges [m].  least_load: smallest share of either foot.
ZmpShare share_zmp(const std::array<SoleOnGround, 2>& soles, const Eigen::Vector2d& zmp,
                   double margin, double least_load) noexcept;

}  // namespace twinbus::control
