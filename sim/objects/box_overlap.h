// Where and how deep two boxes overlap: the least of the fifteen separating axes (Gottschalk, Lin and Manocha 1996),
// three faces of each and nine crossings of their edges.
//
// Under a face the points are the corners of the other box's face, cut off at the sides of the first; of two edges that
// cross there is one.  No point is deeper than the way that the boxes are to be moved apart.

#pragma once

#include <Eigen/Geometry>
#include <array>

namespace twinbus::inline sim {

struct BoxOverlap {
  static constexpr int kMost = 8;
  double depth = 0.0;  // the least; negative: apart by at least so much [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // from B to A
  int axis = 0;  // 0 to 2: a face of A, 3 to 5: of B, from 6: edges i, j of them as 6 + 3 i + j
  // Of box_contact():
  int count = 0;
  std::array<Eigen::Vector3d, kMost> point;  // half way between the surfaces
  std::array<double, kMost> deep;            // [m], positive
};

// half: half edges; poses in one frame, which is that of the result.
BoxOverlap box_overlap(const Eigen::Isometry3d& a, const Eigen::Vector3d& half_a,
                       const Eigen::Isometry3d& b, const Eigen::Vector3d& half_b) noexcept;

// Fills in the points.
void box_contact(const Eigen::Isometry3d& a, const Eigen::Vector3d& half_a,
                 const Eigen::Isometry3d& b, const Eigen::Vector3d& half_b,
                 BoxOverlap& overlap) noexcept;

}  // namespace twinbus::sim
