#include "planner/rrt_connect.h"

#include <gtest/gtest.h>

#include "test/planner/flat_world.h"

namespace twinbus {
namespace {

RrtLimits square() {
  RrtLimits limits;
  limits.lower = point2(-3.0, -3.0);
  limits.upper = point2(3.0, 3.0);
  return limits;
}

TEST(RrtConnect, TheStraightWayNeedsNoSearch) {
  FlatWorld world;
  Random random(1);
  const RrtResult result =
      rrt_connect(world, point2(-2.0, 0.0), {point2(2.0, 0.0)}, square(), random);
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.rounds, 0);
  ASSERT_EQ(result.path.size(), 2U);
}

TEST(RrtConnect, GoesThroughTwoDoorsAndEveryLineOfThePathIsFree) {
  FlatWorld world;
  world.walls = {{-0.7, 2.0, 0.4}, {0.7, -2.0, 0.4}};
  const JointPoint start = point2(-2.0, -1.0);
  const JointPoint goal = point2(2.0, 1.0);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    const RrtLimits limits = square();
    const RrtResult result = rrt_connect(world, start, {goal}, limits, random);
    ASSERT_TRUE(result.found) << "seed " << seed;
    EXPECT_GT(result.rounds, 0);
    EXPECT_EQ(result.path.front(), start);
    EXPECT_EQ(result.path.back(), goal);
    EXPECT_TRUE(world.path_free(result.path)) << "seed " << seed;
    for (std::size_t i = 0; i + 1 < result.path.size(); ++i)
      EXPECT_LE((result.path[i + 1] - result.path[i]).norm(), limits.step + 1e-12);
  }
}

TEST(RrtConnect, OneOfSeveralGoalsIsEnough) {
  FlatWorld world;
  world.walls = {{0.0, 50.0, 0.1}};  // no door within the limits
  Random random(4);
  const JointPoint near_goal = point2(-1.0, 2.0);
  const RrtResult result =
      rrt_connect(world, point2(-2.0, 0.0), {point2(2.0, 0.0), near_goal}, square(), random);
  ASSERT_TRUE(result.found);
  EXPECT_EQ(result.path.back(), near_goal);
}

TEST(RrtConnect, GivesUpAfterItsRounds) {
  FlatWorld world;
  world.walls = {{0.0, 50.0, 0.1}};
  Random random(5);
  RrtLimits limits = square();
  limits.max_rounds = 77;
  const RrtResult result =
      rrt_connect(world, point2(-2.0, 0.0), {point2(2.0, 0.0)}, limits, random);
  EXPECT_FALSE(result.found);
  EXPECT_TRUE(result.path.empty());
  EXPECT_EQ(result.rounds, 77);
}

TEST(RrtConnect, StopsWhenToldTo) {
  FlatWorld world;
  world.walls = {{0.0, 50.0, 0.1}};
  Random random(6);
  int asked = 0;
  const auto keep_on = [](void* user) { return ++*static_cast<int*>(user) < 10; };
  const RrtResult result =
      rrt_connect(world, point2(-2.0, 0.0), {point2(2.0, 0.0)}, square(), random, keep_on, &asked);
  EXPECT_FALSE(result.found);
  EXPECT_LT(result.rounds, 10);
}

TEST(RrtConnect, WithoutAGoalThereIsNoPath) {
  FlatWorld world;
  Random random(7);
  EXPECT_FALSE(rrt_connect(world, point2(0.0, 0.0), {}, square(), random).found);
}

TEST(RrtConnect, TheSameSeedGivesTheSamePath) {
  FlatWorld world;
  world.walls = {{-0.7, 2.0, 0.4}, {0.7, -2.0, 0.4}};
  const auto path = [&](std::uint64_t seed) {
    Random random(seed);
    return rrt_connect(world, point2(-2.0, 0.0), {point2(2.0, 0.0)}, square(), random).path;
  };
  EXPECT_EQ(path(8), path(8));
  EXPECT_NE(path(8), path(9));
}

}  // namespace
}  // namespace twinbus
