// Triangle sets for contact tests and benches: cubes, slabs and spheres of any fineness.

#pragma once

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/mesh/mesh_file.h"

namespace twinbus::test {

// A box about the origin: 12 triangles facing outwards.
inline TriangleMesh box_triangles(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d side(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    mesh.points.push_back(side.cwiseProduct(size));
  }
  const std::array<std::array<int, 4>, 6> sides = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& s : sides) {
    mesh.triangles.push_back({s[0], s[1], s[2]});
    mesh.triangles.push_back({s[0], s[2], s[3]});
  }
  return mesh;
}

// Every triangle in four, at the middles of its edges.
inline TriangleMesh split(const TriangleMesh& mesh) {
  TriangleMesh fine;
  fine.points = mesh.points;
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, fresh] =
        middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.points.size()));
    if (fresh) {
      fine.points.push_back(0.5 * (mesh.points[static_cast<std::size_t>(a)] +
                                   mesh.points[static_cast<std::size_t>(b)]));
    }
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({ab, b, bc});
    fine.triangles.push_back({ca, bc, c});
    fine.triangles.push_back({ab, bc, ca});
  }
  return fine;
}

// A cube split `times` and its corners moved out to the sphere: 12 4^times triangles.
inline TriangleMesh sphere_triangles(double radius, int times) {
  TriangleMesh mesh = box_triangles(Eigen::Vector3d::Ones());
  for (int i = 0; i < times; ++i) mesh = split(mesh);
  for (Eigen::Vector3d& point : mesh.points) point *= radius / point.norm();
  return mesh;
}

}  // namespace twinbus::test
