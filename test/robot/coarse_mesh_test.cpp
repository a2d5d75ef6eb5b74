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
    EXPECT_LE(coarse.triangles.size(), static_cast<std::size_t>(kFineTriangles));
    EXPECT_GT(coarse.triangles.size(), 30u);
    double worst = -1e300;
    for (const Eigen::Vector3d& point : mesh.points)
      worst = std::max(worst, outside(coarse, point));
    EXPECT_LE(worst, 1e-9);
    for (const Eigen::Vector3d& point : coarse.points)
      EXPECT_LT(point.cwiseQuotient(size).norm(), 1.35);
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
