#include "robot/collision/continuous.h"
#include "geometry/bounds/bounds.h"
#include "geometry/bounds/convex_hull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "common/math/index.h"
#include "test/collision/postures.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr int kPlaces = SweptShapes::kPlaces;
constexpr double kLost = 2e-5;  // by single precision [m]

struct Fixture {
  const Model& model = hrp1s();
  std::vector<ConvexShape> shapes;
  std::vector<GjkShape> hulls;
  std::vector<Ball> inside;
  std::vector<SweptShapes::Part> parts;
  JointReach reach;
  SweptShapes swept;
  SweptShapes::Way way;
  Configuration base;
  std::mt19937_64 random{21};
  std::uniform_real_distribution<double> unit{-1.0, 1.0};

  // A shape of every kind on links of both arms, a leg, the trunk and in the world.
  Fixture() : reach(model, radii()), swept(model, reach), base(model) {
    const std::vector<int> links{0, 3, 8, model.link_count() / 2, model.link_count() - 1, -1};
    for (std::size_t i = 0; i < 4 * links.size(); ++i) {
      const ShapeKind kinds[] = {ShapeKind::kSphere, ShapeKind::kCylinder, ShapeKind::kBox,
                                 ShapeKind::kMesh};
      ConvexShape shape;
      shape.kind = kinds[i % 4];
      shape.half = Vector3d(0.05, 0.08, 0.03);
      shapes.push_back(shape);
      std::vector<Vector3d> points;
      for (int p = 0; p < (i % 8 < 4 ? 60 : 7); ++p) {  // so few have no cells
        Vector3d point;
        for (int d = 0; d < 3; ++d) point[d] = shape.half[d] * unit(random);
        points.push_back(point);
      }
      hulls.push_back(gjk_hull(points));
      inside.push_back(ball_inside(convex_hull(points)));
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      SweptShapes::Part part;
      part.link = links[i / 4];
      part.shape = &shapes[i];
      part.hull = shapes[i].kind == ShapeKind::kMesh ? &hulls[i] : nullptr;
      part.inside = inside[i];
      part.local.translation() = 0.05 * Vector3d(unit(random), unit(random), unit(random));
      if (i % 5 != 0) {
        part.local.linear() =
            Eigen::Quaterniond(unit(random), unit(random), unit(random), unit(random))
                .normalized()
                .toRotationMatrix();
      }
      parts.push_back(part);
    }
    fill(swept);
    way.q.resize(model.joints.size());
    way.bend.resize(model.joints.size());
    way.asked.assign(model.joints.size(), 1);
    base.base.translation() = Vector3d(3.0, -2.0, 0.8);
    base.base.linear() =
        Eigen::AngleAxisd(0.7, Vector3d(0.3, 0.2, 0.9).normalized()).toRotationMatrix();
  }
  void fill(SweptShapes& to) const {
    to.set(parts);
    for (int a = 0; a < static_cast<int>(parts.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(parts.size()); ++b) to.want(a, b);
    }
  }
  std::vector<double> radii() const { return std::vector<double>(model.links.size(), 0.2); }
  int pairs() const { return static_cast<int>(parts.size() * (parts.size() - 1) / 2); }

  // From place to place; every third joint stands still, every other bends.
  void draw_way(double step) {
    for (std::size_t j = 0; j < way.q.size(); ++j) {
      const Joint& joint = model.joints[j];
      double q =
          0.5 * (joint.lower + joint.upper + 0.5 * unit(random) * (joint.upper - joint.lower));
      for (std::size_t k = 0; k < at(kPlaces); ++k) {
        way.q[j][k] = q;
        const bool last = k + 1 == at(kPlaces);
        way.bend[j][k] =
            last || j % 2 == 0 ? 0.0F : static_cast<float>(0.1 * step * std::abs(unit(random)));
        if (j % 3 != 0) q += step * unit(random);
      }
    }
    swept.go(base.base, way);
  }
  Configuration posture(double place, bool bent) {
    Configuration c = base;
    const auto k = std::min(static_cast<std::size_t>(place), at(kPlaces) - 2);
    const double share = place - static_cast<double>(k);
    for (std::size_t j = 0; j < way.q.size(); ++j)
      c.q[static_cast<int>(j)] = way.q[j][k] + share * (way.q[j][k + 1] - way.q[j][k]) +
                                 (bent ? static_cast<double>(way.bend[j][k]) * unit(random) : 0.0);
    return c;
  }
  Isometry3d pose(const Kinematics& kinematics, std::size_t part) const {
    return parts[part].link < 0 ? parts[part].local
                                : kinematics.link_in_world(parts[part].link) * parts[part].local;
  }
  double extent(std::size_t part, const Vector3d& n) const {
    if (parts[part].hull == nullptr) return shapes[part].extent(n);
    const std::vector<double>& p = parts[part].hull->points;
    double most = -1e9;
    for (std::size_t i = 0; i < p.size() / 3; ++i)
      most = std::max(most, n.dot(Vector3d(p[i], p[p.size() / 3 + i], p[2 * p.size() / 3 + i])));
    return most;
  }
  double gap(const Kinematics& kinematics, int pair, const Vector3d& n) const {
    const auto [a, b] = swept.shapes(pair);
    const Isometry3d pose_a = pose(kinematics, at(a)), pose_b = pose(kinematics, at(b));
    return n.dot(pose_b.translation() - pose_a.translation()) -
           extent(at(a), pose_a.linear().transpose() * n) -
           extent(at(b), -(pose_b.linear().transpose() * n));
  }
  int common_link(int pair) const {
    const auto [a, b] = swept.shapes(pair);
    int one = std::max(parts[at(a)].link, 0), other = std::max(parts[at(b)].link, 0);
    while (one != other) {
      int& later = one > other ? one : other;
      later = model.links[at(later)].parent;
    }
    return one;
  }
  Vector3d any_direction() {
    return Vector3d(unit(random), unit(random), unit(random)).normalized();
  }
};

