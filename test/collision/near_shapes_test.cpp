#include "geometry/distance/broad_phase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "common/math/index.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using Eigen::Vector3d;

constexpr int kShapes = 37;

// Of two capsules, by halving steps along both segments.
double distance(const Capsule& a, const Capsule& b) {
  double best = 1e9;
  double s = 0.5, r = 0.5;
  for (double step = 0.5; step > 1e-7; step *= 0.7) {
    for (int i = -4; i <= 4; ++i) {
      for (int k = -4; k <= 4; ++k) {
        const double x = std::clamp(s + i * step, 0.0, 1.0);
        const double y = std::clamp(r + k * step, 0.0, 1.0);
        const double d = (a.a + x * (a.b - a.a) - b.a - y * (b.b - b.a)).norm();
        if (!(d < best)) continue;
        best = d;
        s = x;
        r = y;
      }
    }
  }
  return best - a.radius - b.radius;
}

struct Field {
  explicit Field(std::uint64_t seed, const Vector3d& about) : random(seed), pose(at(kShapes)) {
    for (int i = 0; i < kShapes; ++i) {
      Capsule c;
      c.a = 0.2 * point();
      c.b = i % 5 == 0 ? c.a : Vector3d(0.2 * point());  // some are balls
      c.radius = 0.02 + 0.05 * std::abs(point().x());
      local.push_back(c);
    }
    shapes.set(local);
    placed = local;
    for (int i = 0; i < kShapes; ++i) {
      const Vector3d where = about + point();
      const double angle = 3.0 * point().x();
      place(i, Eigen::Translation3d(where) * Eigen::AngleAxisd(angle, point().normalized()), about);
    }
  }
  void place(int i, const Eigen::Isometry3d& to, const Vector3d& about) {
    shapes.place(i, to, about);
    pose[at(i)] = to;
    placed[at(i)].a = to * local[at(i)].a;
    placed[at(i)].b = to * local[at(i)].b;
  }
  Vector3d point() { return {unit(random), unit(random), unit(random)}; }

  std::mt19937_64 random;
  std::uniform_real_distribution<double> unit{-1.0, 1.0};
  NearShapes shapes;
  std::vector<Capsule> local, placed;
  std::vector<Eigen::Isometry3d> pose;
};

TEST(NearShapes, NoBoundIsLargerThanTheDistanceAndFewAreMuchSmaller) {
  for (const Vector3d& about : {Vector3d(0, 0, 0), Vector3d(300, -200, 10)}) {
    Field field(3, about);
    for (int a = 0; a < kShapes; ++a) {
      for (int b = a + 1; b < kShapes; ++b) field.shapes.want(a, b, true);
    }
    const auto found = field.shapes.nearer_than(100.0);
    ASSERT_EQ(found.size(), at(kShapes * (kShapes - 1) / 2));
    for (const NearShapes::Candidate& c : found) {
      const double true_distance = distance(field.placed[at(c.a)], field.placed[at(c.b)]);
      EXPECT_LE(static_cast<double>(c.bound), true_distance) << c.a << " " << c.b;
      EXPECT_GT(static_cast<double>(c.bound), true_distance - 0.02) << c.a << " " << c.b;
    }
  }
}

TEST(NearShapes, ExactlyTheWantedPairsWithinReachAreFoundInOrder) {
  Field field(5, Vector3d::Zero());
  for (int a = 0; a < kShapes; ++a) {
    for (int b = a + 1; b < kShapes; ++b) field.shapes.want(b, a, (a + b) % 3 != 0);
  }
  field.shapes.want(0, 1, false);
  for (const double reach : {-0.01, 0.0, 0.1, 0.5}) {
    const auto found = field.shapes.nearer_than(reach);
    std::size_t next = 0;
    for (int a = 0; a < kShapes; ++a) {
      for (int b = a + 1; b < kShapes; ++b) {
        const bool here = next < found.size() && found[next].a == a && found[next].b == b;
        const bool wanted = (a + b) % 3 != 0 && !(a == 0 && b == 1);
        if (wanted && distance(field.placed[at(a)], field.placed[at(b)]) <= reach) {
          EXPECT_TRUE(here) << a << " " << b << " within " << reach;
        }
        if (!here) continue;
        EXPECT_TRUE(wanted);
        EXPECT_LE(static_cast<double>(found[next].bound), reach);
        ++next;
      }
    }
    EXPECT_EQ(next, found.size());
  }
}

