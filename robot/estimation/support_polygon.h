// Convex hull of the loaded soles on the ground, and how far inside a point is.  Never allocates.

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "robot/description/model.h"

namespace twinbus::inline robot {

class SupportPolygon {
 public:
  static constexpr int kCapacity = 16;

  void clear() noexcept { count_ = 0; }
  // A corner of a sole, seen from above [m].  More than kCapacity are ignored.
  void add(const Eigen::Vector2d& point) noexcept;
  // The corners of a sole whose frame lies so.
  void add(const Sole& sole, const Eigen::Isometry3d& frame) noexcept;
  // After the last add and before margin.
  void finish() noexcept;

  // Corners of the hull, counter-clockwise.
  int count() const noexcept { return count_; }
  const Eigen::Vector2d& corner(int i) const noexcept {
    return points_[static_cast<std::size_t>(i)];
  }

  // Distance to the edge, positive inside [m]; -1 when there is no polygon.
  double margin(const Eigen::Vector2d& point) const noexcept;
  Eigen::Vector2d centre() const noexcept;

 private:
  std::array<Eigen::Vector2d, kCapacity + 1> points_;
  int count_ = 0;
};

}  // namespace twinbus::robot
