#include "geometry/bounds/shape_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>

namespace twinbus::inline geometry {

namespace {

using Eigen::Vector3d;

constexpr int kCylinderSides = 32;  // of a cylinder
constexpr int kHalvings = 2;        // of the edges of an icosahedron: 320 triangles
constexpr double kWeld = 1e-6;      // [m]

TriangleMesh box(const Vector3d& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.emplace_back((i & 1) != 0 ? 0.5 * size.x() : -0.5 * size.x(),
                             (i & 2) != 0 ? 0.5 * size.y() : -0.5 * size.y(),
                             (i & 4) != 0 ? 0.5 * size.z() : -0.5 * size.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

// A prism whose sides touch the cylinder.
TriangleMesh cylinder(double radius, double length, double& outside) {
  const double corner = radius / std::cos(std::numbers::pi / kCylinderSides);
  outside = std::max(outside, corner - radius);
  TriangleMesh mesh;
  for (const double z : {-0.5 * length, 0.5 * length}) {
    for (int i = 0; i < kCylinderSides; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kCylinderSides;
      mesh.points.emplace_back(corner * std::cos(turn), corner * std::sin(turn), z);
    }
  }
  for (int i = 0; i < kCylinderSides; ++i) {
    const int next = (i + 1) % kCylinderSides;
    mesh.triangles.push_back({i, next, kCylinderSides + i});
    mesh.triangles.push_back({next, kCylinderSides + next, kCylinderSides + i});
    if (i < 2) continue;
    mesh.triangles.push_back({0, i, i - 1});
    mesh.triangles.push_back({kCylinderSides, kCylinderSides + i - 1, kCylinderSides + i});
  }
  return mesh;
}

// An icosahedron, halved and blown up until its faces touch the sphere.
TriangleMesh sphere(double radius, double& outside) {
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  TriangleMesh mesh;
  for (const double s : {1.0, -1.0}) {
    for (const double t : {g, -g}) {
      mesh.points.emplace_back(s, t, 0.0);
      mesh.points.emplace_back(0.0, s, t);
      mesh.points.emplace_back(t, 0.0, s);
    }
  }
  for (Vector3d& point : mesh.points) point.normalize();
  for (int a = 0; a < 12; ++a) {
    for (int b = a + 1; b < 12; ++b) {
      for (int c = b + 1; c < 12; ++c) {
        const auto p = [&](int i) -> const Vector3d& {
          return mesh.points[static_cast<std::size_t>(i)];
        };
        constexpr double kEdge = 0.44;  // cosine of the angle of an edge is 0.447
        if (!(p(a).dot(p(b)) > kEdge && p(b).dot(p(c)) > kEdge && p(c).dot(p(a)) > kEdge)) continue;
        const bool left = (p(b) - p(a)).cross(p(c) - p(a)).dot(p(a)) > 0.0;
        mesh.triangles.push_back({a, left ? b : c, left ? c : b});
      }
    }
  }
  for (int halving = 0; halving < kHalvings; ++halving) {
    std::map<std::array<int, 2>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto found = middles.emplace(std::array<int, 2>{std::min(a, b), std::max(a, b)},
                                         static_cast<int>(mesh.points.size()));
      if (found.second) {
        const Vector3d sum =
            mesh.points[static_cast<std::size_t>(a)] + mesh.points[static_cast<std::size_t>(b)];
        mesh.points.push_back(sum.normalized());
      }
      return found.first->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  double nearest = 1.0;  // face to the centre
  for (const auto& t : mesh.triangles) {
    const Vector3d& a = mesh.points[static_cast<std::size_t>(t[0])];
    const Vector3d& b = mesh.points[static_cast<std::size_t>(t[1])];
    const Vector3d& c = mesh.points[static_cast<std::size_t>(t[2])];
    nearest = std::min(nearest, (b - a).cross(c - a).normalized().dot(a));
  }
  for (Vector3d& point : mesh.points) point *= radius / nearest;
  outside = std::max(outside, radius / nearest - radius);
  return mesh;
}

}  // namespace

TriangleMesh shape_mesh(const Shape& shape, double& outside) {
  TriangleMesh mesh;
  switch (shape.kind) {
    case ShapeKind::kBox:
      mesh = box(shape.size);
      break;
    case ShapeKind::kSphere:
      mesh = sphere(shape.size.x(), outside);
      break;
    case ShapeKind::kCylinder:
      mesh = cylinder(shape.size.x(), shape.size.y(), outside);
      break;
    case ShapeKind::kMesh:
      mesh = load_mesh(shape.mesh, shape.size);
      break;
  }
  for (Vector3d& point : mesh.points) point = shape.pose * point;
  return mesh;
}

void append(const TriangleMesh& more, TriangleMesh& mesh) {
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), more.points.begin(), more.points.end());
  for (const auto& [a, b, c] : more.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
}

namespace {

using Place = std::array<std::int64_t, 3>;  // on the grid of kWeld

struct PlaceHash {
  std::size_t operator()(const Place& p) const noexcept {
    std::uint64_t h = 0;
    for (const std::int64_t k : p) {
      h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15U;
      h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
  }
};

}  // namespace

TriangleMesh welded(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::unordered_map<Place, int, PlaceHash> seen;
  seen.reserve(mesh.points.size());
  std::vector<int> now(mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    Place key;
    for (std::size_t k = 0; k < 3; ++k)
      key[k] = std::llround(mesh.points[i][static_cast<int>(k)] / kWeld);
    const auto found = seen.emplace(key, static_cast<int>(result.points.size()));
    if (found.second) result.points.push_back(mesh.points[i]);
    now[i] = found.first->second;
  }
  for (const auto& t : mesh.triangles) {
    const int a = now[static_cast<std::size_t>(t[0])];
    const int b = now[static_cast<std::size_t>(t[1])];
    const int c = now[static_cast<std::size_t>(t[2])];
    if (a != b && b != c && c != a) result.triangles.push_back({a, b, c});
  }
  return result;
}

}  // namespace twinbus::geometry