// Shapes walk on for metres, at times in a jump; at times more than what capsules say is known of a pair.
TEST(NearShapes, WhatIsKeptHidesNoPairThatIsNear) {
  constexpr int kKeeping = kShapes - 5;  // the others may be anywhere the next time
  constexpr double kReach = 0.05, kThen = 0.01;
  Field field(9, Vector3d::Zero());
  for (int a = 0; a < kShapes; ++a) {
    for (int b = a + 1; b < kShapes; ++b) field.shapes.want(a, b, (a + b) % 3 != 0);
  }
  field.shapes.keep(kKeeping);
  std::vector<double> travel(at(kShapes));
  long near = 0, listed = 0, looked_at = 0;
  for (int k = 0; k < 1000; ++k) {
    const double step = k % 50 == 49 ? 0.3 : 0.005;
    for (int s = 0; s < kShapes; ++s) {
      const Capsule before = field.placed[at(s)];
      Eigen::Isometry3d pose = Eigen::Translation3d(step * field.point()) * field.pose[at(s)] *
                               Eigen::AngleAxisd(step, field.point().normalized());
      if (pose.translation().norm() > 0.4) pose.translation() *= 0.9;
      if (s >= kKeeping && k % 10 == 0) pose.translation() = 0.4 * field.point();
      field.place(s, pose, Vector3d::Zero());
      const Capsule& now = field.placed[at(s)];
      field.shapes.walk(s, std::max((now.a - before.a).norm(), (now.b - before.b).norm()));
      travel[at(s)] = s % 4 == 0 ? 0.0 : 0.03 * std::abs(field.point().x());
      field.shapes.let_move(s, travel[at(s)]);
    }
    const auto found = field.shapes.nearer_than(kReach, kThen, true);
    listed += static_cast<long>(found.size());
    if (k % 20 != 10) continue;
    std::size_t next = 0;
    for (int a = 0; a < kShapes; ++a) {
      for (int b = a + 1; b < kShapes; ++b) {
        if ((a + b) % 3 == 0) continue;
        const double true_distance = distance(field.placed[at(a)], field.placed[at(b)]);
        const bool here = next < found.size() && found[next].a == a && found[next].b == b;
        if (true_distance <= std::max(kReach, kThen + travel[at(a)] + travel[at(b)])) {
          ++near;
          EXPECT_TRUE(here) << k << ": " << a << " " << b << " are " << true_distance;
        }
        if (here) {
          EXPECT_LE(static_cast<double>(found[next].bound), true_distance);
        }
        next += here ? 1 : 0;
        if (a % 2 == 0) field.shapes.know(a, b, true_distance - 1e-5);
        ++looked_at;
      }
    }
    EXPECT_EQ(next, found.size());
  }
  EXPECT_GT(near, 500);
  EXPECT_LT(listed, looked_at * 20 / 3);  // most are parted by what is kept
}

TEST(NearShapes, AllocatesNothing) {
  Field field(7, Vector3d::Zero());
  for (int a = 0; a < kShapes; ++a) {
    for (int b = a + 1; b < kShapes; ++b) field.shapes.want(a, b, true);
  }
  const NoAlloc no_alloc;
  field.shapes.place(3, Eigen::Isometry3d::Identity(), Vector3d::Zero());
  field.shapes.keep(kShapes);
  EXPECT_GT(field.shapes.nearer_than(1.0).size(), 0U);
  for (int k = 0; k < 3; ++k) {
    field.shapes.walk(3, 3.0);  // so far that it counts anew
    EXPECT_GT(field.shapes.nearer_than(1.0, 0.0, true).size(), 0U);
  }
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus
