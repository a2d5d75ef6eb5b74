#include "geometry/distance/mesh_distance.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// A closed star of many corners: bumps and hollows, so that hulls say little.
TriangleMesh star(double size, std::mt19937_64& random) {
  Shape ball;
  ball.kind = ShapeKind::kSphere;
  ball.size = Vector3d(size, 0.0, 0.0);
  double outside = 0.0;
  TriangleMesh mesh = welded(shape_mesh(ball, outside));
  std::uniform_real_distribution<double> share(0.4, 1.0);
  for (Vector3d& p : mesh.points) p *= share(random);
  return mesh;
}

Isometry3d pose(double far, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Isometry3d result = Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random))
                        .normalized()
                        .toRotationMatrix();
  result.translation() = far * Vector3d(unit(random), unit(random), unit(random)).normalized();
  return result;
}

// Every triangle against every other, by another method.
double slowly(const TriangleMesh& a, const Isometry3d& pose_a, const TriangleMesh& b,
              const Isometry3d& pose_b) {
  const auto shapes = [](const TriangleMesh& mesh) {
    std::vector<GjkShape> result;
    for (const auto& t : mesh.triangles)
      result.push_back(
          gjk_hull({mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]}));
    return result;
  };
  double best = 1e3;
  const std::vector<GjkShape> of_b = shapes(b);
  for (const GjkShape& x : shapes(a)) {
    for (const GjkShape& y : of_b) {
      const GjkResult r = gjk_distance(x, pose_a, y, pose_b, best);
      if (r.below <= best) best = std::min(best, r.distance);
    }
  }
  return best;
}

TEST(MeshDistance, IsThatOfTheNearestTriangles) {
  std::mt19937_64 random(3);
  int touching = 0, apart = 0;
  for (int round = 0; round < 4; ++round) {
    const TriangleMesh a = star(0.2, random), b = star(0.1, random);
    const ClusteredMesh ca(a), cb(b);
    MeshDistance distance;
    distance.reserve(ca);
    distance.reserve(cb);
    MeshMemory memory;
    for (int i = 0; i < 12; ++i) {
      const Isometry3d pa = pose(1.0, random);
      const Isometry3d pb = pa * pose(0.12 + 0.02 * i, random);
      const double expected = slowly(a, pa, b, pb);
      MeshGap gap, fresh;
      MeshMemory nothing;
      ASSERT_TRUE(distance.between(ca, pa, cb, pb, 1.0, 0.0, memory, gap));
      ASSERT_TRUE(distance.between(ca, pa, cb, pb, 1.0, 0.0, nothing, fresh));
      EXPECT_NEAR(gap.distance, expected, 1e-6);
      EXPECT_NEAR(fresh.distance, expected, 1e-6);
      (gap.distance > 0.0 ? apart : touching) += 1;
      if (!(gap.distance > 0.0)) continue;
      EXPECT_NEAR((gap.point_a - gap.point_b).norm(), gap.distance, 1e-9);
      EXPECT_TRUE(distance.between(ca, pa, cb, pb, expected + 1e-5, 0.0, memory, gap));
      EXPECT_FALSE(distance.between(ca, pa, cb, pb, expected - 1e-5, 0.0, memory, gap));
    }
  }
  EXPECT_GT(touching, 5);
  EXPECT_GT(apart, 10);
}

TEST(MeshDistance, OfAMeshAndARoundShape) {
  std::mt19937_64 random(5);
  const TriangleMesh a = star(0.2, random);
  const ClusteredMesh ca(a);
  MeshDistance distance;
  distance.reserve(ca);
  for (const ShapeKind kind : {ShapeKind::kBox, ShapeKind::kSphere, ShapeKind::kCylinder}) {
    GjkShape b;
    b.kind = kind;
    b.half = Vector3d(0.05, 0.07, 0.04);
    MeshMemory memory;
    for (int i = 0; i < 12; ++i) {
      const Isometry3d pa = pose(1.0, random), pb = pa * pose(0.2 + 0.02 * i, random);
      double expected = 1e3;
      for (const auto& t : a.triangles) {
        const GjkShape one = gjk_hull({a.points[at(t[0])], a.points[at(t[1])], a.points[at(t[2])]});
        expected = std::min(expected, gjk_distance(one, pa, b, pb, 10.0).distance);
      }
      MeshGap gap;
      ASSERT_TRUE(distance.between(ca, pa, b, pb, 1.0, memory, gap));
      EXPECT_NEAR(gap.distance, expected, 2e-6);
    }
  }
}

// Also where the mesh lies inside the hull, far from its middle.
TEST(MeshDistance, OfAMeshAndAHull) {
  std::mt19937_64 random(9);
  MeshDistance distance;
  const TriangleMesh a = star(0.03, random), b = star(0.2, random);
  const ClusteredMesh mesh(a);
  distance.reserve(mesh);
  const GjkShape hull = gjk_hull(b.points);
  int touching = 0;
  for (int i = 0; i < 200; ++i) {
    const Isometry3d pose_a = pose(0.05 + 0.001 * i, random), pose_b = pose(0.0, random);
    double expected = 1e3;
    for (const auto& t : a.triangles) {
      const GjkShape one = gjk_hull({a.points[at(t[0])], a.points[at(t[1])], a.points[at(t[2])]});
      expected = std::min(expected, gjk_distance(one, pose_a, hull, pose_b, 1e3).distance);
    }
    touching += expected > 0.0 ? 0 : 1;
    for (const double below : {0.001, 0.01, 1.0}) {
      MeshMemory memory;
      MeshGap gap;
      ASSERT_EQ(distance.between(mesh, pose_a, hull, pose_b, below, memory, gap), expected < below)
          << i << ": " << expected << " m, below " << below;
      if (expected < below) {
        EXPECT_NEAR(gap.distance, expected, 1e-6) << i;
      }
    }
  }
  EXPECT_GT(touching, 30);
}

TEST(MeshDistance, AllocatesNothing) {
  std::mt19937_64 random(8);
  const ClusteredMesh ca(star(0.2, random)), cb(star(0.1, random));
  MeshDistance distance;
  distance.reserve(ca);
  distance.reserve(cb);
  const Isometry3d pa = pose(0.0, random), pb = pose(0.3, random);
  GjkShape box;
  box.kind = ShapeKind::kBox;
  box.half = Vector3d(0.1, 0.1, 0.1);
  const NoAlloc no_alloc;
  MeshMemory memory, other;
  MeshGap gap;
  distance.between(ca, pa, cb, pb, 1.0, 0.0, memory, gap);
  distance.between(ca, pa, box, pb, 1.0, other, gap);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus
