#include "robot/collision/collision_body.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/bounds/bounds.h"
#include "geometry/bounds/convex_hull.h"
#include "robot/collision/links/geometry_cache.h"
#include "geometry/mesh/mesh_file.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

// Along the longest edge of a box, or the axis; round ends beyond what is flat.
Capsule around(const ConvexShape& shape) {
  Capsule capsule;
  int axis = 2;
  double half = 0.0;
  if (shape.kind == ShapeKind::kBox) {
    half = shape.half.maxCoeff(&axis);
    capsule.radius = std::sqrt(std::max(0.0, shape.half.squaredNorm() - half * half));
  } else {
    if (shape.kind == ShapeKind::kCylinder) half = shape.half.y();
    capsule.radius = shape.half.x();
  }
  capsule.b = half * Vector3d::Unit(axis);
  capsule.a = -capsule.b;
  return capsule;
}

CollisionShape primitive(const Shape& shape) {
  CollisionShape result;
  result.convex.kind = shape.kind;
  result.local = shape.pose;
  const Vector3d& size = shape.size;
  switch (shape.kind) {
    case ShapeKind::kBox:
      result.convex.half = 0.5 * size;
      break;
    case ShapeKind::kSphere:
      result.convex.half = Vector3d(size.x(), 0.0, 0.0);
      break;
    case ShapeKind::kCylinder:
      result.convex.half = Vector3d(size.x(), 0.5 * size.y(), 0.0);
      break;
    case ShapeKind::kMesh:
      break;
  }
  result.core.kind = shape.kind;
  result.core.half = result.convex.half;
  result.capsule = around(result.convex);
  return result;
}

CollisionShape of_mesh(const Shape& shape) {
  TriangleMesh mesh = load_mesh(shape.mesh, shape.size);
  const std::optional<TriangleMesh> hull = kept_coarse_hull(mesh);
  if (hull) mesh = *hull;
  const Eigen::AlignedBox3d box = box_around(mesh.points);
  const Vector3d middle = box.center();
  CollisionShape result;
  result.convex = {ShapeKind::kMesh, 0.5 * box.sizes()};
  result.local = shape.pose * Eigen::Translation3d(middle);
  for (Vector3d& point : mesh.points) point -= middle;
  const TriangleMesh around_all = hull ? mesh : convex_hull(mesh.points);
  const std::vector<Vector3d>& corners = around_all.points;
  result.core = gjk_hull(corners);
  result.inside = ball_inside(around_all);
  result.capsule = kept_capsule(corners);
  if (!hull) {
    result.mesh = std::make_shared<ClusteredMesh>(mesh);
  }
  return result;
}

}  // namespace

CollisionShape collision_shape(const Shape& shape) {
  CollisionShape result = shape.kind == ShapeKind::kMesh ? of_mesh(shape) : primitive(shape);
  result.radius = result.convex.radius();
  return result;
}

void enclose(CollisionOwner& owner) {
  Vector3d low = Vector3d::Constant(1e300);
  Vector3d high = -low;
  for (const CollisionShape& shape : owner.shapes) {
    for (int k = 0; k < 3; ++k) {
      const double reach = shape.convex.extent(shape.local.linear().row(k).transpose());
      low[k] = std::min(low[k], shape.local.translation()[k] - reach);
      high[k] = std::max(high[k], shape.local.translation()[k] + reach);
    }
  }
  owner.center = 0.5 * (low + high);
  for (const CollisionShape& shape : owner.shapes) {
    owner.radius = std::max(
        owner.radius, (shape.local.translation() - owner.center).norm() + shape.convex.radius());
  }
}

}  // namespace twinbus::robot
