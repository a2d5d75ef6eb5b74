// Support function of a box, sphere or cylinder, and what it says about the distance of two of
// them.
//
// For a unit direction n, from a to b,
//
//     separation(n) = n . (b - a) - h_a(n) - h_b(-n),     h(n) = max of n . x over the shape,
//
// never exceeds the signed distance, and its maximum over n is the signed distance (minus the
// penetration depth when the shapes overlap).

#pragma once

#include <Eigen/Geometry>

#include "geometry/shapes.h"

namespace twinbus::inline geometry {

struct ConvexShape {
  ShapeKind kind = ShapeKind::kSphere;             // a mesh counts as the box around it
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  // box: half edges; sphere: radius; cylinder:
                                                   // radius, half length [m]

  // h(n), n in the shape's frame.
  double extent(const Eigen::Vector3d& n) const noexcept;
  // A point of the shape with the largest n . x; the middle of the face or edge where n is square
  // to it.
  Eigen::Vector3d support(const Eigen::Vector3d& n) const noexcept;
  double radius() const noexcept;  // of the sphere around it
};

struct PlacedShape {
  const ConvexShape* shape;
  const Eigen::Isometry3d* pose;  // in world
};

double separation(const PlacedShape& a, const PlacedShape& b, const Eigen::Vector3d& n) noexcept;

// A direction of nearly the largest separation: the face normals, edge products and centres of
// both, then a few steps uphill.  For overlapping shapes; -separation is the depth.
Eigen::Vector3d way_out(const PlacedShape& a, const PlacedShape& b) noexcept;

}  // namespace twinbus::geometry
