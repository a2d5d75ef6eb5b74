#include "planner/batch/check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "planner/batch/nearest_point.h"
#include "test/planner/plates.h"
#include "common/math/splitmix64.h"
#include "geometry/distance/gjk.h"
#include "common/math/index.h"

namespace twinbus {
namespace {

// A chain of `count` hinges about z, x, z, ... 0.3 m apart with two balls each, on a base ball.
struct Chain {
  Model model;
  std::vector<BallGroup> groups;
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> planned;

  explicit Chain(int count) {
    model.links.resize(at(count + 1));
    groups.push_back({.link = 0, .balls = {{Eigen::Vector3d::Zero(), 0.1}}, .pieces = {}});
    for (int i = 0; i < count; ++i) {
      Joint joint;
      joint.parent = i;
      joint.child = i + 1;
      joint.placement.translation() = Eigen::Vector3d(0.0, 0.02, 0.3);
      joint.placement.linear() = Eigen::AngleAxisd(0.2 * i, Eigen::Vector3d::UnitY()).matrix();
      joint.axis = i % 2 == 0 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX();
      joint.lower = -2.5;
      joint.upper = 2.5;
      model.joints.push_back(joint);
      model.links[at(i + 1)].parent = i;
      groups.push_back({.link = i + 1,
                        .balls = {{{0.0, 0.0, 0.1}, 0.06}, {{0.03, 0.0, 0.2}, 0.05}},
                        .pieces = {}});
      planned.push_back(i);
      for (int other = 0; other < i; ++other) pairs.emplace_back(other, i + 1);
    }
  }
  BlockRobot compiled() const {
    return compile_robot(model, Configuration(model), planned, groups, pairs, 0.0);
  }
};

std::vector<Obstacle> obstacles() {
  std::vector<Obstacle> all(4);
  all[0] = {ObstacleShape::kBox, {0.3, 0.4, 0.2}, Eigen::Isometry3d::Identity()};
  all[0].pose.translation() = Eigen::Vector3d(0.5, 0.2, 0.7);
  all[0].pose.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).matrix();
  all[1] = {ObstacleShape::kCylinder, {0.1, 0.6, 0.0}, Eigen::Isometry3d::Identity()};
  all[1].pose.translation() = Eigen::Vector3d(-0.4, 0.3, 0.8);
  all[2] = {ObstacleShape::kSphere, {0.15, 0.0, 0.0}, Eigen::Isometry3d::Identity()};
  all[2].pose.translation() = Eigen::Vector3d(0.0, -0.6, 0.9);
  all[3] = {ObstacleShape::kBox, {0.2, 0.1, 0.3}, Eigen::Isometry3d::Identity()};  // upright
  all[3].pose.translation() = Eigen::Vector3d(-0.3, -0.3, 1.1);
  all[3].pose.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).matrix();
  return all;
}

double outside(const Obstacle& o, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = o.pose.inverse() * point;
  if (o.shape == ObstacleShape::kSphere) return p.norm() - o.size.x();
  if (o.shape == ObstacleShape::kBox) return (p.cwiseAbs() - 0.5 * o.size).cwiseMax(0.0).norm();
  return Eigen::Vector2d(std::max(0.0, p.head<2>().norm() - o.size.x()),
                         std::max(0.0, std::abs(p.z()) - 0.5 * o.size.y()))
      .norm();
}

