// Which foot of a walking robot carries a wanted ZMP, and where under each sole: used by the controller's stabilizer and by
// a source that follows a stop plan.
//
// On both feet the share is the place of the ZMP on the line between the points where a sole carries alone; what is left over
// moves both centres of pressure by the same vector, cut to the soles.

#pragma once

#include <Eigen/Core>
#include <array>

namespace twinbus::inline robot {

struct SolePlace {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // of the sole frame [m]
  double cosine = 1.0, sine = 0.0;                     // of its heading

  // Sole axes -> ground axes, and back.
  Eigen::Vector2d turn(const Eigen::Vector2d& v) const noexcept {
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
  }
  Eigen::Vector2d unturn(const Eigen::Vector2d& v) const noexcept {
    return {cosine * v.x() + sine * v.y(), -sine * v.x() + cosine * v.y()};
  }
};

// In the sole frame [m].
struct SoleArea {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = low;  // where a ZMP may be
};

struct SoleShare {
  double left = 0.5;  // load share of the left foot, 0..1
  std::array<Eigen::Vector2d, 2> cop{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};  // sole axes [m]
  Eigen::Vector2d zmp = Eigen::Vector2d::Zero();  // what this gives, ground [m]
};

// on: where each sole carries alone, ground [m].  carries: the foot that carries alone, -1 when both do.
SoleShare share_on_soles(const std::array<SolePlace, 2>& soles, const std::array<Eigen::Vector2d, 2>& on,
                         const SoleArea& area, int carries, const Eigen::Vector2d& zmp) noexcept;

}  // namespace twinbus::robot
