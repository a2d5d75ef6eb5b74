// Loose bodies that lie still and are not modelled until something touches them (`asleep`).

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sim/engine/articulated_world.h"
#include "sim/engine/energy_balance.h"
#include "sim/engine/make_world.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

LooseBody box_at(const std::string& name, const Eigen::Vector3d& at) {
  return test::loose_box(name, 2.0, {0.2, 0.2, 0.1}, Eigen::Isometry3d(Eigen::Translation3d{at}), 1e6, 4e3);
}

// Three boxes, one on the other, far from the robot; a ball that comes down on them after 0.95 s.
WorldConfig tower(bool asleep, bool ball) {
  WorldConfig config;
  config.asleep = asleep;
  for (int i = 0; i < 3; ++i) config.loose.push_back(box_at("box" + std::to_string(i), {3.0, 0.0, 0.05 + 0.1 * i}));
  if (!ball) return config;
  LooseBody falling = box_at("ball", {3.05, 0.02, 4.8});
  falling.solid = {SolidShape::kSphere, {0.05, 0.0, 0.0}};
  falling.mass = 0.5;
  config.loose.push_back(falling);
  return config;
}

TEST(Sleep, ATowerThatLiesStopsMovingAtAll) {
  const Model model = test::bystander();
  ArticulatedWorld world(model, tower(true, false)), awake(model, tower(false, false));
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  ASSERT_EQ(awake.set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    ASSERT_EQ(awake.step(), Status::kOk);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(world.loose(i).velocity.isZero(0.0)) << i;
    EXPECT_LT((world.loose(i).pose.translation() - awake.loose(i).pose.translation()).norm(), 2e-5) << i;
  }
  EXPECT_TRUE(world.solved().empty());
  EXPECT_FALSE(awake.solved().empty());
}

TEST(Sleep, WhatIsHitWakesAndMovesAsIfItHadNotSlept) {
  const Model model = test::bystander();
  for (const int order : {1, 2}) {
    WorldConfig config = tower(true, true);
    config.order = order;
    ArticulatedWorld world(model, config);
    config.asleep = false;
    ArticulatedWorld awake(model, config);
    ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
    ASSERT_EQ(awake.set(Configuration(model)), Status::kOk);
    double slept = 0.0, fastest = 0.0;
    for (int i = 0; i < 600; ++i) {
      ASSERT_EQ(world.step(), Status::kOk);
      ASSERT_EQ(awake.step(), Status::kOk);
      slept += world.loose(0).velocity.isZero(0.0) ? config.step : 0.0;
      if (i > 450) fastest = std::max(fastest, world.loose(2).velocity.norm());
    }
    EXPECT_GT(slept, 0.5) << order;
    EXPECT_GT(fastest, 0.1) << order;
    for (int i = 0; i < world.loose_count(); ++i)
      EXPECT_LT((world.loose(i).pose.translation() - awake.loose(i).pose.translation()).norm(), 1e-3) << order << ' ' << i;
  }
}

// The springs under a tower that sleeps hold what they held.
TEST(Sleep, NoEnergyComesOrGoes) {
  const Model model = test::bystander();
  const WorldConfig config = tower(true, true);
  ArticulatedWorld world(model, config);
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  EnergyBalance balance(model, config);
  balance.begin(world);
  int asleep = 0;
  for (int i = 0; i < 600; ++i) {
    const double before = world.elastic_energy();
    const bool awake = !world.solved().empty();
    ASSERT_EQ(world.step(), Status::kOk);
    EXPECT_FALSE(balance.add(world, 0.0)) << i;
    EXPECT_FALSE(world.trust().any()) << i;
    asleep += world.solved().empty() ? 1 : 0;
    if (awake && world.solved().empty() && i > 10) { EXPECT_NEAR(world.elastic_energy(), before, 1e-6) << i; }
  }
  EXPECT_GT(asleep, 250);
}

// A robot that stands on it keeps a plate awake: to the last bit nothing is different.
TEST(Sleep, WhatARobotTouchesStaysAwake) {
  const Model model = test::block();
  WorldConfig config;
  LooseBody plate = box_at("plate", {0.0, 0.0, 0.0});
  plate.solid.size = {1.0, 1.0, 0.02};
  plate.start.pose.translation().z() = 0.01;
  config.loose.push_back(plate);
  ArticulatedWorld awake(model, config);
  config.asleep = true;
  ArticulatedWorld world(model, config);
  Configuration at = test::standing_block(model);
  at.base.translation().z() += 0.02;
  ASSERT_EQ(world.set(at), Status::kOk);
  ASSERT_EQ(awake.set(at), Status::kOk);
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    ASSERT_EQ(awake.step(), Status::kOk);
  }
  EXPECT_EQ(world.loose(0).pose.translation(), awake.loose(0).pose.translation());
  EXPECT_EQ(world.configuration().base.translation(), awake.configuration().base.translation());
}

TEST(Sleep, FallingAsleepAndWakingAllocateNothing) {
  const Model model = test::bystander();
  ArticulatedWorld world(model, tower(true, true));
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  test::step_without_allocation(world, 600);
}

// What rests on soft springs is deep in them when it wakes: that is no contact that was missed.
TEST(Sleep, WhatWakesDeepInItsSpringsIsNotDoubted) {
  const Model model = test::bystander();
  for (const int order : {1, 2}) {
    WorldConfig config = tower(true, true);
    config.order = order;
    for (int i = 0; i < 3; ++i) {  // 2.5 to 7 mm deep in the springs of four corners
      config.loose[static_cast<std::size_t>(i)].stiffness = 2e3;
      config.loose[static_cast<std::size_t>(i)].damping = 200.0;
    }
    ArticulatedWorld world(model, config);
    config.asleep = false;
    ArticulatedWorld awake(model, config);
    ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
    ASSERT_EQ(awake.set(Configuration(model)), Status::kOk);
    int woke = 0;
    for (int i = 0; i < 1000; ++i) {
      const bool slept = world.loose(0).velocity.isZero(0.0) && i > 0;
      ASSERT_EQ(world.step(), Status::kOk);
      ASSERT_EQ(awake.step(), Status::kOk);
      if (!slept || world.loose(0).velocity.isZero(0.0)) continue;
      ++woke;
      EXPECT_LE(world.trust()[Doubt::kDeep], awake.trust()[Doubt::kDeep]) << order << ' ' << i;
    }
    EXPECT_GT(woke, 0) << order;
  }
}

TEST(Sleep, OtherEnginesHaveNone) {
  for (const Engine engine : {Engine::kOde, Engine::kMujoco}) {
    for (const std::string key : {"asleep", "untouched", "aloft"}) {
      WorldConfig config = tower(key == "asleep", false);
      if (key == "untouched") config.untouched = {{0, 0}};
      if (key == "aloft") config.aloft = {{0, 0}};
      config.engine = engine;
      const std::string said = key + " is of engine articulated only";
      try {
        (void)make_world(test::bystander(), config);
        FAIL();
      } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace twinbus
