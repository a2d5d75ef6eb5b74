#include "planner/search/edge_check.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "common/math/index.h"
#include "planner/search/arm_lines.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

const std::vector<int>& left_arm() { return hrp1s().hands[0].joints; }

JointPoint at_posture(const Configuration& posture) {
  JointPoint q(static_cast<int>(left_arm().size()));
  for (int k = 0; k < q.size(); ++k) q[k] = posture.q[left_arm()[static_cast<std::size_t>(k)]];
  return q;
}

JointPoint random_arm(std::mt19937_64& random) {
  JointPoint q(static_cast<int>(left_arm().size()));
  for (int k = 0; k < q.size(); ++k) {
    const Joint& joint =
        hrp1s().joints[static_cast<std::size_t>(left_arm()[static_cast<std::size_t>(k)])];
    q[k] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
  }
  return q;
}

// The left arm before a post and a shelf.
struct Shelf {
  std::vector<Obstacle> things{post(0.30, 0.30), box(0.4, 0.2, 0.7, 0.3, 0.6, 0.01)};
  Configuration start = standing();
  Collision collision{hrp1s()};
  EdgeCheck space{hrp1s(), with_things(), start, left_arm(), 0.005};

 private:
  Collision& with_things() {
    collision.set_obstacles(things);
    return collision;
  }
};

// A joint of the arm that another one follows, three times as far.
TEST(EdgeCheck, WhatFollowsAPlannedJointMovesToo) {
  Model model = hrp1s();
  const int leads = left_arm()[0], follows = left_arm()[2];
  model.joints[at(follows)].mimic = leads;
  model.joints[at(follows)].mimic_multiplier = 3.0;
  Collision plain(hrp1s()), collision(model);
  const Configuration start = standing();
  EdgeCheck alone(hrp1s(), plain, start, {leads}, 0.005), both(model, collision, start, {leads}, 0.005);
  const JointPoint from = JointPoint::Constant(1, 0.1), to = JointPoint::Constant(1, 0.2);
  const double reach = collision.reach().farthest(follows);
  EXPECT_NEAR(both.motion_bound(from, to), alone.motion_bound(from, to) + 0.1 * 3.0 * reach, 1e-9);
  const Kinematics& there = both.kinematics_at(to);
  Configuration posture = start;
  posture.q[leads] = 0.2;
  posture.q[follows] = 0.6;
  Kinematics expected(model);
  expected.update(posture);
  const int hand = model.hands[0].link;
  EXPECT_TRUE(there.link_in_world(hand).isApprox(expected.link_in_world(hand), 1e-12));
}

// The claim of the file: a line that is called free touches nowhere, also between the samples.
TEST(EdgeCheck, AFreeLineIsFreeEverywhere) {
  Shelf shelf;
  auto& [things, start, collision, space] = shelf;
  std::mt19937_64 random(11);
  int free = 0;
  for (int i = 0; i < 400; ++i) {
    const JointPoint a = random_arm(random);
    const JointPoint b = a + 0.4 * (random_arm(random) - a);
    if (!space.line_free(a, b)) continue;
    ++free;
    for (int s = 0; s <= 300; ++s) {
      const JointPoint q = a + s / 300.0 * (b - a);
      ASSERT_FALSE(collision.in_collision(space.kinematics_at(q))) << "line " << i << " at " << s;
    }
  }
  EXPECT_GT(free, 20);
}

// And so does a cubic, which keeps the clearance at every instant, by balls around the links or by exact distances.
TEST(EdgeCheck, AFreeCurveKeepsItsClearanceEverywhere) {
  Shelf shelf;
  auto& [things, start, collision, space] = shelf;
  std::mt19937_64 random(12);
  space.set_clearance(0.02);
  std::vector<BallGroup> groups = balls_along_links(hrp1s());
  for (BallGroup& held : balls_along_held(hrp1s(), things)) groups.push_back(std::move(held));
  ArmLines lines(hrp1s(), space, collision, groups, things);
  space.set_clearance(0.005);
  int free = 0, blocked = 0, by_balls = 0;
  for (int i = 0; i < 200; ++i) {
    const JointPoint a = random_arm(random);
    std::array<JointPoint, 4> curve{a, a, a, a};
    for (std::size_t k = 1; k < 4; ++k) curve[k] = a + 0.4 * (random_arm(random) - a);
    const bool proved = space.curve_free(curve);
    const std::int64_t checks = space.checks();
    EXPECT_EQ(lines.curve_free(curve), proved) << "curve " << i;
    by_balls += proved && space.checks() == checks ? 1 : 0;
    bool is_free = true;
    for (int s = 0; s <= 200; ++s) {
      const double t = s / 200.0, u = 1.0 - t;
      const JointPoint q = u * u * u * curve[0] + 3.0 * u * u * t * curve[1] +
                           3.0 * u * t * t * curve[2] + t * t * t * curve[3];
      is_free = is_free && !collision.nearer_than(space.kinematics_at(q), 0.005);
    }
    EXPECT_TRUE(is_free || !proved) << "curve " << i;
    free += proved ? 1 : 0;
    blocked += is_free && !proved ? 1 : 0;  // what only just keeps it cannot be proved
  }
  EXPECT_GT(free, 20);
  EXPECT_GT(by_balls, 10);
  EXPECT_LT(blocked, 3);
}

