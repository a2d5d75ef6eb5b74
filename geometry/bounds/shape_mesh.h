// Triangles of collision shapes: boxes and mesh files as they are, round ones from outside.

#pragma once

#include "geometry/mesh/mesh_file.h"
#include "geometry/shapes.h"

namespace twinbus::inline geometry {

// A shape in the link frame.  outside: raised to how far the triangles lie outside of the true
// shape at most [m].  Throws std::runtime_error when a mesh cannot be read.
TriangleMesh shape_mesh(const Shape& shape, double& outside);

// Adds one mesh to another.
void append(const TriangleMesh& more, TriangleMesh& mesh);

// Corners nearer than about 1 um become one; triangles that lose a corner so are dropped.
TriangleMesh welded(const TriangleMesh& mesh);

}  // namespace twinbus::geometry
