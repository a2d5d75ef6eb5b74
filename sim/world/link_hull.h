// What a link touches with: points of its shapes; of triangles the hull of those corners that stand out farthest in the
// 26 directions of a cube's faces, edges and corners.

#pragma once

#include <vector>

#include "geometry/mesh/mesh_file.h"
#include "robot/description/model.h"

namespace twinbus::inline sim {

// In the link frame.  Of a mesh without volume the box around it, 1 mm thick at least.  Throws
// std::runtime_error when it cannot be read.
TriangleMesh link_hull(const Shape& mesh);

// A ball that touches; of radius 0: a point [m].
struct TouchPoint {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  // in the frame of the shape
  double radius = 0.0;
};
// A ball itself; of a box corners and middles of edges and faces; of a cylinder balls along its spine, or points of both rims where
// it is a disk; of triangles the corners of link_hull.
std::vector<TouchPoint> touch_points(const Shape& shape);

}  // namespace twinbus::sim
