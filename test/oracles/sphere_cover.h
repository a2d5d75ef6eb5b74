// A few balls whose union holds every triangle of a mesh: what other planners, and `bench planner`, check instead of
// the mesh, with nothing sticking out.
//
// A triangle is inside a ball when its three corners are.  Triangles that no ball holds alone are
// cut at the middle of their longest edge, as often as it takes; the pieces tile the triangle, so
// when all are held the triangle is.

#pragma once

#include <vector>

#include "robot/collision/links/link_geometry.h"

namespace twinbus {

// At most `most` balls that stick out of the hull of the mesh by no more than `excess` [m] if that
// can be done with so many.  points of hull: its corners.
std::vector<Ball> cover_with_balls(const TriangleMesh& mesh, const TriangleMesh& hull,
                                   double excess = 0.012, int most = 24);

// Proved: every point of every triangle is inside some ball.
bool covers(const std::vector<Ball>& balls, const TriangleMesh& mesh);

// How far the balls stick out of the convex hull of these points [m], along many directions.
double excess_over_hull(const std::vector<Ball>& balls, const TriangleMesh& hull);

}  // namespace twinbus
