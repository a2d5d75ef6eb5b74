#include "geometry/bounds/coarse_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/bounds/convex_hull.h"
#include "common/math/index.h"

namespace twinbus {

namespace {

constexpr int kHullDirections = 50;       // a hull of n corners has 2 n - 4 triangles
constexpr double kMostGrowth = 1.5;       // what must grow more is nearly flat
constexpr double kHullRoom = 1.0 + 1e-6;  // against rounding

// Evenly spread over the sphere.
Eigen::Vector3d hull_direction(int i) {
  const double z = 1.0 - (2.0 * i + 1.0) / kHullDirections;
  const double turn = std::numbers::pi * (1.0 + std::sqrt(5.0)) * i;
  const double r = std::sqrt(1.0 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

// By how much the hull must grow about `centre` so that it holds the points.
double growth(const TriangleMesh& hull, const Eigen::Vector3d& centre,
              const std::vector<Eigen::Vector3d>& points) {
  double most = 1.0;
  for (const auto& t : hull.triangles) {
    const Eigen::Vector3d& a = hull.points[at(t[0])];
    const Eigen::Vector3d n = (hull.points[at(t[1])] - a).cross(hull.points[at(t[2])] - a);
    const double face = n.dot(a - centre);
    if (!(face > 0.0)) return 0.0;  // the centre is not inside
    double far = 0.0;
    for (const Eigen::Vector3d& point : points) far = std::max(far, n.dot(point - centre));
    most = std::max(most, far / face);
  }
  return most;
}

}  // namespace

std::optional<TriangleMesh> coarse_hull(const TriangleMesh& mesh) {
  if (mesh.triangles.size() <= at(kFineTriangles)) return std::nullopt;
  std::vector<Eigen::Vector3d> chosen;
  Eigen::Vector3d low = mesh.points.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& point : mesh.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  // As seen in a box of equal edges, so that long things get as many corners at their ends.
  const Eigen::Vector3d edge = (high - low).cwiseMax(1e-3 * (high - low).maxCoeff());
  if (!(edge.minCoeff() > 0.0)) return std::nullopt;
  for (int i = 0; i < kHullDirections; ++i) {
    const Eigen::Vector3d d = hull_direction(i).cwiseQuotient(edge);
    chosen.push_back(*std::max_element(
        mesh.points.begin(), mesh.points.end(),
        [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return d.dot(a) < d.dot(b); }));
  }
  TriangleMesh few = convex_hull(chosen);
  if (few.triangles.empty()) return std::nullopt;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : few.points) centre += point;
  centre /= static_cast<double>(few.points.size());
  const double grow = kHullRoom * growth(few, centre, mesh.points);
  if (!(grow >= 1.0 && grow < kMostGrowth)) return std::nullopt;
  for (Eigen::Vector3d& point : few.points) point = centre + grow * (point - centre);
  return few;
}

}  // namespace twinbus
