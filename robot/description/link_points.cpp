#include "robot/description/link_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline robot {

namespace {

constexpr int kRim = 16;          // points of a circle
constexpr int kDirections = 400;  // the hull is looked at from

// Evenly spread over the sphere.
Eigen::Vector3d direction(int i, int count) {
  const double z = 1.0 - (2.0 * i + 1.0) / count;
  const double turn = std::numbers::pi * (1.0 + std::sqrt(5.0)) * i;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

}  // namespace

void add_points(const Shape& shape, std::vector<Eigen::Vector3d>& points) {
  const Eigen::Vector3d& s = shape.size;
  switch (shape.kind) {
    case ShapeKind::kBox:
      for (int i = 0; i < 8; ++i) {
        points.push_back(shape.pose * Eigen::Vector3d((i & 1) != 0 ? 0.5 * s.x() : -0.5 * s.x(),
                                                      (i & 2) != 0 ? 0.5 * s.y() : -0.5 * s.y(),
                                                      (i & 4) != 0 ? 0.5 * s.z() : -0.5 * s.z()));
      }
      break;
    case ShapeKind::kSphere:
      for (int axis = 0; axis < 3; ++axis) {  // the extents are exact
        points.push_back(shape.pose.translation() + s.x() * Eigen::Vector3d::Unit(axis));
        points.push_back(shape.pose.translation() - s.x() * Eigen::Vector3d::Unit(axis));
      }
      for (int i = 0; i < 64; ++i) {
        points.push_back(shape.pose * Eigen::Vector3d(s.x() * direction(i, 64)));
      }
      break;
    case ShapeKind::kCylinder:
      for (int i = 0; i < kRim; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / kRim;
        for (const double z : {-0.5 * s.y(), 0.5 * s.y()}) {
          points.push_back(shape.pose *
                           Eigen::Vector3d(s.x() * std::cos(turn), s.x() * std::sin(turn), z));
        }
      }
      break;
    case ShapeKind::kMesh:
      for (const Eigen::Vector3d& point : load_mesh(shape.mesh, s).points) {
        points.push_back(shape.pose * point);
      }
      break;
  }
}

std::vector<Eigen::Vector3d> link_points(const Link& link) {
  std::vector<Eigen::Vector3d> points;
  for (const Shape& shape : link.collision.empty() ? link.visual : link.collision) {
    try {
      add_points(shape, points);
    } catch (const std::runtime_error&) {
    }
  }
  return points;
}

double outside_hull(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point) {
  double outside = 0.0;
  for (int i = 0; i < kDirections && !points.empty(); ++i) {
    const Eigen::Vector3d d = direction(i, kDirections);
    double reach = -1e300;
    for (const Eigen::Vector3d& p : points) reach = std::max(reach, d.dot(p));
    outside = std::max(outside, d.dot(point) - reach);
  }
  return outside;
}

}  // namespace twinbus::robot
