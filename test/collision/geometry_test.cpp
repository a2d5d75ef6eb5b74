#include "robot/collision/links/link_geometry.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "geometry/bounds/bounds.h"
#include "geometry/bounds/convex_hull.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "geometry/bounds/shape_mesh.h"

namespace twinbus {
namespace {

using Eigen::Vector3d;

Shape shape(ShapeKind kind, double x, double y, double z) {
  Shape s;
  s.kind = kind;
  s.size = Vector3d(x, y, z);
  s.pose =
      Eigen::Translation3d(0.1, -0.2, 0.3) * Eigen::Quaterniond(0.5, 0.1, -0.7, 0.2).normalized();
  return s;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles)
    sum += mesh.points[at(t[0])].cross(mesh.points[at(t[1])]).dot(mesh.points[at(t[2])]) / 6.0;
  return sum;
}

TEST(ShapeMesh, IsClosedAndNeverSmallerThanTheShape) {
  double outside = 0.0;
  EXPECT_NEAR(volume(shape_mesh(shape(ShapeKind::kBox, 1.0, 2.0, 3.0), outside)), 6.0, 1e-12);
  EXPECT_EQ(outside, 0.0);
  const double cylinder = volume(shape_mesh(shape(ShapeKind::kCylinder, 0.1, 0.4, 0.0), outside));
  EXPECT_GT(cylinder, 0.1 * 0.1 * 0.4 * M_PI);
  EXPECT_LT(cylinder, 0.1 * 0.1 * 0.4 * M_PI * 1.004);
  EXPECT_NEAR(outside, 0.1 * 0.0049, 1e-5);
  const double sphere = volume(shape_mesh(shape(ShapeKind::kSphere, 0.1, 0.0, 0.0), outside));
  EXPECT_GT(sphere, 4.0 / 3.0 * M_PI * 1e-3);
  EXPECT_LT(sphere, 4.0 / 3.0 * M_PI * 1e-3 * 1.05);
}

TEST(ConvexHull, HoldsEveryPointAndKeepsOnlyCorners) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points;
  for (int i = 0; i < 2000; ++i)
    points.emplace_back(normal(random), normal(random), normal(random));
  const TriangleMesh hull = convex_hull(points);
  ASSERT_FALSE(hull.triangles.empty());
  EXPECT_EQ(hull.triangles.size(), 2 * hull.points.size() - 4);
  for (const auto& t : hull.triangles) {
    const Vector3d& a = hull.points[at(t[0])];
    const Vector3d n = (hull.points[at(t[1])] - a).cross(hull.points[at(t[2])] - a).normalized();
    for (const Vector3d& p : points) ASSERT_LE(n.dot(p - a), 1e-7);
  }
  double outside = 0.0;
  TriangleMesh box = shape_mesh(shape(ShapeKind::kBox, 0.1, 0.2, 0.3), outside);
  for (int i = 0; i < 300; ++i) {  // points on faces and inside
    const auto& t = box.triangles[at(i % 12)];
    box.points.push_back(
        (box.points[at(t[0])] + box.points[at(t[1])] + 0.5 * box.points[at(t[2])]) / 2.5);
  }
  const TriangleMesh corners = convex_hull(box.points);
  EXPECT_NEAR(volume(corners), 0.006, 1e-9);
  EXPECT_LE(corners.points.size(), 12U);
}

TEST(BallInside, IsInsideAndLarge) {
  double outside = 0.0;
  const Ball of_box = ball_inside(shape_mesh(shape(ShapeKind::kBox, 0.1, 0.2, 0.3), outside));
  EXPECT_NEAR(of_box.radius, 0.05, 1e-6);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 20; ++i) {
    std::vector<Vector3d> points;
    for (int k = 0; k < 4 + 10 * i; ++k) points.push_back(any() + Vector3d(3.0, 0.0, 0.0));
    const Ball ball = ball_inside(convex_hull(points));
    EXPECT_GT(ball.radius, 0.0);
    for (int k = 0; k < 300; ++k) {
      const Vector3d n = any().normalized();
      double reach = -1e300;
      for (const Vector3d& p : points) reach = std::max(reach, n.dot(p));
      ASSERT_GE(reach, n.dot(ball.center) + ball.radius - 1e-6);
    }
  }
  EXPECT_EQ(ball_inside(convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})).radius, 0.0);
}

TEST(ConvexHull, OfFlatOrFewPointsIsThePoints) {
  const std::vector<Vector3d> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}};
  EXPECT_EQ(convex_hull(flat).points.size(), flat.size());
  EXPECT_TRUE(convex_hull(flat).triangles.empty());
  EXPECT_TRUE(convex_hull({}).points.empty());
}

TEST(Geometry, EveryBoundOfARobotHoldsEveryTriangle) {
  const Model model = load_robot("hrp1s");
  const RobotGeometry robot = build_geometry(model);
  ASSERT_GT(robot.links.size(), 15U);
  for (const LinkGeometry& g : robot.links) {
    EXPECT_NO_THROW(verify(g));
    EXPECT_EQ(robot.of_link[at(g.link)], &g - robot.links.data());
    EXPECT_FALSE(g.parts.empty());
  }
}

TEST(Geometry, AWrongBoundIsNamed) {
  const LinkGeometry good = link_geometry({shape(ShapeKind::kCylinder, 0.05, 0.3, 0.0)});
  LinkGeometry bad = good;
  bad.capsule.radius *= 0.99;
  EXPECT_THROW(verify(bad), std::runtime_error);
  bad = good;
  bad.clusters.pop_back();
  EXPECT_THROW(verify(bad), std::runtime_error);
}

TEST(Geometry, NothingHasNoTriangles) { EXPECT_TRUE(link_geometry({}).mesh.triangles.empty()); }

// A plate of many thousand corners, turned and stored as single precision: faces that are nearly flat
// in every direction leave a tolerance undecided.
TEST(ConvexHull, OfNearlyFlatMeshesIsClosed) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const double bump : {0.0, 1e-10, 1e-9, 1e-8, 3e-8, 1e-7, 1e-6, 1e-5}) {
    // One after the other, so that every compiler turns it alike.
    const double w = unit(random), x = unit(random), y = unit(random), z = unit(random);
    const Eigen::Quaterniond turn = Eigen::Quaterniond(w, x, y, z).normalized();
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 4000; ++i) {
      const double along = unit(random), across = unit(random), up = unit(random);
      const Eigen::Vector3d p(0.1 * std::round(8.0 * along), 0.1 * across, (i % 2 == 0 ? 0.01 : -0.01) + bump * up);
      points.push_back((turn * p).cast<float>().cast<double>());
    }
    const TriangleMesh hull = convex_hull(points);
    ASSERT_FALSE(hull.triangles.empty()) << bump;
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : hull.triangles) {
      for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
      const Eigen::Vector3d& a = hull.points[at(t[0])];
      const Eigen::Vector3d n = (hull.points[at(t[1])] - a).cross(hull.points[at(t[2])] - a);
      for (const Eigen::Vector3d& p : points) EXPECT_LE(n.dot(p - a), 1e-6 * n.norm() + 1e-12);
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
    }
  }
}

}  // namespace
}  // namespace twinbus
