#include "geometry/bounds/coarse_mesh.h"

#include <random>

#include "fixtures.h"

namespace twinbus::test {
namespace {

double outside(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double most = -1e300;
  for (const auto& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
    const Eigen::Vector3d n =
        (corner(1) - corner(0)).cross(Eigen::Vector3d(corner(2) - corner(0))).normalized();
    most = std::max(most, n.dot(point - corner(0)));
  }
  return most;
}

TEST(CoarseMesh, HoldsEveryPointWithFewTriangles) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (const Eigen::Vector3d& size :
       {Eigen::Vector3d(0.1, 0.1, 0.1), Eigen::Vector3d(0.4, 0.05, 0.02)}) {
    TriangleMesh mesh;  // an egg full of points
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Vector3d d(normal(random), normal(random), normal(random));
      mesh.points.push_back(size.cwiseProduct(d.normalized()));
      if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
    }
    const TriangleMesh coarse = coarse_hull(mesh).value();
    EXPECT_LE(coarse.points.size(), static_cast<std::size_t>(kMostCorners));
    EXPECT_GT(coarse.triangles.size(), 30u);
    double worst = -1e300;
    for (const Eigen::Vector3d& point : mesh.points)
      worst = std::max(worst, outside(coarse, point));
    EXPECT_LE(worst, 1e-9);
    for (const Eigen::Vector3d& point : coarse.points)
      EXPECT_LT(point.cwiseQuotient(size).norm(), 1.08);
    EXPECT_TRUE(holds(coarse, mesh.points));
    EXPECT_FALSE(holds(coarse, {2.0 * size}));
  }
}

double farthest(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& along) {
  double most = -1e300;
  for (const Eigen::Vector3d& p : points) most = std::max(most, along.dot(p));
  return most;
}

// A shank: a bent plate with a round boss.  A hull that is scaled about its middle grows by centimetres here.
TEST(CoarseMesh, IsNowhereMuchLargerThanTheHull) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  TriangleMesh mesh;
  for (int i = 0; i < 4000; ++i) {
    const double u = uniform(random), v = uniform(random);
    if (i % 4 == 0) {
      const Eigen::Vector3d d(uniform(random), uniform(random), uniform(random));
      mesh.points.push_back(Eigen::Vector3d(0.02, 0.0, 0.2) + 0.05 * d.normalized());
    } else {
      mesh.points.emplace_back(0.03 * u * u, 0.06 * u, 0.25 * v);
    }
    if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  const TriangleMesh coarse = coarse_hull(mesh).value();
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d n = Eigen::Vector3d(uniform(random), uniform(random), uniform(random)).normalized();
    const double more = farthest(coarse.points, n) - farthest(mesh.points, n);
    EXPECT_GE(more, -1e-9);
    EXPECT_LE(more, 1.5e-3);
  }
}

TEST(CoarseMesh, LeavesFewTrianglesAndFlatThingsAsTheyAre) {
  TriangleMesh flat;
  for (int i = 0; i < 200; ++i) {
    flat.points.emplace_back(std::cos(0.1 * i), std::sin(0.1 * i), 0.0);
    if (i >= 2) flat.triangles.push_back({0, i - 1, i});
  }
  EXPECT_FALSE(coarse_hull(flat));
  flat.points[0].z() = 1.0;  // a cone now
  EXPECT_TRUE(coarse_hull(flat));
  flat.triangles.resize(50);
  EXPECT_FALSE(coarse_hull(flat));
}

}  // namespace
}  // namespace twinbus::test
