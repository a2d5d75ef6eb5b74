// Soles on the ground, friction, and a body that lies on it.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

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

// Rolling and torsional friction against closed forms, in both engines and under every law of contact that has them.

constexpr double kBallRadius = 0.1, kMass = 2.0;  // of ball and disc [m], [kg]
constexpr ContactModel kLaws[] = {ContactModel::kSpringDamper, ContactModel::kHuntCrossley, ContactModel::kPatch};

LooseBody round_body(SolidShape shape, double height) {
  const Eigen::Isometry3d pose(Eigen::Translation3d(0.0, 0.0, height));
  LooseBody body = test::loose_box("body", kMass, {kBallRadius, shape == SolidShape::kCylinder ? 2.0 * height : 0.0, 0.0}, pose, 1e6,
                                   std::sqrt(0.25 * 1e6 * kMass));
  body.solid.shape = shape;
  return body;
}

TWINBUS_BOTH_ENGINES(TurningTest);

// After it came to rest under this law, moved so.
std::unique_ptr<World> moving(const std::function<std::unique_ptr<World>(const WorldConfig&)>& make, WorldConfig config,
                              const Eigen::Vector3d& velocity, const Eigen::Vector3d& spin) {
  auto world = make(config);
  for (int i = 0; i < 500; ++i) EXPECT_EQ(world->step(), Status::kOk);
  LooseState state = world->loose(0);
  state.velocity = velocity;
  state.angular_velocity = spin;
  EXPECT_EQ(world->set_loose(0, state), Status::kOk);
  return world;
}

// Rolls without sliding: (m + I / r^2) dv/dt = -c m g / r, I = 2/5 m r^2.
TEST_P(TurningTest, ARollingBallStopsWhereItShould) {
  const Model model = test::bystander();
  const double c = 2e-3, speed = 0.4, slower = 5.0 / 7.0 * c * kGravity / kBallRadius;
  for (const ContactModel law : kLaws) {
    WorldConfig config;
    config.contact = law;
    config.rolling_friction = c;
    config.loose = {round_body(SolidShape::kSphere, kBallRadius)};
    const auto world = moving([&](const WorldConfig& asked) { return make(model, asked); }, config, {speed, 0, 0}, {0, speed / kBallRadius, 0});
    const Eigen::Vector3d start = world->loose(0).pose.translation();
    const int half = static_cast<int>(std::lround(0.5 * speed / slower / config.step));
    for (int i = 0; i < half; ++i) ASSERT_EQ(world->step(), Status::kOk);
    EXPECT_NEAR(world->loose(0).velocity.x(), 0.5 * speed, 0.01 * speed) << kContactNames[static_cast<int>(law)];
    for (int i = 0; i < half + 250; ++i) ASSERT_EQ(world->step(), Status::kOk);
    EXPECT_NEAR(world->loose(0).pose.translation().x() - start.x(), 0.5 * speed * speed / slower, 0.01 * speed * speed / slower)
        << kContactNames[static_cast<int>(law)];
    EXPECT_LT(world->loose(0).velocity.norm(), 1e-3) << kContactNames[static_cast<int>(law)];
  }
}

// I dw/dt = -c m g: a ball on its one point, and a disc that slides on its face without any other friction.
TEST_P(TurningTest, ASpinningBallAndASpinningDiscStopWhenTheyShould) {
  const Model model = test::bystander();
  const double c = 3e-3, spin = 10.0;
  for (const SolidShape shape : {SolidShape::kSphere, SolidShape::kCylinder}) {
    const double share = shape == SolidShape::kSphere ? 0.4 : 0.5;  // I = share m r^2
    const double slower = c * kGravity / (share * kBallRadius * kBallRadius);
    for (const ContactModel law : kLaws) {
      WorldConfig config;
      config.contact = law;
      config.torsional_friction = c;
      config.loose = {round_body(shape, shape == SolidShape::kSphere ? kBallRadius : 0.02)};
      if (shape == SolidShape::kCylinder) config.loose[0].friction = config.ground_friction = 0.0;
      const auto world = moving([&](const WorldConfig& asked) { return make(model, asked); }, config, {0, 0, 0}, {0, 0, spin});
      const int half = static_cast<int>(std::lround(0.5 * spin / slower / config.step));
      const std::string who = std::string(kContactNames[static_cast<int>(law)]) + (shape == SolidShape::kSphere ? " ball" : " disc");
      for (int i = 0; i < half; ++i) ASSERT_EQ(world->step(), Status::kOk);
      EXPECT_NEAR(world->loose(0).angular_velocity.z(), 0.5 * spin, 0.02 * spin) << who;
      for (int i = 0; i < half * 21 / 20; ++i) ASSERT_EQ(world->step(), Status::kOk);
      EXPECT_LT(std::abs(world->loose(0).angular_velocity.z()), 0.01 * spin) << who;
    }
  }
}