TEST(SweptShapes, ShapesAreWhereKinematicsSays) {
  Fixture f;
  Kinematics kinematics(f.model);
  for (int k = 0; k < 10; ++k) {
    f.draw_way(0.3);
    for (int place = 0; place < kPlaces; ++place) {
      kinematics.update(f.posture(place, false));
      for (std::size_t p = 0; p < f.parts.size(); ++p)
        EXPECT_LT(
            (f.swept.pose(static_cast<int>(p), place).matrix() - f.pose(kinematics, p).matrix())
                .norm(),
            1e-5);
    }
  }
}

// Links that were left out of some ways are where they belong once they are asked for, however they
// got there.
TEST(SweptShapes, WhatWasNotAskedForIsInItsPlaceOnceItIs) {
  Fixture f;
  Kinematics kinematics(f.model);
  int kept = 0;
  for (int k = 0; k < 200; ++k) {
    std::fill(f.way.asked.begin(), f.way.asked.end(), std::uint8_t{0});
    const std::size_t wanted = at(static_cast<int>(f.random() % f.parts.size()));
    for (int link = f.parts[wanted].link; link > 0; link = f.model.links[at(link)].parent)
      f.way.asked[at(link - 1)] = 1;
    if (k % 4 == 0) {
      f.draw_way(0.3);
    } else {
      f.swept.go(f.base.base, f.way);  // the same way for others
    }
    if (k % 10 == 0)
      f.base.base.linear() *= Eigen::AngleAxisd(0.1, Vector3d::UnitX()).toRotationMatrix();
    if (k % 10 == 0) f.swept.go(f.base.base, f.way);
    for (int place = 0; place < kPlaces; ++place) {
      kinematics.update(f.posture(place, false));
      for (std::size_t p = 0; p < f.parts.size(); ++p) {
        const int link = f.parts[p].link;
        if (link > 0 && f.way.asked[at(link - 1)] == 0) continue;
        ++kept;
        ASSERT_LT(
            (f.swept.pose(static_cast<int>(p), place).matrix() - f.pose(kinematics, p).matrix())
                .norm(),
            1e-5)
            << k << " " << link;
      }
    }
  }
  EXPECT_GT(kept, 10000);
}

