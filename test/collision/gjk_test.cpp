#include "robot/gjk.h"

#include <gtest/gtest.h>

#include <random>

#include "robot/convex_shape.h"
#include "test/no_alloc.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

GjkShape shape(ShapeKind kind, double x, double y = 0.0, double z = 0.0) {
  GjkShape s;
  s.kind = kind;
  s.half = Vector3d(x, y, z);
  return s;
}

Isometry3d somewhere(std::mt19937_64& random, double spread) {
  std::normal_distribution<double> normal;
  const auto n = [&] { return normal(random); };
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(n(), n(), n(), n()).normalized().toRotationMatrix();
  pose.translation() = spread * Vector3d(n(), n(), n());
  return pose;
}

GjkShape box_as_points(const Vector3d& half) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                        (i & 4) != 0 ? half.z() : -half.z());
  return gjk_hull(points);
}

TEST(Gjk, KnownDistances) {
  const Isometry3d here = Isometry3d::Identity();
  Isometry3d there = here;
  there.translation() = Vector3d(0.0, 0.0, 1.0);
  const GjkShape ball = shape(ShapeKind::kSphere, 0.2);
  const GjkShape box = shape(ShapeKind::kBox, 0.3, 0.3, 0.3);
  const GjkShape can = shape(ShapeKind::kCylinder, 0.1, 0.4);
  EXPECT_NEAR(gjk_distance(ball, here, ball, there, 9.0).distance, 0.6, 1e-12);
  EXPECT_NEAR(gjk_distance(ball, here, box, there, 9.0).distance, 0.5, 1e-12);
  EXPECT_NEAR(gjk_distance(box, here, can, there, 9.0).distance, 0.3, 1e-12);
  const GjkResult r = gjk_distance(ball, here, box, there, 9.0);
  EXPECT_NEAR(r.point_a.z(), 0.2, 1e-12);
  EXPECT_NEAR(r.point_b.z(), 0.7, 1e-12);
  EXPECT_NEAR(r.normal.z(), 1.0, 1e-12);
  EXPECT_EQ(gjk_distance(box, here, box, here, 9.0).distance, 0.0);
}

// The separation along the normal is a proof from below; points and their distance are one from above.
TEST(Gjk, EveryDistanceIsProvedFromBothSides) {
  std::mt19937_64 random(5);
  const std::vector<GjkShape> shapes{shape(ShapeKind::kSphere, 0.1),
                                     shape(ShapeKind::kBox, 0.1, 0.05, 0.2),
                                     shape(ShapeKind::kCylinder, 0.06, 0.15)};
  int apart = 0;
  for (int i = 0; i < 30000; ++i) {
    const GjkShape& a = shapes[static_cast<std::size_t>(i % 3)];
    const GjkShape& b = shapes[static_cast<std::size_t>(i / 3 % 3)];
    const Isometry3d pose_a = somewhere(random, 0.2), pose_b = somewhere(random, 0.2);
    const ConvexShape as{a.kind, a.half}, bs{b.kind, b.half};
    const GjkResult r = gjk_distance(a, pose_a, b, pose_b, 9.0);
    if (r.distance > 0.0) {
      ++apart;
      EXPECT_NEAR((r.point_b - r.point_a).norm(), r.distance, 1e-7) << i;
      EXPECT_NEAR(separation({&as, &pose_a}, {&bs, &pose_b}, r.normal), r.distance, 2e-7) << i;
    } else {
      EXPECT_LT(separation({&as, &pose_a}, {&bs, &pose_b}, way_out({&as, &pose_a}, {&bs, &pose_b})),
                1e-7)
          << i;
    }
  }
  EXPECT_GT(apart, 10000);
}

TEST(Gjk, AHullOfPointsIsAsFarAwayAsTheBox) {
  std::mt19937_64 random(6);
  const GjkShape box = shape(ShapeKind::kBox, 0.1, 0.05, 0.2);
  const GjkShape points = box_as_points(box.half);
  const NoAlloc no_alloc;
  for (int i = 0; i < 10000; ++i) {
    const Isometry3d a = somewhere(random, 0.2), b = somewhere(random, 0.2);
    const double one = gjk_distance(box, a, box, b, 9.0).distance;
    const double two = gjk_distance(points, a, points, b, 9.0).distance;
    EXPECT_NEAR(one, two, 1e-8) << i;
  }
  EXPECT_EQ(no_alloc.count(), 0);
}

TEST(Gjk, EndsAsNearToTheDistanceAsIsAsked) {
  Isometry3d there = Isometry3d::Identity();
  there.linear() = Eigen::AngleAxisd(0.7, Vector3d(0.6, 0.0, 0.8)).toRotationMatrix();
  const GjkShape tube = shape(ShapeKind::kCylinder, 0.05, 0.2);
  double coarsest = 0.0;
  for (int k = 0; k < 50; ++k) {
    there.translation() = Vector3d(0.2 + 0.002 * k, 0.3 - 0.003 * k, 0.1);
    const double exact = gjk_distance(tube, Isometry3d::Identity(), tube, there, 9.0).distance;
    const GjkResult r =
        gjk_distance(tube, Isometry3d::Identity(), tube, there, 9.0, Vector3d::Zero(), 1e-3);
    EXPECT_GE(r.distance, exact - kGjkClose);
    EXPECT_LE(r.distance, exact + 1e-3);
    EXPECT_LE(r.below, exact + kGjkClose);
    coarsest = std::max(coarsest, r.distance - exact);
  }
  EXPECT_GT(coarsest, 1e-6) << "it takes no notice";
}

TEST(Gjk, StopsEarlyWhenFarAway) {
  Isometry3d there = Isometry3d::Identity();
  there.translation() = Vector3d(0.3, 0.4, 1.0);
  const GjkShape box = shape(ShapeKind::kBox, 0.1, 0.1, 0.1);
  const GjkResult r = gjk_distance(box, Isometry3d::Identity(), box, there, 0.1);
  EXPECT_GT(r.below, 0.1);
  EXPECT_LE(r.below, gjk_distance(box, Isometry3d::Identity(), box, there, 9.0).distance + 1e-12);
}

}  // namespace
}  // namespace twinbus
