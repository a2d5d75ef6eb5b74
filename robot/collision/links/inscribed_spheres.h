// Balls inside a closed mesh, and points of its surface as balls of no size: where those of two links
// overlap, the links touch, and no triangle need be looked at.
//
// With a point inside both closed surfaces, either they cross or one lies inside the other.  A point
// of one surface inside the other has points of its own inside beside it, so it says the same.

#pragma once

#include <vector>

#include "robot/collision/links/link_geometry.h"

namespace twinbus::inline robot {

// At most `balls` balls and `points` points.  None of a mesh that is not closed, every edge used as
// often one way as the other: its inside is not defined.  mesh, hull and clusters of `link` are read.
std::vector<Ball> inner_balls(const LinkGeometry& link, int balls, int points);

// Are all of them balls inside the mesh, or corners of its hull?  What inner_balls promises.
bool are_inside(const LinkGeometry& link, const std::vector<Ball>& balls);

// How often the mesh is wound around the point: 0 outside, +-1 inside, of an open mesh between.
double winding_number(const TriangleMesh& mesh, const Eigen::Vector3d& point);

}  // namespace twinbus::robot
