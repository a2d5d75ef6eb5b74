#include "robot/collision/shape_gap.h"

#include <algorithm>
#include <utility>

#include "geometry/distance/convex_shape.h"
#include "geometry/distance/gjk.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

constexpr double kBoundError = 1e-9;  // [m]; what a bound may be wrong by
// GJK has converged when its distance agrees with the lower bound of its own direction to this [m].
constexpr double kConverged = 1e-6;
// The distance of hulls stands for that of meshes above this [m].
constexpr double kHullsApart = 0.02;

}  // namespace

// Distance, points and normal of the cores, the distance zero when they overlap; false when they
// are farther apart than near.
bool ShapeGap::own_distance(const CollisionShape& a, const CollisionShape& b,
                            const Vector3d& towards_b, double near, PairDistance& result) noexcept {
  const double far = std::max(near, 0.0) + kBoundError;
  const GjkResult found = gjk_distance(a.core, a.world, b.core, b.world, far, towards_b, close);
  if (found.distance > 0.0 && found.below > near + kBoundError) {
    parted = found.below - kBoundError;
    return false;
  }
  result.distance = found.distance;
  result.point_a = found.point_a;
  result.point_b = found.point_b;
  result.normal = found.normal;
  return true;
}

// Distance and points where at least one is a mesh; false when they are farther apart than near.
bool ShapeGap::mesh_distance(const CollisionShape& a, const CollisionShape& b, double near,
                             double at_least, MeshMemory& nearest, PairDistance& result) noexcept {
  MeshGap gap;
  const double below = near + kBoundError;
  if (a.mesh && b.mesh) {
    if (!meshes.between(*a.mesh, a.world, *b.mesh, b.world, below, at_least, nearest, gap))
      return false;
  } else if (a.mesh) {
    if (!meshes.between(*a.mesh, a.world, b.core, b.world, below, nearest, gap)) return false;
  } else {
    if (!meshes.between(*b.mesh, b.world, a.core, a.world, below, nearest, gap)) return false;
    std::swap(gap.point_a, gap.point_b);
  }
  result.distance = gap.distance;
  result.point_a = gap.point_a;
  result.point_b = gap.point_b;
  return true;
}

bool ShapeGap::nearer(CollisionShape& a, CollisionShape& b, ShapeMemory& remembered,
                      const Vector3d& towards, double near, PairDistance& result) noexcept {
  const PlacedShape shape_a{&a.convex, &a.world};
  const PlacedShape shape_b{&b.convex, &b.world};
  const Vector3d between = b.world.translation() - a.world.translation();
  const double reach = a.radius + b.radius + near;
  parted = near;
  if (!(reach > 0.0) || between.squaredNorm() > reach * reach) return false;
  const Vector3d before = a.world.linear() * remembered.apart;
  const double as_before = separation(shape_a, shape_b, before);
  if (as_before > near + kBoundError) {
    parted = as_before - kBoundError;
    return false;
  }
  const Vector3d seen = towards.squaredNorm() > 1e-8 ? towards.normalized() : between.normalized();
  const double as_seen = separation(shape_a, shape_b, seen);
  if (as_seen > near + kBoundError) {
    parted = as_seen - kBoundError;
    return false;
  }
  const Vector3d first = a.world.linear().transpose() *
                         (as_before > as_seen && !remembered.apart.isZero(0.0) ? before : seen);

  PairDistance found;
  found.distance = near + 1.0;
  if (!own_distance(a, b, first, near, found)) return false;
  if (found.distance > kConverged) remembered.apart = a.world.linear().transpose() * found.normal;
  const bool exact = (a.mesh || b.mesh) && !(found.distance > kHullsApart);
  if (exact && !mesh_distance(a, b, near, std::max(found.distance - kConverged, 0.0),
                              remembered.nearest, found))
    return false;
  if (!(found.distance > kConverged) && (depths || found.distance > 0.0)) {
    // Touching: the shortest way out.
    found.normal = way_out(shape_a, shape_b);
    const double out = separation(shape_a, shape_b, found.normal);
    found.distance = std::min(found.distance, out);
    found.point_a = a.world * a.convex.support(a.world.linear().transpose() * found.normal);
    found.point_b = b.world * b.convex.support(-(b.world.linear().transpose() * found.normal));
  } else if (exact && found.distance > 0.0) {
    found.normal = (found.point_b - found.point_a).normalized();
  }
  parted = found.distance - std::max(kConverged, close);
  if (!(found.distance <= near) || found.distance >= result.distance) return false;
  found.link_a = result.link_a;
  found.link_b = result.link_b;
  result = found;
  return true;
}

}  // namespace twinbus::robot
