// By how much two boxes overlap: the least of the fifteen separating axes (Gottschalk, Lin and
// Manocha 1996), three faces of each and nine crossings of their edges.

#pragma once

#include <Eigen/Geometry>

namespace twinbus {

// Negative: apart by at least so much along one of the axes [m].  half: half edges; poses in one frame.
double box_overlap(const Eigen::Isometry3d& a, const Eigen::Vector3d& half_a, const Eigen::Isometry3d& b,
                   const Eigen::Vector3d& half_b) noexcept;

}  // namespace twinbus