// The clearance by the robot's own kinematics, in double precision [m].
double clearance(const Chain& chain, const std::vector<float>& q) {
  Configuration posture(chain.model);
  for (int j = 0; j < posture.q.size(); ++j) posture.q[j] = static_cast<double>(q[at(j)]);
  Kinematics kinematics(chain.model);
  kinematics.update(posture);
  double least = 1e9;
  const auto center = [&](const BallGroup& g, const Ball& b) {
    return Eigen::Vector3d(kinematics.link_in_world(g.link) * b.center);
  };
  for (std::size_t g = 1; g < chain.groups.size(); ++g) {
    for (const Ball& ball : chain.groups[g].balls) {
      for (const Obstacle& o : obstacles())
        least = std::min(least, outside(o, center(chain.groups[g], ball)) - ball.radius);
    }
  }
  for (const auto& [a, b] : chain.pairs) {
    for (const Ball& x : chain.groups[at(a)].balls) {
      for (const Ball& y : chain.groups[at(b)].balls) {
        const double d = (center(chain.groups[at(a)], x) - center(chain.groups[at(b)], y)).norm();
        least = std::min(least, d - x.radius - y.radius);
      }
    }
  }
  return least;
}

std::vector<float> random_point(SplitMix64& random, int joints) {
  std::vector<float> q;
  for (int j = 0; j < joints; ++j) q.push_back(static_cast<float>(random.uniform(-2.5, 2.5)));
  q.resize(at(kMostPlanned));
  return q;
}

// A chain of six joints among the obstacles.
struct SixJoints {
  Chain chain{6};
  BlockRobot robot = chain.compiled();
  BlockScene scene{obstacles()};
  BlockCheck check{robot, scene};
};

TEST(BlockCheck, HullsSettleWhatTheBallsOfTwoLinksLeaveOpen) {
  const BlockScene nothing;
  const float from = -1.0F, step = 2.0F;
  for (const InstructionSet set : {InstructionSet::kBaseline, best_instruction_set()}) {
    for (const double height : {0.05, 0.015}) {
      const BlockRobot robot = test::plates(height);
      BlockCheck check(robot, nothing, set);
      EXPECT_FALSE(check.point_free(&from));
      check.settle_pairs(true);
      const bool apart = height > 0.02;
      EXPECT_EQ(check.point_free(&from), apart);
      EXPECT_EQ(check.line_free(&from, &step, 8), apart);
      EXPECT_EQ(check.line_certain(&from, &step), apart);
    }
  }
}

// How many of so many random trials on six joints say that they are free; trial(six, random).
template <class Trial>
int free_of(int trials, std::uint64_t seed, Trial trial) {
  SixJoints six;
  SplitMix64 random(seed);
  int free = 0;
  for (int i = 0; i < trials; ++i) free += trial(six, random) ? 1 : 0;
  return free;
}

TEST(BlockCheck, APostureIsFreeWhenTheBallsAreClearInDoublePrecision) {
  const int free = free_of(3000, 1, [](SixJoints& six, SplitMix64& random) {
    const std::vector<float> q = random_point(random, 6);
    const double least = clearance(six.chain, q);
    if (std::abs(least) < 1e-5) return false;
    const bool said = six.check.point_free(q.data());
    EXPECT_EQ(said, least > 0.0) << least;
    return said;
  });
  EXPECT_GT(free, 200);
  EXPECT_LT(free, 2800);
}

TEST(BlockCheck, WhatIsLeftOutAlongALineIsFarAway) {
  const int free = free_of(2000, 2, [](SixJoints& six, SplitMix64& random) {
    const std::vector<float> from = random_point(random, 6);
    const std::vector<float> to = random_point(random, 6);
    std::vector<float> step(at(kMostPlanned));
    for (std::size_t j = 0; j < 6; ++j) step[j] = 0.3F * (to[j] - from[j]);
    constexpr int kBlocks = 5;
    const bool said = six.check.line_free(from.data(), step.data(), kBlocks);
    bool all = true;  // each posture of the rake by itself
    for (int n = 1; all && n <= 8 * kBlocks; ++n) {
      std::vector<float> q(at(kMostPlanned));
      for (std::size_t j = 0; j < 6; ++j) q[j] = from[j] + static_cast<float>(n) / (8.0F * kBlocks) * step[j];
      if (std::abs(clearance(six.chain, q)) < 1e-5) {
        all = said;
        break;
      }
      all = six.check.point_free(q.data());
    }
    EXPECT_EQ(said, all);
    return said;
  });
  EXPECT_GT(free, 50);
}

