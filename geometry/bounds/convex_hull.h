// Convex hull of points: the farthest point outside of a face is taken in, until none is left.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline geometry {

// Corners are some of `points`; triangles face outwards and every point is at most 5e-7 of the
// diagonal of their box outside of each.  Points in a plane or on a line, and points that rounding makes
// undecidable, come back as they are with no triangle.
TriangleMesh convex_hull(const std::vector<Eigen::Vector3d>& points);

}  // namespace twinbus::geometry
