#include "geometry/bounds/triangle_clusters.h"

#include <algorithm>
#include <numeric>

#include "common/math/index.h"
#include "geometry/bounds/bounds.h"

namespace twinbus::inline geometry {

namespace {

using Eigen::Vector3d;

constexpr double kGrowBox = 1e-6;  // [m]

const Vector3d& corner(const TriangleMesh& mesh, int triangle, std::size_t k) {
  return mesh.points[at(mesh.triangles[at(triangle)][k])];
}

Vector3d middle(const TriangleMesh& mesh, int t) {
  return (corner(mesh, t, 0) + corner(mesh, t, 1) + corner(mesh, t, 2)) / 3.0;
}

void store(const Vector3d& v, float (&to)[3]) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(v[k]);
}

// Halves near the median of the longest axis until 16 are left, by whole clusters, so that all but one are full.
void split(const TriangleMesh& mesh, int* first, int count, std::vector<TriangleCluster>& out) {
  constexpr int kLanes = TriangleCluster::kLanes;
  if (count <= kLanes) {
    out.push_back(triangle_cluster(mesh, first, count, nullptr));
    return;
  }
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (int i = 0; i < count; ++i) {
    low = low.cwiseMin(middle(mesh, first[i]));
    high = high.cwiseMax(middle(mesh, first[i]));
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const int half = std::max(1, (count + kLanes) / (2 * kLanes)) * kLanes;
  std::nth_element(first, first + half, first + count,
                   [&](int a, int b) { return middle(mesh, a)[axis] < middle(mesh, b)[axis]; });
  split(mesh, first, half, out);
  split(mesh, first + half, count - half, out);
}

}  // namespace

TriangleCluster triangle_cluster(const TriangleMesh& mesh, const int* triangles, int count,
                                 const Ball* sphere) {
  TriangleCluster c{};
  c.count = count;
  std::vector<Vector3d> points;
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (int lane = 0; lane < TriangleCluster::kLanes; ++lane) {
    const int t = triangles[std::min(lane, count - 1)];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& p = corner(mesh, t, k);
      points.push_back(p);
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      for (int d = 0; d < 3; ++d) c.corner[k][d][lane] = static_cast<float>(p[d]);
    }
    const Vector3d& a = corner(mesh, t, 0);
    const Vector3d normal = (corner(mesh, t, 1) - a).cross(corner(mesh, t, 2) - a);
    // The normal of a sliver says nothing: it is left zero and cuts nothing off.
    const bool flat = normal.norm() > 1e-12;
    const Vector3d unit = flat ? normal.normalized() : Vector3d::Zero();
    for (int d = 0; d < 3; ++d) c.normal[d][lane] = static_cast<float>(unit[d]);
    c.offset[lane] = static_cast<float>(unit.dot(a));
  }
  Ball found;
  if (sphere == nullptr) {
    found = ball_around(points, 400);
    found.radius += kGrowTriangleCluster;
    sphere = &found;
  }
  store(sphere->center, c.center);
  c.radius = static_cast<float>(sphere->radius);
  store(low.array() - kGrowBox, c.low);
  store(high.array() + kGrowBox, c.high);
  return c;
}

std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh, std::vector<int>& order) {
  order.resize(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<TriangleCluster> clusters;
  split(mesh, order.data(), static_cast<int>(order.size()), clusters);
  return clusters;
}

std::vector<TriangleCluster> triangle_clusters(const TriangleMesh& mesh) {
  std::vector<int> order;
  return triangle_clusters(mesh, order);
}

}  // namespace twinbus::geometry