TEST(BlockCheck, AProvedLineIsFreeAtEveryFinePosture) {
  SixJoints six;
  auto& [chain, robot, scene, check] = six;
  SplitMix64 random(5);
  int proved = 0, free = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<float> from = random_point(random, 6);
    std::vector<float> step = random_point(random, 6);
    for (float& s : step) s *= 0.2F;
    const bool said = check.line_certain(from.data(), step.data());
    bool all = true;
    for (int n = 0; all && n <= 400; ++n) {
      std::vector<float> q(at(kMostPlanned));
      for (std::size_t j = 0; j < 6; ++j) q[j] = from[j] + static_cast<float>(n) / 400.0F * step[j];
      all = check.point_free(q.data());
    }
    EXPECT_TRUE(all || !said) << i;
    proved += said ? 1 : 0;
    free += all ? 1 : 0;
  }
  EXPECT_GT(proved, 20);
  EXPECT_GE(proved, free - 3);  // what only just passes is not proved
}

// A box as eight corners between two balls that hold it: the corners have the last word.
TEST(BlockCheck, CornersSettleWhatBallsLeaveOpen) {
  Chain chain(1);
  BallGroup& box = chain.groups[1];
  box.balls = {{{0.0, 0.0, 0.5}, 0.4}};
  std::vector<Eigen::Vector3d> corners;
  for (const double x : {-0.1, 0.1}) {
    for (const double y : {-0.1, 0.1}) {
      for (const double z : {0.4, 0.6}) corners.emplace_back(x, y, z);
    }
  }
  box.pieces = {corners};
  const BlockRobot robot = chain.compiled();
  for (const double gap : {0.002, -0.002}) {
    std::vector<Obstacle> wall(1);  // beside the face at x = 0.1
    wall[0] = {ObstacleShape::kBox, {0.2, 3.0, 3.0}, Eigen::Isometry3d::Identity()};
    wall[0].pose.translation() = Eigen::Vector3d(0.2 + gap, 0.0, 0.0);
    const BlockScene scene(wall);
    BlockCheck check(robot, scene);
    const std::vector<float> q(at(kMostPlanned));
    EXPECT_EQ(check.point_free(q.data()), gap > 0.0);
  }
}

// Hulls and obstacles in any place and of any shape, thin plates too, against distances in double precision.
TEST(BlockCheck, CornersSayWhatTheDistanceOfTheHullSays) {
  SplitMix64 random(5);
  const auto between = [&](double a, double b) { return random.uniform(a, b); };
  const auto direction = [&] {
    return Eigen::Vector3d(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)).normalized();
  };
  int apart = 0, touching = 0;
  for (int i = 0; i < 3000; ++i) {
    Chain chain(1);
    BallGroup& group = chain.groups[1];
    const Ball ball{{0.0, 0.0, 0.5}, 0.4};
    group.balls = {ball};
    group.pieces = {{}};
    const Eigen::Vector3d half(between(0.01, 0.2), between(0.01, 0.2), between(0.01, 0.2));
    for (int k = 0; k < 4 + i % 40; ++k)
      group.pieces[0].emplace_back(ball.center + direction().cwiseProduct(half));
    std::vector<Obstacle> wall(1);
    Obstacle& o = wall[0];
    o = {static_cast<ObstacleShape>(1 + i % 3), Eigen::Vector3d::Zero(),
         Eigen::Isometry3d::Identity()};
    for (int k = 0; k < 3; ++k) o.size[k] = between(0.005, 0.3);
    o.pose.linear() = Eigen::AngleAxisd(between(-3.0, 3.0), direction()).matrix();
    const Model& model = chain.model;
    Kinematics kinematics(model);
    kinematics.update(Configuration(model));
    const Eigen::Isometry3d& link = kinematics.link_in_world(1);
    o.pose.translation() = link * (ball.center + between(0.0, 0.5) * direction());
    GjkShape other;
    other.half = o.size;
    other.kind = ShapeKind::kSphere;
    if (o.shape == ObstacleShape::kBox) {
      other.kind = ShapeKind::kBox;
      other.half *= 0.5;
    } else if (o.shape == ObstacleShape::kCylinder) {
      other.kind = ShapeKind::kCylinder;
      other.half.y() *= 0.5;
    }
    const double distance =
        gjk_distance(gjk_hull(group.pieces[0]), link, other, o.pose, 1.0).distance;
    if (distance > 0.0 && distance < 1e-4) continue;
    (distance > 0.0 ? apart : touching) += 1;
    const BlockRobot robot = chain.compiled();
    const BlockScene scene(wall);
    BlockCheck check(robot, scene);
    const std::vector<float> q(at(kMostPlanned));
    EXPECT_EQ(check.point_free(q.data()), distance > 0.0) << i << ": " << distance;
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(touching, 500);
}

