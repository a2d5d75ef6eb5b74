// Small balls and capsules around points, and a ball inside of a hull.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "geometry/mesh/mesh_file.h"
#include "geometry/shapes.h"

namespace twinbus::inline geometry {

// Nearly the smallest; points not empty.  Exact: no point is farther than the radius.
Ball ball_around(const std::vector<Eigen::Vector3d>& points, int steps = 2000);

// A small capsule, found by hill climbing; points not empty.  Exact in the same sense.
Capsule capsule_around(const std::vector<Eigen::Vector3d>& points);

// A large ball inside of a convex body whose triangles face outwards; without triangles, of no radius.
Ball ball_inside(const TriangleMesh& hull);

}  // namespace twinbus::geometry
