#include "planner/shortcut.h"

#include <gtest/gtest.h>

#include "test/planner/flat_world.h"

namespace twinbus {
namespace {

JointPath zigzag() {
  return {point2(-2.0, 0.0), point2(-1.5, 2.0), point2(-1.0, -2.0), point2(0.0, 2.0),
          point2(1.0, -2.0), point2(1.5, 2.0),  point2(2.0, 0.0)};
}

TEST(Shortcut, LengthIsTheSumOfTheLines) {
  EXPECT_DOUBLE_EQ(length_of({}), 0.0);
  EXPECT_DOUBLE_EQ(length_of({point2(1.0, 1.0)}), 0.0);
  EXPECT_DOUBLE_EQ(length_of({point2(0.0, 0.0), point2(3.0, 4.0), point2(3.0, 5.0)}), 6.0);
}

TEST(Shortcut, InTheOpenTheStraightLineIsLeft) {
  FlatWorld world;
  JointPath path = zigzag();
  Random random(1);
  shortcut(world, path, 50, random);
  ASSERT_EQ(path.size(), 2U);
  EXPECT_EQ(path.front(), point2(-2.0, 0.0));
  EXPECT_EQ(path.back(), point2(2.0, 0.0));
}

TEST(Shortcut, ThePathStaysFreeKeepsItsEndsAndNeverGrows) {
  FlatWorld world;
  world.walls = {{0.0, 1.8, 0.3}};
  const JointPath before = {point2(-2.0, 0.0), point2(-2.0, 1.9), point2(-1.0, 2.5),
                            point2(-0.4, 1.8), point2(0.4, 1.8),  point2(1.0, 2.9),
                            point2(2.0, 2.0),  point2(2.0, 0.0)};
  ASSERT_TRUE(world.path_free(before));
  double best = 1e9;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    JointPath path = before;
    Random random(seed);
    shortcut(world, path, 120, random);
    EXPECT_TRUE(world.path_free(path)) << "seed " << seed;
    EXPECT_EQ(path.front(), before.front());
    EXPECT_EQ(path.back(), before.back());
    EXPECT_LT(length_of(path), length_of(before));
    best = std::min(best, length_of(path));
  }
  // The shortest way touches the door's two lower corners: 2 sqrt(1.9^2 + 1.5^2) + 0.2.
  EXPECT_LT(best, 1.03 * (2.0 * std::hypot(1.9, 1.5) + 0.2));
}

TEST(Shortcut, APathOfTwoPointsIsLeftAlone) {
  FlatWorld world;
  JointPath path = {point2(0.0, 0.0), point2(1.0, 0.0)};
  Random random(2);
  shortcut(world, path, 100, random);
  EXPECT_EQ(path.size(), 2U);
}

}  // namespace
}  // namespace twinbus
