#include "planner/search/rrt_connect.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "planner/search/shorten.h"

namespace twinbus {
namespace {

// A plane with a wall at x = 0 that has a door at y in 1..1.4.
class Wall : public LineTest {
 public:
  bool free(const SearchPoint& from, const SearchPoint& step, float) override {
    ++asked;
    const float x0 = from[0], x1 = from[0] + step[0];
    if (x0 * x1 > 0.0F) return true;
    const float t = x0 == x1 ? 0.0F : x0 / (x0 - x1);
    const float y = from[1] + t * step[1];
    return door && y > 1.0F && y < 1.4F;
  }
  bool door = true;
  int asked = 0;
};

SearchLimits square() { return {.lower = {-2.0F, -2.0F}, .upper = {2.0F, 2.0F}}; }
SearchPoint point(float x, float y) {
  SearchPoint p{};
  p[0] = x;
  p[1] = y;
  return p;
}

TEST(JointSearch, FindsTheDoorAndEveryLineIsFree) {
  Wall wall;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SearchLimits limits = square();
    limits.seed = seed;
    JointSearch search(limits);
    SearchPath path = search.find(wall, point(-1.0F, -1.0F), {point(1.0F, -1.0F)});
    ASSERT_GE(path.size(), 3U) << seed;
    const float before = length_of(path, 2);
    shorten(wall, path, 2);
    EXPECT_LE(length_of(path, 2), before);
    EXPECT_EQ(path.front(), point(-1.0F, -1.0F));
    EXPECT_EQ(path.back(), point(1.0F, -1.0F));
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      EXPECT_TRUE(wall.between(path[i], path[i + 1], 2)) << seed;
    EXPECT_LT(length_of(path, 2), 5.9F) << seed;  // the shortest is 4.47
  }
}

TEST(JointSearch, TheSameSeedGivesTheSamePath) {
  Wall wall;
  SearchLimits limits = square();
  limits.seed = 7;
  JointSearch one(limits), other(limits);
  const SearchPath a = one.find(wall, point(-1.0F, 0.0F), {point(1.0F, 0.0F)});
  EXPECT_EQ(a, other.find(wall, point(-1.0F, 0.0F), {point(1.0F, 0.0F)}));
  EXPECT_EQ(a, one.find(wall, point(-1.0F, 0.0F), {point(1.0F, 0.0F)}));
}

TEST(JointSearch, TakesAGoalInSightAndGivesUpWithoutADoor) {
  Wall wall;
  JointSearch search(square());
  const SearchPath path =
      search.find(wall, point(-1.0F, 0.0F), {point(1.0F, 0.0F), point(-1.0F, 1.0F)});
  EXPECT_EQ(path.size(), 2U);
  EXPECT_EQ(search.rounds(), 0);
  wall.door = false;
  SearchLimits few = square();
  few.most_rounds = 300;
  JointSearch vain(few);
  EXPECT_TRUE(vain.find(wall, point(-1.0F, 0.0F), {point(1.0F, 0.0F)}).empty());
  EXPECT_EQ(vain.rounds(), 300);
}

TEST(JointSearch, EndsWhenTold) {
  Wall wall;
  wall.door = false;
  JointSearch search(square());
  int left = 3;
  const auto keep_on = [](void* user) { return --*static_cast<int*>(user) > 0; };
  EXPECT_TRUE(search.find(wall, point(-1.0F, 0.0F), {point(1.0F, 0.0F)}, keep_on, &left).empty());
  EXPECT_LT(search.rounds(), 1000);
}

// Nothing is free, and somebody counts.
class Nowhere : public LineTest {
 public:
  bool free(const SearchPoint&, const SearchPoint&, float length) override {
    if (++asked > 1) longest = std::max(longest, length);  // after the way straight to the goal
    return false;
  }
  int asked = 0;
  float longest = 0.0F;
};

// Samples of twice as many joints are farther away; nodes at what blocks them still hear of them, and steps do not grow.
TEST(JointSearch, ManyJointsAreSearchedAsFewAre) {
  constexpr int kRounds = 1000;
  for (const int joints : {7, 14}) {
    SearchLimits limits;
    limits.lower.assign(static_cast<std::size_t>(joints), -2.0F);
    limits.upper.assign(static_cast<std::size_t>(joints), 2.0F);
    limits.most_rounds = kRounds;
    JointSearch search(limits);
    Nowhere nowhere;
    SearchPoint goal{};
    goal[0] = 0.1F;
    EXPECT_TRUE(search.find(nowhere, SearchPoint{}, {goal}).empty());
    EXPECT_GT(nowhere.asked, kRounds * 8 / 10) << joints;
    EXPECT_NEAR(nowhere.longest, joints == 7 ? 1.0F : 0.5F, 1e-5F);
  }
}

}  // namespace
}  // namespace twinbus
