// Where and how deep two convex sets of triangles overlap: the least over the directions square to a face of either, or to two edges
// that cross (Gottschalk, Lin and Manocha 1996).
//
// Of the crossings only those are asked whose edges build a face of the bodies' Minkowski difference, and that lie in what
// overlaps along the best face.

#pragma once

#include <Eigen/Geometry>

#include "geometry/mesh_contact/contact_mesh.h"

namespace twinbus::inline geometry {

struct HullOverlap {
  static constexpr std::size_t kMost = 192;           // corners of each; no more are looked at
  double depth = 0.0;                                 // the least; not positive: apart [m]
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // from B to A
};

// Whether nothing of it lies beyond one of its faces, and it has no more corners than can be asked about.
bool is_hull(const ContactMesh& mesh);

// Both must be hulls.  Poses in one frame, which is that of the result.
HullOverlap hull_overlap(const ContactMesh& a, const Eigen::Isometry3d& pose_a, const ContactMesh& b,
                         const Eigen::Isometry3d& pose_b) noexcept;

}  // namespace twinbus::geometry
