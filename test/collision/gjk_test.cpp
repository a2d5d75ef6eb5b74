#include "geometry/distance/gjk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/distance/convex_shape.h"
#include "geometry/distance/support_cells.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

GjkShape gjk_shape(ShapeKind kind, double x, double y = 0.0, double z = 0.0) {
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
  const GjkShape ball = gjk_shape(ShapeKind::kSphere, 0.2);
  const GjkShape box = gjk_shape(ShapeKind::kBox, 0.3, 0.3, 0.3);
  const GjkShape can = gjk_shape(ShapeKind::kCylinder, 0.1, 0.4);
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
  const std::vector<GjkShape> shapes{gjk_shape(ShapeKind::kSphere, 0.1),
                                     gjk_shape(ShapeKind::kBox, 0.1, 0.05, 0.2),
                                     gjk_shape(ShapeKind::kCylinder, 0.06, 0.15)};
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
  const GjkShape box = gjk_shape(ShapeKind::kBox, 0.1, 0.05, 0.2);
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
  const GjkShape tube = gjk_shape(ShapeKind::kCylinder, 0.05, 0.2);
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

// Corners of lumps, prisms with many corners in one plane, slabs a micrometre thick, needles and tetrahedra.
std::vector<Vector3d> corners(std::mt19937_64& random, int kind) {
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points;
  const auto n = [&] { return 0.1 * normal(random); };
  if (kind == 0) {
    for (int i = 0; i < 40; ++i) points.emplace_back(0.1 * Vector3d(n(), n(), n()).normalized());
  } else if (kind == 1) {
    for (int i = 0; i < 24; ++i) {
      const double angle = std::numbers::pi / 6.0 * i, z = i < 12 ? 0.1 : -0.1;
      points.emplace_back(0.05 * std::cos(angle), 0.05 * std::sin(angle), z);
    }
  } else if (kind == 2) {
    for (int i = 0; i < 20; ++i) points.emplace_back(n(), n(), (i % 2) * 1e-6);
  } else if (kind == 3) {
    for (int i = 0; i < 10; ++i) points.emplace_back(n(), 0.0, i % 3 == 0 ? 1e-9 : 0.0);
  } else {
    for (int i = 0; i < 4; ++i) points.emplace_back(n(), n(), n());
  }
  return points;
}

double reach(const std::vector<Vector3d>& points, const Isometry3d& pose, const Vector3d& along) {
  double most = -1e300;
  for (const Vector3d& p : points) most = std::max(most, along.dot(pose * p));
  return most;
}

// Where nothing is known, as of a pose that is no number, they are said to overlap.
TEST(Gjk, APoseThatIsNoNumberEndsTheSearch) {
  std::mt19937_64 random(9);
  const GjkShape hull = gjk_hull(corners(random, 0));
  const Isometry3d here = Isometry3d::Identity();
  Isometry3d nowhere = here;
  nowhere.translation().x() = std::nan("");
  const GjkResult nothing = gjk_distance(hull, here, hull, nowhere, 9.0);
  EXPECT_EQ(nothing.distance, 0.0);
  EXPECT_TRUE(nothing.normal.allFinite());
}

// What is farthest is in the cell of the direction, also where many are equally far.
TEST(Gjk, CellsLeaveOutNothingThatIsFarthest) {
  std::mt19937_64 random(10);
  std::normal_distribution<double> normal;
  for (int kind = 0; kind < 4; ++kind) {
    const std::vector<Vector3d> points = corners(random, kind);
    const SupportCells cells = support_cells(points);
    ASSERT_EQ(cells.numbers.size(), cells.begin.back());
    for (int i = 0; i < 20000; ++i) {
      Vector3d d(normal(random), normal(random), normal(random));
      if (i % 3 == 0) d[i % 2] = 0.0;
      if (i % 7 == 0) d = (10.0 * d).array().round();
      if (d.isZero(0.0)) continue;
      d.normalize();
      int axis = 0;
      const double largest = d.cwiseAbs().maxCoeff(&axis);
      const auto half = [&](int k) { return 2.0 * std::abs(d[(axis + k) % 3]) >= largest ? 1 : 0; };
      const int cell = 48 * half(2) + 24 * half(1) + 8 * axis + (std::signbit(d[0]) ? 1 : 0) +
                       (std::signbit(d[1]) ? 2 : 0) + (std::signbit(d[2]) ? 4 : 0);
      const double* x = cells.points(static_cast<std::size_t>(cell));
      double most = -1e300;
      const std::size_t row = cells.size(static_cast<std::size_t>(cell));
      ASSERT_LT(row, points.size());
      for (std::size_t k = 0; k < row; ++k)
        most = std::max(most, d.dot(Vector3d(x[k], x[row + k], x[2 * row + k])));
      ASSERT_NEAR(most, reach(points, Isometry3d::Identity(), d), 1e-10);
    }
  }
}

// More corners than have cells.
TEST(Gjk, AHullOfVeryManyCornersIsSearchedWhole) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> many;
  for (int i = 0; i < 1500; ++i)
    many.push_back(0.1 * Vector3d(normal(random), normal(random), normal(random)).normalized());
  const GjkShape ball = gjk_hull(many);
  EXPECT_TRUE(ball.cells.empty());
  for (int i = 0; i < 200; ++i) {
    const Isometry3d a = somewhere(random, 0.3), b = somewhere(random, 0.3);
    const GjkResult r = gjk_distance(ball, a, ball, b, 9.0);
    if (!(r.distance > 0.0)) continue;
    EXPECT_NEAR(-reach(many, b, -r.normal) - reach(many, a, r.normal), r.distance, 2e-7) << i;
  }
}

// Nearly all corners in one cell: a fine lens on a long body.
TEST(Gjk, ManyCornersInOneDirectionAreAllSeen) {
  std::vector<Vector3d> points;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 20; ++k) {
      const double x = 2e-3 * (i + 0.5), y = 2e-3 * (k + 0.5);
      points.emplace_back(x, y, 0.1 - 0.1 * (x * x + y * y));
    }
  }
  for (const double x : {-0.2, 0.3}) points.emplace_back(x, -0.1, -0.3);
  points.emplace_back(0.0, 0.4, -0.3);
  const GjkShape lens = gjk_hull(points);
  std::mt19937_64 random(12);
  std::vector<Isometry3d> poses(400);
  for (Isometry3d& pose : poses) pose = somewhere(random, 0.4);
  int apart = 0;
  for (std::size_t k = 0; k < poses.size(); k += 2) {
    const GjkResult r = gjk_distance(lens, poses[k], lens, poses[k + 1], 9.0);
    if (!(r.distance > 1e-7)) continue;
    ++apart;
    EXPECT_NEAR(-reach(points, poses[k + 1], -r.normal) - reach(points, poses[k], r.normal), r.distance, 1e-6);
  }
  EXPECT_GT(apart, 50);
}

TEST(Gjk, StopsEarlyWhenFarAway) {
  Isometry3d there = Isometry3d::Identity();
  there.translation() = Vector3d(0.3, 0.4, 1.0);
  const GjkShape box = gjk_shape(ShapeKind::kBox, 0.1, 0.1, 0.1);
  const GjkResult r = gjk_distance(box, Isometry3d::Identity(), box, there, 0.1);
  EXPECT_GT(r.below, 0.1);
  EXPECT_LE(r.below, gjk_distance(box, Isometry3d::Identity(), box, there, 9.0).distance + 1e-12);
}

}  // namespace
}  // namespace twinbus
