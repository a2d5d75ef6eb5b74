// A surface of few triangles around a mesh of many, for distances that must be found every tick.
//
// It is a convex hull: what lies in a hollow of the mesh counts as inside.  Its corners are points chosen all
// around, then those that stick out most of its faces, until none does by more than kSticksOut or there are
// kMostCorners; then its box is stretched a little, until it holds every point.  So it is hardly larger than the hull
// of all points: what counts is that two links that walk past each other are not seen to touch.

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline geometry {

// Meshes of no more triangles are taken as they are.
inline constexpr int kFineTriangles = 100;
inline constexpr int kMostCorners = 200;      // a hull of n corners has 2 n - 4 triangles
inline constexpr double kSticksOut = 0.3e-3;  // [m]

// Convex, holds every point of the mesh; triangles face outwards.  Nothing when the mesh has few
// triangles or no volume: then it is to be taken as it is.
std::optional<TriangleMesh> coarse_hull(const TriangleMesh& mesh);

// Are all the points below every face of a convex hull?
bool holds(const TriangleMesh& hull, const std::vector<Eigen::Vector3d>& points);

}  // namespace twinbus::geometry
