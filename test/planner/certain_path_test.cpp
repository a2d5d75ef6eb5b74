#include "planner/search/certain_path.h"

#include <gtest/gtest.h>

#include "common/math/splitmix64.h"
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

// A ball of 10 mm that slides in a plane among posts, between which looks at eight postures of a line see little.
TEST(CertainPath, AShortcutThatCannotBeProvedTakesNoSearchAnew) {
  Model model = test::turning_link();
  model.links.push_back(model.links[1]);
  model.links[2].parent = 1;
  model.joints.push_back(model.joints[0]);
  model.joints[1].parent = 1;
  model.joints[1].child = 2;
  model.joints[0].axis = Eigen::Vector3d::UnitX();
  model.joints[1].axis = Eigen::Vector3d::UnitY();
  for (Joint& joint : model.joints) joint.kind = JointKind::kPrismatic;
  const BlockRobot robot =
      compile_robot(model, Configuration(model), {0, 1}, {{.link = 2, .balls = {{Eigen::Vector3d::Zero(), 0.01}}, .pieces = {}}}, {}, 0.0);
  int repaired = 0;
  for (int number = 1; number <= 40; ++number) {
    SplitMix64 random(static_cast<std::uint64_t>(number));
    std::vector<Obstacle> posts(60);
    for (Obstacle& post : posts) {
      post.shape = ObstacleShape::kSphere;
      post.size = Eigen::Vector3d(0.02, 0.0, 0.0);
      post.pose.translation() = Eigen::Vector3d(random.uniform(-1.4, 1.4), random.uniform(-2.0, 2.0), 0.0);
    }
    posts[0].size[0] = 0.3;
    posts[0].pose.translation().setZero();
    const BlockScene scene(posts);
    BlockCheck check(robot, scene);
    JointSearch search({.lower = robot.lower, .upper = robot.upper}), once = search;
    SearchPoint start{}, goal{};
    start[0] = -1.8F;
    goal[0] = 1.8F;
    const CertainPath found = find_certain(search, check, 1.0F, start, {goal});
    ASSERT_TRUE(found.certain) << number;
    const auto proved = [&](const SearchPath& path) {
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const SearchPoint step{path[i + 1][0] - path[i][0], path[i + 1][1] - path[i][1]};
        if (!check.line_certain(path[i].data(), step.data())) return false;
      }
      return true;
    };
    EXPECT_TRUE(proved(found.path)) << number;
    // As found in the first search, and as shortened by looking alone: the first is proved, the second is not.
    BlockLineTest quick(check, 1.0F);
    const SearchPath raw = once.find(quick, start, {goal});
    SearchPath path = raw;
    shorten(quick, path, robot.joints);
    if (!proved(raw) || proved(path)) continue;
    ++repaired;
    EXPECT_EQ(found.rounds, once.rounds()) << number;
    EXPECT_LE(length_of(found.path, robot.joints), length_of(raw, robot.joints)) << number;
  }
  EXPECT_GT(repaired, 0);
}

}  // namespace
}  // namespace twinbus
