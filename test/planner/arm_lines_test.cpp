#include "planner/search/arm_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "common/math/index.h"
#include "planner/joint_turns.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

constexpr double kClearance = 0.020;

const std::vector<int>& arm_joints() { return hrp1s().hands[0].joints; }

// The left arm before a post and a shelf.
struct Rack {
  std::vector<Obstacle> things{post(0.30, 0.30), box(0.4, 0.2, 0.7, 0.3, 0.6, 0.01)};
  Collision collision{hrp1s()};
  std::vector<BallGroup> balls = groups();
  EdgeCheck space{hrp1s(), with_things(), standing(), arm_joints(), kClearance};
  std::mt19937_64 random{5};

  JointPoint posture() {
    JointPoint q(static_cast<int>(arm_joints().size()));
    for (int k = 0; k < q.size(); ++k) {
      const Joint& joint = hrp1s().joints[at(arm_joints()[at(k)])];
      q[k] = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
    }
    return q;
  }
  CertainPath find(const JointPoint& start, const JointPoint& goal) {
    ArmLines lines(hrp1s(), space, collision, balls, things);
    SearchLimits limits = JointTurns(hrp1s(), arm_joints(), start).limits();
    limits.most_rounds = 2000;
    JointSearch search(limits);
    return lines.find_proved(search, to_search(start), {to_search(goal)}, nullptr, nullptr);
  }

 private:
  std::vector<BallGroup> groups() const {
    std::vector<BallGroup> all = balls_along_links(hrp1s());
    for (BallGroup& held : balls_along_held(hrp1s(), things)) all.push_back(std::move(held));
    return all;
  }
  Collision& with_things() {
    collision.set_obstacles(things);
    return collision;
  }
};

// Starts from which a link or an obstacle is nearer than the clearance, and goals with room.
TEST(ArmLines, WhatIsNearWhereTheMotionBeginsNeedsNoExactDistances) {
  Rack rack;
  int found[2] = {};  // beside a link, beside an obstacle
  for (int i = 0; i < 100000 && std::min(found[0], found[1]) < 5; ++i) {
    const JointPoint start = rack.posture(), goal = rack.posture();
    rack.space.keep_at_ends({});
    std::vector<EndPair> ends;
    if (rack.space.nearest(start, kClearance) < 0.004 || !rack.space.point_free(goal)) continue;
    if (rack.space.nearest_beside(start, kClearance, kClearance, ends) < kClearance || ends.size() != 1) continue;
    if (ends[0].room > 0.8 * kClearance) continue;  // coarse hulls are nearer than what is proved by exact ones
    int& count = found[ends[0].link_b >= hrp1s().link_count() ? 1 : 0];
    if (count >= 5) continue;
    ends[0].margin = 0.98 * ends[0].room;
    // Without a margin of its own no proof ends there.
    const CertainPath none = rack.find(start, goal);
    EXPECT_FALSE(none.certain) << i;
    EXPECT_EQ(none.rounds, 0) << i;
    rack.space.keep_at_ends(ends);
    const CertainPath way = rack.find(start, goal);
    if (!way.certain) continue;
    ++count;
    const int joints = static_cast<int>(start.size());
    for (std::size_t n = 0; n + 1 < way.path.size(); ++n) {
      const JointPoint a = from_search(way.path[n], joints), b = from_search(way.path[n + 1], joints);
      for (int s = 0; s <= 200; ++s) ASSERT_TRUE(rack.space.point_free(a + s / 200.0 * (b - a))) << i << " at " << s << " of " << n;
    }
    // Nor is less kept of it, or of others.
    ends[0].margin = 1.05 * ends[0].room;
    rack.space.keep_at_ends(ends);
    EXPECT_FALSE(rack.find(start, goal).certain) << i;
  }
  EXPECT_EQ(found[0], 5);
  EXPECT_EQ(found[1], 5);
}

// Cubics of a timed path: what is proved of one takes the exact check no look.
TEST(ArmLines, ACurveIsProvedByItsChordThoughItStraysAsFarAsLinesHaveRoom) {
  Rack rack;
  ArmLines lines(hrp1s(), rack.space, rack.collision, rack.balls, rack.things);
  int curves = 0, without_looks = 0;
  for (int i = 0; i < 3000; ++i) {
    const JointPoint a = rack.posture(), d = a + 0.05 * (rack.posture() - a);
    const JointPoint b = a + (d - a) / 3.0 + 0.002 * (rack.posture() - a), c = d - (d - a) / 3.0 + 0.002 * (rack.posture() - d);
    const std::int64_t before = rack.space.checks();
    if (!lines.curve_free({a, b, c, d})) continue;
    ++curves;
    without_looks += rack.space.checks() == before ? 1 : 0;
    for (int s = 0; s <= 100; ++s) {
      const double t = s / 100.0, u = 1.0 - t;
      ASSERT_TRUE(rack.space.point_free(u * u * u * a + 3.0 * u * u * t * b + 3.0 * u * t * t * c + t * t * t * d)) << i << " at " << s;
    }
  }
  EXPECT_GT(curves, 300);
  EXPECT_GT(without_looks, curves * 9 / 10);
}

}  // namespace
}  // namespace twinbus
