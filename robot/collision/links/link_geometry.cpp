#include "robot/collision/links/link_geometry.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/bounds/bounds.h"
#include "geometry/bounds/convex_hull.h"
#include "robot/collision/links/geometry_cache.h"
#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"
#include "geometry/bounds/triangle_clusters.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Vector3d;

// Bounds of links are used in single precision, up to two metres from the base.
constexpr double kGrowLink = 1e-6, kGrowShare = 1e-5;  // [m], of the radius
constexpr double kRadiusRounding = 1e-14;                    // share, of a radius in double precision

double grown_link(double radius) { return radius * (1.0 + kGrowShare) + kGrowLink; }

// All but the box; the order of the triangles in the clusters, too.
void find_bounds(LinkGeometry& g, std::vector<int>& order) {
  g.hull = convex_hull(g.mesh.points);
  const auto grown = [&](double radius, auto distance) {
    for (const Vector3d& p : g.mesh.points) radius = std::max(radius, distance(p));
    return grown_link(radius) * (1.0 + kRadiusRounding);
  };
  g.sphere = ball_around(g.hull.points);
  g.sphere.radius =
      grown(g.sphere.radius, [&](const Vector3d& p) { return (p - g.sphere.center).norm(); });
  g.capsule = capsule_around(g.hull.points);
  const Vector3d along = g.capsule.b - g.capsule.a;
  g.capsule.radius = grown(g.capsule.radius, [&](const Vector3d& p) {
    const double t =
        std::clamp((p - g.capsule.a).dot(along) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
    return (p - g.capsule.a - t * along).norm();
  });
  g.clusters = triangle_clusters(g.mesh, order);
}

[[noreturn]] void unsound(const char* what) {
  throw std::runtime_error(std::string("geometry: a ") + what +
                           " does not hold its triangles; simplify the mesh");
}

}  // namespace

LinkGeometry link_geometry(const std::vector<Shape>& shapes) {
  LinkGeometry g;
  g.low = g.high = Vector3d::Zero();
  bool primitive = true;
  TriangleMesh all;
  for (const Shape& shape : shapes) {
    const TriangleMesh one = shape_mesh(shape, g.outside);
    if (!one.points.empty()) g.witnesses.push_back(one.points.front());
    append(one, all);
    primitive = primitive && shape.kind != ShapeKind::kMesh;
  }
  g.mesh = welded(all);
  if (g.mesh.triangles.empty()) return g;
  if (primitive) g.parts = shapes;
  const Eigen::AlignedBox3d box = box_around(g.mesh.points);
  g.low = box.min().array() - kGrowLink;
  g.high = box.max().array() + kGrowLink;
  if (recall_bounds(g)) return g;
  std::vector<int> order;
  find_bounds(g, order);
  verify(g);
  keep_bounds(g, order);
  return g;
}

void verify(const LinkGeometry& g) {
  const Vector3d along = g.capsule.b - g.capsule.a;
  for (const Vector3d& p : g.mesh.points) {
    if (!(grown_link((p - g.sphere.center).norm()) <= g.sphere.radius)) unsound("sphere");
    const double t =
        std::clamp((p - g.capsule.a).dot(along) / std::max(along.squaredNorm(), 1e-30), 0.0, 1.0);
    if (!(grown_link((p - g.capsule.a - t * along).norm()) <= g.capsule.radius)) unsound("capsule");
    if (!((p - g.low).minCoeff() >= 0.0 && (g.high - p).minCoeff() >= 0.0)) unsound("box");
  }
  int triangles = 0;
  for (const TriangleCluster& c : g.clusters) {
    triangles += c.count;
    for (int lane = 0; lane < TriangleCluster::kLanes; ++lane) {
      for (std::size_t k = 0; k < 3; ++k) {
        double distance2 = 0.0;
        for (std::size_t d = 0; d < 3; ++d) {
          const double x = static_cast<double>(c.corner[k][d][lane]);
          const double gap = x - static_cast<double>(c.center[d]);
          distance2 += gap * gap;
          if (!(x >= static_cast<double>(c.low[d]) && x <= static_cast<double>(c.high[d])))
            unsound("cluster's box");
        }
        if (!(std::sqrt(distance2) + 0.5 * kGrowTriangleCluster <= static_cast<double>(c.radius)))
          unsound("cluster's sphere");
      }
    }
  }
  const double most = 1.0 + (g.high - g.low).norm();  // no bound need be larger
  if (!(std::max(g.sphere.radius, g.capsule.radius) <= most)) unsound("sphere or capsule");
  if (triangles != static_cast<int>(g.mesh.triangles.size())) unsound("list of clusters");
}

RobotGeometry build_geometry(const Model& model) {
  RobotGeometry robot;
  robot.of_link.assign(model.links.size(), -1);
  for (int link = 0; link < model.link_count(); ++link) {
    const std::vector<Shape>& shapes = model.links[at(link)].collision;
    if (shapes.empty()) continue;
    LinkGeometry g = link_geometry(shapes);
    if (g.mesh.triangles.empty()) continue;
    g.link = link;
    robot.of_link[at(link)] = static_cast<int>(robot.links.size());
    robot.links.push_back(std::move(g));
  }
  return robot;
}

}  // namespace twinbus::robot
