#include "sim/world/link_hull.h"

#include <algorithm>

#include "geometry/bounds/convex_hull.h"
#include "geometry/bounds/shape_mesh.h"

namespace twinbus {

namespace {

constexpr double kThinnest = 1e-3;  // [m]

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

}  // namespace twinbus