// And no more than what single precision loses is taken off.
// Of a way it says what it would had it gone no other before: joints that go on as they did, others of
// which only the bend or only the angles change, and a base that turns now and then.
TEST(SweptShapes, AWaySaysTheSameWhateverCameBefore) {
  Fixture f;
  f.draw_way(0.2);
  std::vector<NearShapes::Candidate> all;
  for (int p = 0; p < f.pairs(); ++p) {
    NearShapes::Candidate candidate;
    candidate.a = f.swept.shapes(p).a;
    candidate.b = f.swept.shapes(p).b;
    all.push_back(candidate);
  }
  int parted = 0, left = 0;
  for (int i = 0; i < 20; ++i) {
    for (std::size_t j = 0; j < f.way.q.size(); ++j) {
      if (f.unit(f.random) > 0.5) f.way.bend[j][at(i % (kPlaces - 1))] += 0.001F;
      if (f.unit(f.random) > 0.8) f.way.q[j][at(i % kPlaces)] += 0.01;
    }
    if (i % 4 == 0) f.base.base.rotate(Eigen::AngleAxisd(0.1, Vector3d::UnitX()));
    f.swept.go(f.base.base, f.way);
    SweptShapes anew(f.model, f.reach);
    f.fill(anew);
    anew.go(f.base.base, f.way);
    for (int p = 0; p < f.pairs(); ++p) {
      ASSERT_EQ(f.swept.bounds(p).left_out, anew.bounds(p).left_out) << i;
      ASSERT_EQ(f.swept.bounds(p).travel, anew.bounds(p).travel) << i;
    }
    std::vector<int> open(all.size()), open_anew(all.size());
    const int count = anew.open(all, 0.02, 0.01, open_anew.data(), f.pairs());
    ASSERT_EQ(f.swept.open(all, 0.02, 0.01, open.data(), f.pairs()), count) << i;
    ASSERT_EQ(open, open_anew) << i;
    left += count;
    parted += f.pairs() - count;
    // What the corners prove along the direction that is remembered was not given up before they were asked.
    for (int k = 0; k < count; ++k) {
      const int p = open[at(k)];
      const SweptShapes::AtPlaces gaps = f.swept.gaps(p, f.swept.remembered(p, 0), 0), out = f.swept.bounds(p).left_out;
      bool proved = true;
      for (std::size_t place = 0; place < at(kPlaces); ++place) {
        const float next = place + 1 < at(kPlaces) ? gaps[place + 1] : gaps[place];
        proved = proved && gaps[place] >= 0.0201F && std::min(gaps[place], next) - out[place] >= 0.0101F;
      }
      ASSERT_FALSE(proved) << i << " " << p;
    }
    // Of more than there is room for only that is said.
    ASSERT_GT(f.swept.open(all, 0.02, 0.01, open.data(), count / 2), count / 2);
  }
  EXPECT_GT(left, 100);
  EXPECT_GT(parted, 100);
}

TEST(SweptShapes, AGapIsNoMoreThanItIs) {
  Fixture f;
  Kinematics kinematics(f.model), seen(f.model);
  for (int k = 0; k < 10; ++k) {
    f.draw_way(0.3);
    for (int pair = 0; pair < f.pairs(); ++pair) {
      const int from = pair % kPlaces;
      const Vector3d n = f.any_direction();
      const SweptShapes::AtPlaces gaps = f.swept.gaps(pair, n, from);
      seen.update(f.posture(from, false));
      const int common = f.common_link(pair);
      for (int place = 0; place < kPlaces; ++place) {
        kinematics.update(f.posture(place, false));
        const Vector3d there = kinematics.link_in_world(common).linear() *
                               seen.link_in_world(common).linear().transpose() * n;
        const double is = f.gap(kinematics, pair, there);
        ASSERT_LE(static_cast<double>(gaps[at(place)]), is);
        ASSERT_GE(static_cast<double>(f.swept.bounds(pair).most_apart[at(place)]), is);
        ASSERT_GT(static_cast<double>(gaps[at(place)]), is - kLost);
      }
      f.swept.remember(pair, n, from);
      EXPECT_LT((f.swept.remembered(pair, from) - n).norm(), 1e-5);
    }
  }
}

TEST(SweptShapes, BetweenPlacesNoMoreIsLeftOutThanIsSaid) {
  Fixture f;
  Kinematics kinematics(f.model), here(f.model), next(f.model);
  double most = 0.0;
  for (int k = 0; k < 60; ++k) {
    f.draw_way(k % 2 == 0 ? 0.4 : 0.05);
    for (int way = 0; way + 1 < kPlaces; ++way) {
      const Configuration on_way = f.posture(way + 0.5 + 0.4 * f.unit(f.random), true);
      kinematics.update(on_way);
      here.update(f.posture(way, false));
      next.update(f.posture(way + 1, false));
      for (int pair = 0; pair < f.pairs(); ++pair) {
        const Vector3d n = f.any_direction();
        const int common = f.common_link(pair);
        const auto along = [&](const Kinematics& posture) {
          return f.gap(posture, pair, posture.link_in_world(common).linear() * n);
        };
        const double least = std::min(along(here), along(next)), is = along(kinematics);
        const double left_out = static_cast<double>(f.swept.bounds(pair).left_out[at(way)]);
        const double travel = static_cast<double>(f.swept.bounds(pair).travel[at(way)]);
        ASSERT_GE(is, least - left_out - 1e-6) << pair << " " << way;
        ASSERT_GE(is, 0.5 * (along(here) + along(next) - travel) - 1e-6) << pair << " " << way;
        if (left_out > 0.0) most = std::max(most, (least - is) / left_out);
      }
    }
  }
  EXPECT_GT(most, 0.2) << "says far too much";
}

}  // namespace
}  // namespace twinbus
