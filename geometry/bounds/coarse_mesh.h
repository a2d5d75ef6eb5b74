// A surface of few triangles around a mesh of many, for distances that must be found every tick.
//
// It is a convex hull of points chosen all around, enlarged until it holds every point: what lies in
// a hollow of the mesh counts as inside.

#pragma once

#include <optional>

#include "geometry/mesh/mesh_file.h"

namespace twinbus {

// Meshes of no more triangles are taken as they are.
inline constexpr int kFineTriangles = 100;

// Convex, holds every point of the mesh; triangles face outwards.  Nothing when the mesh has few
// triangles or no volume: then it is to be taken as it is.
std::optional<TriangleMesh> coarse_hull(const TriangleMesh& mesh);

}  // namespace twinbus
