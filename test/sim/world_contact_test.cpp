// Soles on the ground, friction, and a body that lies on it.

#include <gtest/gtest.h>

#include <cmath>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/make_world.h"
#include "sim/world/world.h"
#include "test/obstacles.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

double vertical_force(const World& world) {
  double sum = 0.0;
  for (const ContactPoint& contact : world.contacts()) sum += contact.force.z();
  return sum;
}

TWINBUS_BOTH_ENGINES(ContactTest);

TEST_P(ContactTest, SolesSinkByWeightOverStiffness) {
  const Model model = test::block();
  const auto world_owner = make_at(Configuration(model), model);
  World& world = *world_owner;
  test::settle_block(world);
  const double weight = world.mass() * kGravity;
  EXPECT_NEAR(world.configuration().base.translation().z(), -weight / 2e5, 1e-7);
  EXPECT_NEAR(vertical_force(world), weight, 1e-3);
  for (const ContactPoint& contact : world.contacts())
    EXPECT_NEAR(contact.force.z(), weight / 8, 0.01 * weight);
}

TEST_P(ContactTest, NeverPulls) {
  const Model model = test::block();
  Configuration start(model);
  start.base.translation().z() = 0.2;
  start.base_velocity.x() = 0.3;
  const auto world_owner = make_at(start, model);
  World& world = *world_owner;
  bool flew = false, touched = false;
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    for (const ContactPoint& contact : world.contacts()) ASSERT_GE(contact.force.z(), 0.0);
    flew = flew || world.contacts().empty();
    touched = touched || vertical_force(world) > 1.0;
  }
  EXPECT_TRUE(flew);
  EXPECT_TRUE(touched);
}

// A sliding block stops after v^2 / (2 mu g), in every direction alike.
TEST_P(ContactTest, FrictionIsTheSameInEveryDirection) {
  for (const double angle : {0.0, 0.4, 0.785, 1.2}) {
    Model model = test::block();
    for (Sole& sole : model.soles) sole.friction = 0.4;
    for (Link& link : model.links) link.collision.clear();
    WorldConfig config;
    config.ground_friction = 0.4;
    Configuration start = test::standing_block(model);
    start.base_velocity = {1.0 * std::cos(angle), 1.0 * std::sin(angle), 0.0};
    const auto world_owner = make_at(start, model, config);
    World& world = *world_owner;
    ASSERT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 10}), Status::kOk);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(world.step(), Status::kOk);
    const double expected = 1.0 / (2.0 * 0.4 * kGravity);
    EXPECT_NEAR(world.configuration().base.translation().head<2>().norm(), expected,
                0.03 * expected)
        << angle;
    EXPECT_LT(world.configuration().base_velocity.norm(), 1e-3);
  }
}

TEST_P(ContactTest, AHigherGroundUnderOneSoleTiltsTheBody) {
  const Model model = test::block();
  WorldConfig config;
  config.ground_height = {0.003, 0.0};
  const auto world_owner = make_at(Configuration(model), model, config);
  World& world = *world_owner;
  test::settle_block(world);
  const double roll = std::asin(world.configuration().base.linear()(2, 1));
  EXPECT_NEAR(roll, 0.003 / 0.3, 0.002);
}

TEST_P(ContactTest, ABodyOnItsSideLiesOnTheGround) {
  const Model model = test::block();
  Configuration start(model);
  start.base.translation().z() = 0.3;
  start.base.linear() = Eigen::AngleAxisd(1.45, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto world_owner = make_at(start, model);
  World& world = *world_owner;
  test::settle_block(world);
  EXPECT_NEAR(world.configuration().base.translation().z(), 0.2, 0.01);
  EXPECT_LT(world.configuration().base_velocity.norm(), 1e-2);
  EXPECT_NEAR(vertical_force(world), world.mass() * kGravity, 1.0);
}

TEST_P(ContactTest, AnObstacleIsInTheWay) {
  Model model = test::block();
  WorldConfig config;
  const Obstacle wall = test::box_at({0.4, 0, 0.5}, {0.1, 2.0, 1.0});
  config.obstacles = {wall};
  config.ground_friction = 0.0;
  Configuration start = test::standing_block(model);
  start.base_velocity.x() = 1.0;
  const auto world_owner = make_at(start, model, config);
  World& world = *world_owner;
  for (int i = 0; i < 500; ++i) ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_LT(world.configuration().base.translation().x(), 0.17);
}

TEST_P(ContactTest, ACornerOffsetLowersTheGroundThere) {
  const Model model = test::block();
  const auto world_owner = make(model);
  World& world = *world_owner;
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  for (int side = 0; side < 2; ++side) {
    for (int corner = 0; corner < kSoleCorners; ++corner)
      world.set_corner_offset(side, corner, 0.001);
  }
  test::settle_block(world);
  EXPECT_NEAR(world.configuration().base.translation().z(), -0.001 - world.mass() * kGravity / 2e5,
              1e-6);
}

// What comes down within a step is stopped in it, not in the next: a millimetre above the ground at
// 1 m/s the soles push back at once, with either engine's law the same, and what only comes near
// does not touch.
TEST_P(ContactTest, ALandingBeginsInTheStepInWhichItComes) {
  const Model model = test::block();
  for (const double height : {1e-3, 3e-3}) {
    const auto world = make(model);  // steps of 2 ms
    Configuration start(model);
    start.base.translation().z() = height;
    start.base_velocity.z() = -1.0;
    ASSERT_EQ(world->set(start), Status::kOk);
    ASSERT_EQ(world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 10}), Status::kOk);
    ASSERT_EQ(world->step(), Status::kOk);
    if (height < 2e-3) {
      EXPECT_NEAR(vertical_force(*world), 1080.0, 1.0);
    } else {
      EXPECT_TRUE(world->contacts().empty());
    }
  }
}

TEST(RigidContact, IsOfEngineOdeOnly) {
  const Model model = test::block();
  WorldConfig config;
  config.contact = ContactModel::kRigid;
  EXPECT_THROW(make_world(model, config), std::runtime_error);
}

// Nothing sinks in: the block rests at the top of the layer that keeps contacts, however soft its
// soles, and carries its weight without trembling.
TEST(RigidContact, ABlockRestsOnItsSurfaceAndLandsAtOnce) {
  Model model = test::block();
  for (Sole& sole : model.soles) sole.stiffness = 1e4;
  WorldConfig config;
  config.engine = Engine::kOde;
  config.contact = ContactModel::kRigid;
  config.step = 1e-3;
  const auto world = make_world(model, config);
  Configuration start(model);
  start.base.translation().z() = 0.01;
  ASSERT_EQ(world->set(start), Status::kOk);
  ASSERT_EQ(world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 10}), Status::kOk);
  double highest = 0.0;
  const auto weight_on_soles = [&] {
    double sum = 0.0;
    for (const ContactPoint& c : world->contacts()) sum += c.force.z();
    return sum;
  };
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(world->step(), Status::kOk);
    highest = std::max(highest, weight_on_soles());
  }
  EXPECT_NEAR(world->configuration().base.translation().z(), 0.0, 1.5e-4);
  EXPECT_LT(world->configuration().base_velocity.norm(), 1e-6);
  EXPECT_NEAR(weight_on_soles(), world->mass() * kGravity, 1e-3 * world->mass() * kGravity);
  // All of its momentum within a step: 0.44 m/s, 20.5 kg in 1 ms.
  EXPECT_GT(highest, 20.0 * world->mass() * kGravity);
}

}  // namespace
}  // namespace twinbus