// On a slope a ball rolls where r tan(slope) is more than the rolling friction, and stays where it is less.
TEST_P(TurningTest, ABallStaysOnASlopeThatItsRollingFrictionHolds) {
  const Model model = test::bystander();
  const double slope = 0.01;
  for (const double c : {0.5 * kBallRadius * slope, 2.0 * kBallRadius * slope}) {
    WorldConfig config;
    config.rolling_friction = c;
    Obstacle plank{.shape = ObstacleShape::kBox, .size = {4.0, 4.0, 1.0}};
    plank.pose.linear() = Eigen::AngleAxisd(slope, Eigen::Vector3d::UnitY()).toRotationMatrix();
    plank.pose.translation() = 1.0 * Eigen::Vector3d::UnitZ() - 0.5 * plank.pose.linear().col(2);
    config.obstacles = {plank};
    config.loose = {round_body(SolidShape::kSphere, 1.0 + kBallRadius)};
    const auto world = make(model, config);
    for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
    const double begun = world->loose(0).pose.translation().x();
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(), Status::kOk);
    const double way = world->loose(0).pose.translation().x() - begun;
    if (c > kBallRadius * slope) {
      EXPECT_NEAR(way, 0.0, 1e-5);
    } else {
      EXPECT_GT(way, 0.05);  // half of g slope is left, 5/7 of it for the way
    }
  }
}

// Soles without any other friction: I dw/dt = -c m g, and the feet feel it.
TEST_P(TurningTest, SolesResistSpinning) {
  const Model model = test::block();
  const double c = 0.01, spin = 0.5;
  for (const ContactModel law : kLaws) {
    WorldConfig config;
    config.contact = law;
    config.ground_friction = 0.0;
    config.torsional_friction = c;
    const auto world = make_at(test::standing_block(model), model, config);
    for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
    Configuration now = world->configuration();
    now.base_angular_velocity = {0, 0, spin};
    ASSERT_EQ(world->set(now), Status::kOk);
    const double slower = c * world->mass() * kGravity / (model.links[0].inertia(2, 2) + model.links[1].inertia(2, 2));
    const int half = static_cast<int>(std::lround(0.5 * spin / slower / config.step));
    ASSERT_GT(half, 3);
    for (int i = 0; i < half; ++i) ASSERT_EQ(world->step(), Status::kOk);
    const std::string who = kContactNames[static_cast<int>(law)];
    EXPECT_NEAR(world->configuration().base_angular_velocity.z(), spin - slower * config.step * half, 0.05 * spin) << who;
    double moment = 0.0;
    for (const ContactPoint& contact : world->contacts()) moment += contact.moment.z();
    EXPECT_NEAR(moment, -c * world->mass() * kGravity, 0.02 * c * world->mass() * kGravity) << who;
  }
}

TEST_P(TurningTest, WithoutItNothingStopsABall) {
  const Model model = test::bystander();
  WorldConfig config;
  config.loose = {round_body(SolidShape::kSphere, kBallRadius)};
  const auto world = moving([&](const WorldConfig& asked) { return make(model, asked); }, config, {0.4, 0, 0}, {0, 4, 0});
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).velocity.x(), 0.4, 0.004);
}

// A ball on a box that is free itself: what one gets, the other loses.
TEST(TurningMoment, OfTwoBodiesIsThatOfBoth) {
  WorldConfig config;
  config.ground_friction = 0.0;
  config.torsional_friction = 3e-3;
  const Eigen::Isometry3d low(Eigen::Translation3d(0.0, 0.0, 0.05));
  config.loose = {round_body(SolidShape::kSphere, 0.1 + kBallRadius), test::loose_box("plate", 1.0, {0.3, 0.3, 0.1}, low, 1e5, 150.0)};
  config.loose[0].start.angular_velocity.z() = 5.0;
  config.loose[1].friction = 0.0;
  config.loose[1].start.angular_velocity.z() = -3.0;
  const Model model = test::bystander();
  const auto world = make_world(model, config);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(world->step(), Status::kOk);
  const double ball = world->loose(0).angular_velocity.z(), plate = world->loose(1).angular_velocity.z();
  for (int i = 0; i < 50; ++i) ASSERT_EQ(world->step(), Status::kOk);
  // The ground slows the plate too, with all of the weight.
  const double seconds = 50 * config.step, of_pair = 3e-3 * kMass * kGravity, of_ground = 3e-3 * (kMass + 1.0) * kGravity;
  const double of_ball = 0.4 * kMass * kBallRadius * kBallRadius, of_plate = (0.3 * 0.3 + 0.3 * 0.3) / 12.0;
  EXPECT_NEAR(world->loose(0).angular_velocity.z() - ball, -seconds * of_pair / of_ball, 0.05 * seconds * of_pair / of_ball);
  EXPECT_NEAR(world->loose(1).angular_velocity.z() - plate, seconds * (of_pair + of_ground) / of_plate,
              0.05 * seconds * (of_pair + of_ground) / of_plate);
  config.torsional_friction = 0.0;
  const auto free = make_world(model, config);
  for (int i = 0; i < 50; ++i) ASSERT_EQ(free->step(), Status::kOk);
  EXPECT_NEAR(free->loose(0).angular_velocity.z(), 5.0, 1e-9);
}

TEST(TurningMoment, WhatHasNoneRefusesIt) {
  const Model model = test::bystander();
  WorldConfig config;
  config.rolling_friction = 1e-3;
  config.contact = ContactModel::kSoft;
  EXPECT_THROW(make_world(model, config), std::runtime_error);
}

}  // namespace
}  // namespace twinbus