// Also where corners decide: any number of them, some in one place, some equally low.
TEST(BlockCheck, EveryInstructionSetSaysTheSame) {
  Chain chain(7);
  SplitMix64 random(3);
  for (std::size_t g = 0; g < chain.groups.size(); ++g) {
    std::vector<Eigen::Vector3d> corners;
    const Ball& ball = chain.groups[g].balls.front();
    for (std::size_t k = 0; k < 5 + 7 * g; ++k) {
      const auto side = [&] { return 0.5 * ball.radius * (random.uniform() < 0.5 ? -1.0 : 1.0); };
      const auto within = [&] { return random.uniform(-0.5, 0.5) * ball.radius; };
      corners.push_back(ball.center + (k % 3 == 0 ? Eigen::Vector3d(side(), side(), side())
                                                  : Eigen::Vector3d(side(), within(), within())));
    }
    chain.groups[g].pieces = {corners};
  }
  const BlockRobot robot = chain.compiled();
  const BlockScene scene(obstacles());
  std::vector<std::unique_ptr<BlockCheck>> checks;
  for (int set = 0; set <= static_cast<int>(best_instruction_set()); ++set)
    checks.push_back(std::make_unique<BlockCheck>(robot, scene, static_cast<InstructionSet>(set)));
  int free = 0, certain = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<float> from = random_point(random, 7);
    std::vector<float> step = random_point(random, 7);
    for (float& s : step) s *= 0.1F;
    const bool is_free = checks[0]->line_free(from.data(), step.data(), 4);
    const bool is_certain = checks[0]->line_certain(from.data(), step.data());
    for (const auto& check : checks) {
      EXPECT_EQ(check->line_free(from.data(), step.data(), 4), is_free) << i;
      EXPECT_EQ(check->line_certain(from.data(), step.data()), is_certain) << i;
    }
    free += is_free ? 1 : 0;
    certain += is_certain ? 1 : 0;
  }
  for (std::size_t k = 2; k < checks.size(); ++k)
    EXPECT_EQ(checks[k]->blocks(), checks[1]->blocks());
  EXPECT_GT(free, 100);
  EXPECT_LT(free, 1900);
  EXPECT_GT(certain, 50);
}

