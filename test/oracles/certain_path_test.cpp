#include "test/oracles/certain_path.h"

#include <gtest/gtest.h>

#include "test/planner/plates.h"

namespace twinbus {
namespace {

// A ball of 0.1 m at the end of an arm of 0.5 m that turns about z, and a ball in the world 10 um ahead of it.
TEST(CertainPath, AnEndThatIsNearerThanRoundingErrorsIsRefusedWithoutASearch) {
  const Model model = test::turning_link(Eigen::Vector3d::Zero(), 2.5);
  const BlockRobot robot = compile_robot(
      model, Configuration(model), {0},
      {{.link = 1, .balls = {{Eigen::Vector3d(0.5, 0.0, 0.0), 0.1}}, .pieces = {}}}, {}, 0.0);
  Obstacle ball;
  ball.shape = ObstacleShape::kSphere;
  ball.size = Eigen::Vector3d(0.1, 0.0, 0.0);
  ball.pose.translation() = Eigen::Vector3d(0.70001, 0.0, 0.0);
  const BlockScene scene({ball});
  BlockCheck check(robot, scene);
  JointSearch search({.lower = robot.lower, .upper = robot.upper});
  const auto at_angle = [](float angle) {
    SearchPoint q{};
    q[0] = angle;
    return q;
  };
  const SearchPoint close = at_angle(0.0F), clear = at_angle(0.3F), goal = at_angle(1.0F);
  ASSERT_TRUE(check.point_free(close.data()));
  EXPECT_FALSE(certain_at(check, close));
  EXPECT_TRUE(certain_at(check, clear));
  EXPECT_TRUE(find_certain(search, check, 32.0F, clear, {goal}).certain);
  // Of two goals the one that can be proved.
  EXPECT_EQ(find_certain(search, check, 32.0F, clear, {close, goal}).path.back(), goal);
  for (const auto& [from, to] : {std::pair{close, goal}, std::pair{goal, close}}) {
    const CertainPath none = find_certain(search, check, 32.0F, from, {to});
    EXPECT_FALSE(none.certain);
    EXPECT_TRUE(none.path.empty());
    EXPECT_EQ(none.rounds, 0);
  }
}

// Two plates 30 mm apart whose balls overlap in every posture.
TEST(CertainPath, APairThatHullsSettleIsSettledByThemInTheSearchToo) {
  const BlockRobot robot = test::plates(0.05);
  const BlockScene nothing;
  BlockCheck check(robot, nothing);
  JointSearch search({.lower = robot.lower, .upper = robot.upper});
  SearchPoint start{}, goal{};
  goal[0] = 1.0F;
  EXPECT_FALSE(find_certain(search, check, 32.0F, start, {goal}).certain);
  check.settle_pairs(true);
  EXPECT_TRUE(find_certain(search, check, 32.0F, start, {goal}).certain);
}

}  // namespace
}  // namespace twinbus
