// Distance of two convex shapes by the Gilbert-Johnson-Keerthi method.
//
// The difference of the shapes is searched for its point nearest to zero, from one support point to
// the next; what is found is bounded from below at every step:
//
//     v . w / |v|  <=  distance  <=  |v|,     w the support point of the difference along -v
//
// No memory: the same poses, and the same first look, give the same bits.

#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "common/simd/instruction_set.h"
#include "geometry/shapes.h"
#include "geometry/distance/support_cells.h"

namespace twinbus::inline geometry {

struct GjkShape {
  ShapeKind kind = ShapeKind::kSphere;             // kMesh: the hull of the points
  Eigen::Vector3d half = Eigen::Vector3d::Zero();  // box: half edges; sphere: radius; cylinder:
                                                   // radius, half length; hull: of a box about its
                                                   // origin that holds it [m]
  std::vector<double> points;  // x of all, y of all, z of all; a multiple of four each [m]
  SupportCells cells;          // of the points; may be empty
};

// The hull of these points as a shape; points not empty.
GjkShape gjk_hull(const std::vector<Eigen::Vector3d>& points);

struct GjkResult {
  double distance = 0.0;                              // [m]; zero when they overlap
  double below = 0.0;                                 // the distance is not smaller than this [m]
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();  // in the frame of the poses
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // from a to b, unit; zero when they overlap
};

inline constexpr double kGjkClose = 5e-8;  // [m]

// close: the search ends when distance and below are this near to each other [m].
// Stops early when the distance is larger than `far` [m]: below says so, the rest is unfinished.
// towards_b: where to look first, in a's axes, such as the normal of the last time; zero: nothing is
// known.
GjkResult gjk_distance(const GjkShape& a, const Eigen::Isometry3d& pose_a, const GjkShape& b,
                       const Eigen::Isometry3d& pose_b, double far,
                       const Eigen::Vector3d& towards_b = Eigen::Vector3d::Zero(),
                       double close = kGjkClose) noexcept;

}  // namespace twinbus::geometry
