#include "common/math/random.h"
#include "sim/scene/scene_seed.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus {
namespace {

// Height of a tile's top over a point [m].
double top(const Obstacle& tile, double x, double y) {
  const Eigen::Vector3d up = tile.pose.linear().col(2);
  const Eigen::Vector3d middle = tile.pose.translation() + 0.5 * tile.size.z() * up;
  return middle.z() - (up.x() * (x - middle.x()) + up.y() * (y - middle.y())) / up.z();
}

Scene ramp() {
  Scene scene;
  scene.terrain.tile = 0.3;
  scene.terrain.from = 0.6;
  scene.terrain.length = 5.4;
  scene.terrain.width = 0.3;
  scene.terrain.ramp = 5.0 * std::numbers::pi / 180.0;
  return scene;
}

TEST(SceneSeed, ARampGoesUpStaysLevelAndComesDownWithoutAStep) {
  Scene scene = ramp();
  apply_seed(scene, Model{}, 1);
  ASSERT_EQ(scene.tiles.size(), 18U);
  EXPECT_NEAR(top(scene.tiles.front(), 0.6, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(top(scene.tiles.back(), 6.0, 0.0), 0.0, 1e-12);
  for (std::size_t i = 0; i + 1 < scene.tiles.size(); ++i) {
    const double edge = 0.6 + 0.3 * static_cast<double>(i + 1);
    EXPECT_NEAR(top(scene.tiles[i], edge, 0.1), top(scene.tiles[i + 1], edge, 0.1), 1e-12) << i;
  }
  const double summit = std::tan(scene.terrain.ramp) * 1.8;
  EXPECT_NEAR(top(scene.tiles[8], 3.3, 0.0), summit, 1e-12);
}

TEST(SceneSeed, ARampIsTheSameForEverySeedAndTilesAreNot) {
  Scene one = ramp(), two = ramp();
  apply_seed(one, Model{}, 1);
  apply_seed(two, Model{}, 2);
  EXPECT_EQ(one.tiles[3].pose.matrix(), two.tiles[3].pose.matrix());
  one.terrain.height = two.terrain.height = 0.03;
  apply_seed(one, Model{}, 1);
  apply_seed(two, Model{}, 2);
  EXPECT_NE(one.tiles[3].pose.matrix(), two.tiles[3].pose.matrix());
}

TEST(SceneSeed, EverySeedOfADisturbanceIsAnotherWorldAndTheSameSeedTheSame) {
  Scene scene;
  LooseBody body;
  body.start.pose.translation() = Eigen::Vector3d(1, 2, 3);
  scene.loose = {body, body};
  const auto drawn = [&](std::uint64_t seed) {
    Scene copy = scene;
    apply_seed(copy, Model{}, seed);
    return copy;
  };
  EXPECT_EQ(drawn(1).loose[0].start.pose.matrix(), body.start.pose.matrix());  // nothing asked
  scene.disturbance.position = 0.01;
  scene.disturbance.mass = 0.1;
  scene.disturbance.friction = 0.2;
  const Scene one = drawn(1), same = drawn(1), two = drawn(2);
  const Eigen::Vector3d moved = one.loose[0].start.pose.translation() - Eigen::Vector3d(1, 2, 3);
  EXPECT_GT(moved.norm(), 0.0);
  EXPECT_LE(moved.cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LE(std::abs(one.loose[0].mass / body.mass - 1.0), 0.1);
  EXPECT_EQ(one.loose[1].start.pose.matrix(), same.loose[1].start.pose.matrix());
  EXPECT_NE(one.loose[1].start.pose.matrix(), two.loose[1].start.pose.matrix());
  EXPECT_NE(one.loose[0].start.pose.matrix(), one.loose[1].start.pose.matrix());
  EXPECT_NE(one.ground_friction, two.ground_friction);
  EXPECT_EQ(one.loose[0].start.velocity, body.start.velocity);
}

TEST(SceneSeed, ASceneThatDrawsNothingIsKnownAndASmallDisturbanceMakesItDraw) {
  Scene scene;
  scene.loose.emplace_back().name = "box";
  EXPECT_FALSE(draws_from_seed(scene));
  EXPECT_TRUE(draws_from_seed(ramp()));
  scene.push_round.count = 1;
  EXPECT_TRUE(draws_from_seed(scene));
  scene.push_round.count = 0;
  scene.disturbance = small_disturbance();
  EXPECT_TRUE(draws_from_seed(scene));
  Model model;
  model.joints.emplace_back().name = "knee";
  Scene one = scene, two = scene;
  apply_seed(one, model, 1);
  apply_seed(two, model, 2);
  EXPECT_NE(one.loose[0].mass, two.loose[0].mass);
  EXPECT_NE(one.loose[0].start.pose.matrix(), two.loose[0].start.pose.matrix());
  EXPECT_NE(one.ground_friction, two.ground_friction);
  ASSERT_EQ(one.start_velocity.size(), 1U);
  EXPECT_NE(one.start_velocity, two.start_velocity);
  EXPECT_NE(one.settings, two.settings);  // masses of the robot
  EXPECT_LT(std::abs(one.loose[0].mass / scene.loose[0].mass - 1.0), 0.05);
}

// A plate that lies on the ground is not pressed into it, and a box in a hand not out of it.
TEST(SceneSeed, ASmallDisturbanceLeavesWhatIsLooseAsHighAndAsUpright) {
  Scene scene;
  scene.loose.emplace_back().start.pose.translation() = Eigen::Vector3d(1, 2, 0.005);
  scene.disturbance = small_disturbance();
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    Scene drawn = scene;
    apply_seed(drawn, Model{}, seed);
    const LooseBody& body = drawn.loose.front();
    EXPECT_EQ(body.start.pose.translation().z(), 0.005);
    EXPECT_NEAR(body.start.pose.linear()(2, 2), 1.0, 1e-15);
    EXPECT_EQ(body.start.velocity.z(), 0.0);
    EXPECT_GT(std::abs(body.start.velocity.x()), 0.0);
    EXPECT_GT(std::abs(body.start.angular_velocity.z()), 0.0);
  }
}

// What a scene says of mass and friction in its settings is scaled, not replaced.
TEST(SceneSeed, ADisturbanceScalesTheScenesOwnSettings) {
  Scene scene;
  scene.settings = {{"model.mass_scale", "1.2"}, {"contact.friction", "0.3"}};
  scene.disturbance = small_disturbance();
  apply_seed(scene, Model{}, 3);
  ASSERT_EQ(scene.settings.size(), 2U);
  for (const auto& [key, value] : scene.settings) {
    const double own = key == "contact.friction" ? 0.3 : 1.2;
    EXPECT_NEAR(std::stod(value), own, 0.1 * own) << key;
    EXPECT_GT(std::abs(std::stod(value) - own), 1e-6) << key;
  }
}

// `run stand --seeds 1..8` is eight worlds: scenes that ask whether a robot holds say that they are to be drawn.
TEST(SceneSeed, ScenesOfStandingWalkingAndPushesAreRobust) {
  int asked = 0;
  for (const std::string& name : scene_names()) {
    const Scene scene = load_scene(name);
    EXPECT_FALSE(is_disturbed(scene) && scene.robust) << name;  // it has a disturbance of its own
    if (!name.starts_with("walk_") && !name.starts_with("push_") && name != "stand" && name != "plate_underfoot") continue;
    EXPECT_TRUE(scene.robust) << name;
    ++asked;
  }
  EXPECT_GT(asked, 20);
}

TEST(Random, IsTheSameEverywhere) {
  Random random(42);
  const std::uint64_t first = random.next();
  EXPECT_EQ(first, Random(42).next());
  EXPECT_NE(first, Random(43).next());
}

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  Random random(7);
  const int n = 200000;
  double sum = 0.0, square = 0.0, fourth = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / n, 0.0, 0.01);
  EXPECT_NEAR(square / n, 1.0, 0.02);
  EXPECT_NEAR(fourth / n, 3.0, 0.1);
}

TEST(Random, UniformIsInTheHalfOpenInterval) {
  Random random(1);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100000, 0.5, 0.01);
}

}  // namespace
}  // namespace twinbus
