// What a link of triangles touches with: the hull of those corners that stand out farthest in the
// 26 directions of a cube's faces, edges and corners.

#pragma once

#include "geometry/mesh/mesh_file.h"
#include "robot/description/model.h"

namespace twinbus {

// In the link frame.  Of a mesh without volume the box around it, 1 mm thick at least.  Throws
// std::runtime_error when it cannot be read.
TriangleMesh link_hull(const Shape& mesh);

}  // namespace twinbus
