#include "sim/world/link_hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/bounds/convex_hull.h"
#include "geometry/bounds/shape_mesh.h"

namespace twinbus::inline sim {

namespace {

constexpr double kThinnest = 1e-3;  // [m]
constexpr int kOfSpine = 5, kOfRim = 6;

}  // namespace

TriangleMesh link_hull(const Shape& mesh) {
  double outside = 0.0;
  const std::vector<Eigen::Vector3d> points = shape_mesh(mesh, outside).points;
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 27; ++i) {
    const Eigen::Vector3d along(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (along.isZero()) continue;
    const auto farthest =
        std::max_element(points.begin(), points.end(),
                         [&](const auto& a, const auto& b) { return along.dot(a) < along.dot(b); });
    if (std::find(corners.begin(), corners.end(), *farthest) == corners.end())
      corners.push_back(*farthest);
  }
  TriangleMesh hull = convex_hull(corners);
  if (!hull.triangles.empty()) return hull;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& corner : corners) box.extend(corner);
  const Eigen::Vector3d half = (0.5 * box.sizes()).cwiseMax(0.5 * kThinnest);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    hull.points.push_back(box.center() + sign.cwiseProduct(half));
  }
  return convex_hull(hull.points);
}

std::vector<TouchPoint> touch_points(const Shape& shape) {
  std::vector<TouchPoint> points;
  const Eigen::Vector3d& size = shape.size;
  switch (shape.kind) {
    case ShapeKind::kSphere:
      points.push_back({Eigen::Vector3d::Zero(), size.x()});
      break;
    case ShapeKind::kBox:
      for (int i = 0; i < 27; ++i) {
        if (i == 13) continue;  // the middle of the box
        points.push_back({{0.5 * (i % 3 - 1) * size.x(), 0.5 * (i / 3 % 3 - 1) * size.y(), 0.5 * (i / 9 - 1) * size.z()}, 0.0});
      }
      break;
    case ShapeKind::kCylinder: {
      const double radius = size.x(), half = 0.5 * size.y();
      for (int i = 0; half >= radius && i < kOfSpine; ++i)
        points.push_back({{0.0, 0.0, (half - radius) * (2.0 * i / (kOfSpine - 1) - 1.0)}, radius});
      for (int i = 0; half < radius && i < 2 * kOfRim; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i / 2) / kOfRim;
        points.push_back({{radius * std::cos(angle), radius * std::sin(angle), i % 2 == 0 ? half : -half}, 0.0});
      }
      break;
    }
    case ShapeKind::kMesh: {
      const Eigen::Isometry3d in_shape = shape.pose.inverse();
      for (const Eigen::Vector3d& corner : link_hull(shape).points) points.push_back({in_shape * corner, 0.0});
      break;
    }
  }
  return points;
}

}  // namespace twinbus::sim