// From where the arm is nearer to something than the clearance: that pair keeps its own margin, all others the clearance.
TEST(EdgeCheck, WhatIsNearAtAnEndKeepsAMarginOfItsOwn) {
  constexpr double kClear = 0.01;
  Shelf shelf;
  auto& [things, start, collision, space] = shelf;
  std::mt19937_64 random(13);
  int lines = 0, curves = 0;
  for (int i = 0; i < 4000 && (lines < 20 || curves < 20); ++i) {
    const JointPoint a = random_arm(random);
    space.set_clearance(kClear);
    space.keep_at_ends({});
    space.set_share_at_ends(1.0);
    std::vector<EndPair> ends;
    if (!(space.nearest_beside(a, kClear, kClear, ends) >= kClear) || ends.size() != 1 || !(ends[0].room > 0.002)) continue;
    EXPECT_FALSE(space.point_free(a));
    ends[0].margin = 0.9 * ends[0].room;
    space.keep_at_ends(ends);
    EXPECT_TRUE(space.point_free(a));
    EXPECT_NEAR(space.kept(), 0.9 * ends[0].room, 1e-12);
    const JointPoint b = a + 0.2 * (random_arm(random) - a);
    const bool line = space.line_free(a, b);
    space.set_clearance(0.7 * kClear);
    space.set_share_at_ends(0.7);
    EXPECT_NEAR(space.kept(), 0.63 * ends[0].room, 1e-12);
    const bool curve = space.curve_free({a, a + (b - a) / 3.0, a + 2.0 / 3.0 * (b - a), b});
    lines += line ? 1 : 0;
    curves += curve ? 1 : 0;
    for (int s = 0; (line || curve) && s <= 100; ++s) {
      std::array<PairDistance, 64> near;
      const int count = collision.near_pairs(space.kinematics_at(a + s / 100.0 * (b - a)), kClear, near.data(), 64);
      for (int n = 0; n < count; ++n) {
        const PairDistance& pair = near[static_cast<std::size_t>(n)];
        ASSERT_GT(pair.distance, 0.0) << i;
        const bool end = pair.link_a == ends[0].link_a && pair.link_b == ends[0].link_b;
        if (curve) {
          ASSERT_GT(pair.distance, end ? std::min(0.63 * ends[0].room, 0.7 * kClear) : 0.7 * kClear) << i;
        }
      }
    }
  }
  EXPECT_GE(lines, 20);
  EXPECT_GE(curves, 20);
}

// A plate of half a millimetre cannot be tunnelled through, however long the line.
TEST(EdgeCheck, AThinPlateIsNotTunnelledThrough) {
  const Configuration start = standing();
  Collision collision(hrp1s());
  EdgeCheck open(hrp1s(), collision, start, left_arm(), 0.002);
  const JointPoint home = at_posture(start);
  JointPoint up = home;
  up[0] -= 1.6;  // the arm swings forward and up
  ASSERT_TRUE(open.line_free(home, up));
  collision.set_obstacles({box(0.30, 0.25, 0.85, 0.5, 0.5, 0.0005)});
  EdgeCheck space(hrp1s(), collision, start, left_arm(), 0.002);
  EXPECT_TRUE(space.point_free(home));
  EXPECT_TRUE(space.point_free(up));
  EXPECT_FALSE(space.line_free(home, up));
}

TEST(EdgeCheck, NoPointMovesFartherThanTheBound) {
  const Configuration start = standing();
  Collision collision(hrp1s());
  EdgeCheck space(hrp1s(), collision, start, left_arm(), 0.01);
  std::mt19937_64 random(12);
  const Hand& hand = hrp1s().hands[0];
  for (int i = 0; i < 500; ++i) {
    const JointPoint a = random_arm(random);
    const JointPoint b = random_arm(random);
    const Eigen::Vector3d before =
        (space.kinematics_at(a).link_in_world(hand.link) * hand.frame).translation();
    const Eigen::Vector3d after =
        (space.kinematics_at(b).link_in_world(hand.link) * hand.frame).translation();
    EXPECT_LE((after - before).norm(), space.motion_bound(a, b));
  }
}

TEST(EdgeCheck, NamesWhoIsNear) {
  const Configuration start = standing();
  Collision collision(hrp1s());
  EdgeCheck space(hrp1s(), collision, start, left_arm(), 0.01);
  JointPoint q = at_posture(start);
  q[1] = -0.26;
  q[2] = -1.4;
  q[3] = -1.9;  // the forearm goes into the trunk
  CollisionPair pair;
  ASSERT_TRUE(space.who_is_near(q, 0.01, pair));
  EXPECT_EQ(
      hrp1s().links[static_cast<std::size_t>(std::max(pair.link_a, pair.link_b))].name.substr(0, 4),
      "LARM");
  EXPECT_LT(space.nearest(q, 0.5), 0.01);
  EXPECT_GT(space.nearest(at_posture(start), 0.5), 0.01);
}

TEST(EdgeCheck, RefusesNoJointsAndTooMany) {
  Collision collision(hrp1s());
  EXPECT_THROW(EdgeCheck(hrp1s(), collision, standing(), {}, 0.01), std::invalid_argument);
  std::vector<int> many(13);
  for (int i = 0; i < 13; ++i) many[static_cast<std::size_t>(i)] = i;
  EXPECT_THROW(EdgeCheck(hrp1s(), collision, standing(), many, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace twinbus