// Plates 30 mm apart, and a box 30 mm above the upper one.
TEST(BlockCheck, APairAndAnObstacleMayKeepLessThanOthersAndALineMoreThanThat) {
  BlockRobot robot = test::plates(0.05);
  Obstacle box;
  box.shape = ObstacleShape::kBox;
  box.size = Eigen::Vector3d(0.3, 0.3, 0.02);
  box.pose.translation().z() = 0.1;
  const BlockScene scene({box}), nothing;
  const float from[1] = {0.1F}, step[1] = {0.3F}, still[1] = {0.0F};
  const auto certain = [&](const BlockScene& of, const float* way, float slack) {
    BlockCheck check(robot, of);
    check.settle_pairs(true);
    const bool proved = check.line_certain(from, way, slack);
    if (slack == 0.0F) {
      EXPECT_EQ(check.line_free(from, way, 4), proved);
    }
    return proved;
  };
  robot.grow = 0.020F;
  EXPECT_TRUE(certain(scene, step, 0.0F));
  EXPECT_TRUE(certain(scene, still, 0.0095F));
  EXPECT_FALSE(certain(nothing, still, 0.0105F));
  robot.kept_of_pairs = {0.0F};
  EXPECT_TRUE(certain(scene, still, 0.0095F));
  EXPECT_FALSE(certain(scene, still, 0.0105F));  // the box alone
  robot.kept_of_pairs.clear();
  robot.grow = 0.040F;
  EXPECT_FALSE(certain(nothing, step, 0.0F));
  robot.kept_of_pairs = {0.0295F};
  EXPECT_TRUE(certain(nothing, step, 0.0F));
  EXPECT_FALSE(certain(scene, step, 0.0F));
  robot.kept_of_shapes = {{0, 0, 0.0295F}, {1, 0, 0.0305F}};  // the lower plate's, and too much of the upper one's
  EXPECT_FALSE(certain(scene, step, 0.0F));
  robot.kept_of_shapes[1].kept = 0.0295F;
  EXPECT_TRUE(certain(scene, step, 0.0F));
  robot.kept_of_pairs = {0.0305F};
  EXPECT_FALSE(certain(scene, step, 0.0F));
}

// A link of two boxes, one of them in a box that is one piece.
TEST(BlockCheck, PiecesThatMeetTheOnlyPieceOfAnotherGroupTouchIt) {
  const Model model = test::turning_link();
  for (const double height : {0.0, 0.05}) {
    const auto boxes = {test::corners_of_box({0.1, 0.0, height}, {0.02, 0.02, 0.01}), test::corners_of_box({-0.1, 0.0, 0.2}, {0.02, 0.02, 0.01})};
    BallGroup two{.link = 1, .balls = {{Eigen::Vector3d::Zero(), 0.3}}, .pieces = {test::corners_of_box({0.0, 0.0, 0.1}, {0.12, 0.02, 0.11})}};
    two.pieces.insert(two.pieces.end(), boxes);
    BallGroup one{.link = 0, .balls = {{Eigen::Vector3d::Zero(), 0.3}}, .pieces = {test::corners_of_box(Eigen::Vector3d::Zero(), {0.2, 0.2, 0.01})}};
    for (const bool swapped : {false, true}) {
      const BlockRobot robot = compile_robot(model, Configuration(model), {0}, {one, two}, {swapped ? std::pair{1, 0} : std::pair{0, 1}}, 1e-4);
      const BlockScene nothing;
      BlockCheck check(robot, nothing);
      check.settle_pairs(true);
      check.settle_by_pieces(true);
      const float from[1] = {0.1F}, step[1] = {0.3F};
      EXPECT_EQ(check.line_certain(from, step), height > 0.0) << swapped;
      EXPECT_EQ(check.line_free(from, step, 4), height > 0.0) << swapped;
    }
  }
}

TEST(BlockCheck, TheNearestPointIsTheFirstOfTheNearest) {
  SplitMix64 random(4);
  std::vector<float> columns(3 * 32, 1e6F);
  for (int count = 1; count <= 32; ++count) {
    for (int j = 0; j < 3; ++j)
      columns[at(32 * j + count - 1)] = static_cast<float>(random.uniform());
    const float q[3] = {0.5F, 0.5F, 0.5F};
    int best = 0;
    const auto square = [&](int i) {
      float sum = 0.0F;
      for (int j = 0; j < 3; ++j)
        sum += (columns[at(32 * j + i)] - q[j]) * (columns[at(32 * j + i)] - q[j]);
      return sum;
    };
    for (int i = 1; i < count; ++i) best = square(i) < square(best) ? i : best;
    float found = 0.0F;
    EXPECT_EQ(nearest_point(columns.data(), 32, count, 3, q, found), best);
  }
}

}  // namespace
}  // namespace twinbus
