// Points whose convex hull is that of a shape or of a link's geometry: for sizes and checks, not for
// distances.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// In the link frame [m].  A sphere and the rims of a cylinder become a few points on them.  Throws
// std::runtime_error when a mesh cannot be read.
void add_points(const Shape& shape, std::vector<Eigen::Vector3d>& points);

// Of the collision geometry, or of what a picture shows where there is none; empty when there is
// neither.  Meshes that cannot be read are left out.
std::vector<Eigen::Vector3d> link_points(const Link& link);

// How far a point sticks out of the hull of points [m], to about 1 % of its size; 0 inside.
double outside_hull(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point);

}  // namespace twinbus::robot
