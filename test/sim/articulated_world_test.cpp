// What the articulated engine promises beyond what every engine does (world_*_test.cpp).

#include "sim/engine/make_world.h"
#include "sim/engine/articulated_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "sim/engine/ode_world.h"
#include "common/math/random.h"
#include "sim/world/static_equilibrium.h"
#include "common/allocation/no_alloc.h"
#include "test/obstacles.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

// hrp1s in half_sitting, its servos holding the pose.
class Humanoid : public ::testing::Test {
 protected:
  Humanoid() : model(load_robot("hrp1s")), q(Eigen::VectorXd::Zero(model.joint_count())) {
    const auto pose = static_cast<std::size_t>(model.find_pose("half_sitting"));
    for (std::size_t j = 0; j < model.joints.size(); ++j) {
      q[static_cast<Eigen::Index>(j)] = model.poses[pose].q[j];
    }
  }
  Standing standing(const World& world) const {
    return stand(model, q, 1.0, {world.corner_stiffness(0), world.corner_stiffness(1)}, {0.0, 0.0},
                 false);
  }
  void hold(World& world, const Eigen::VectorXd& tau, double gain = 1.0) const {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      ASSERT_EQ(
          world.set_servo(
              j,
              {.q = q[j], .qd = 0.0, .tau = tau[j], .kp = gain * joint.kp, .kd = gain * joint.kd}),
          Status::kOk);
    }
  }
  // In the air, turning.
  Configuration thrown() const {
    Configuration at(model);
    at.q = q;
    at.qd.setZero();
    at.base.translation().z() = 1.5;
    at.base.linear() =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 0.5, 0.0).normalized()).toRotationMatrix();
    at.base_velocity = {0.5, 0.2, 0.0};
    at.base_angular_velocity = {1.0, 2.0, 0.5};
    return at;
  }

  const Model model;
  Eigen::VectorXd q;
};

TEST_F(Humanoid, StandsOnTheSameForcesInBothEngines) {
  std::vector<std::vector<ContactPoint>> contacts;
  for (const Engine engine : {Engine::kArticulated, Engine::kOde}) {
    WorldConfig config;
    config.engine = engine;
    const auto world = make_world(model, config);
    const Standing start = standing(*world);
    ASSERT_EQ(world->set(start.configuration, &start.tau), Status::kOk);
    hold(*world, Eigen::VectorXd::Zero(model.joint_count()));  // it settles into its servos
    for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
    contacts.push_back(world->contacts());
  }
  ASSERT_EQ(contacts[0].size(), 8U);
  ASSERT_EQ(contacts[1].size(), 8U);
  const double weight = model.total_mass() * kGravity;
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(contacts[0][i].force.z(), contacts[1][i].force.z(), 0.01 * weight / 8) << i;
  }
}

TEST_F(Humanoid, OneStepStandingIsOnePassAndAllocatesNothing) {
  ArticulatedWorld world(model, {});
  const Standing start = standing(world);
  ASSERT_EQ(world.set(start.configuration, &start.tau), Status::kOk);
  hold(world, start.tau);
  ASSERT_EQ(world.step(), Status::kOk);
  const NoAlloc guard;
  for (int i = 0; i < 500; ++i) (void)world.step();
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(world.counters().one_pass, world.counters().steps);
  EXPECT_EQ(world.joint_passes(), 0);
}

// Their law bends with the speed: a stand that is shoved is folded in again, not solved by Newton.
TEST_F(Humanoid, ShovedOnHuntAndCrossleysGroundItNeedsHardlyAnIteration) {
  for (const ContactModel law : {ContactModel::kHuntCrossley, ContactModel::kPatch}) {
    WorldConfig config;
    config.contact = law;
    ArticulatedWorld world(model, config);
    Standing start = standing(world);
    start.configuration.base_velocity = {0.05, 0.02, 0.0};
    ASSERT_EQ(world.set(start.configuration, &start.tau), Status::kOk);
    hold(world, start.tau);
    const NoAlloc guard;
    for (int i = 0; i < 400; ++i) ASSERT_EQ(world.step(), Status::kOk);
    EXPECT_EQ(guard.count(), 0);
    EXPECT_LT(world.counters().newton, world.counters().steps / 10) << kContactNames[static_cast<int>(law)];
  }
}

TEST_F(Humanoid, ThrownItEndsOnTheGround) {
  ArticulatedWorld world(model, {});
  ASSERT_EQ(world.set(thrown()), Status::kOk);
  hold(world, Eigen::VectorXd::Zero(model.joint_count()), 0.1);
  double deepest = 0.0, force = 0.0;
  const NoAlloc guard;
  for (int i = 0; i < 4000; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    force = 0.0;
    for (const ContactPoint& contact : world.contacts()) {
      deepest = std::max(deepest, contact.depth);
      force += contact.force.z();
      const double side = contact.force.head<2>().norm();
      ASSERT_LE(side, 0.8 * contact.force.z() * (1.0 + 1e-10));
    }
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_LT(deepest, 0.05);
  EXPECT_LT(world.com_velocity().norm(), 0.1);
  EXPECT_NEAR(force, world.mass() * kGravity, 0.2 * world.mass() * kGravity);
  EXPECT_LT(world.com().z(), 0.5);
  EXPECT_EQ(world.counters().unconverged, 0);
  EXPECT_EQ(world.unsettled(), 0);
}

// No stiffness of servo or ground limits the step; all 128 combinations: ./twinbus bench physics map.
TEST_F(Humanoid, StandsAtEveryStepGainAndGround) {
  for (const int order : {1, 2}) {
    for (const double gain : {0.3, 10.0}) {
      for (const double ground : {0.1, 100.0}) {  // times 1e6 N/m under a sole
        for (const double step : {1e-3, 5e-3, 2e-2}) {
          WorldConfig config;
          config.order = order;
          config.step = step;
          config.stiffness_scale = ground;
          config.damping_scale = std::sqrt(ground);
          ArticulatedWorld world(model, config);
          Standing start = standing(world);
          start.configuration.base_velocity = {0.02, 0.02, 0.0};
          ASSERT_EQ(world.set(start.configuration, &start.tau), Status::kOk);
          hold(world, start.tau, gain);
          const int steps = static_cast<int>(0.6 / step);
          double late = 0.0;
          for (int i = 0; i < steps; ++i) {
            ASSERT_EQ(world.step(), Status::kOk);
            if (i > 2 * steps / 3) late = std::max(late, world.com_velocity().norm());
          }
          EXPECT_LT(late, 0.05) << order << ' ' << gain << ' ' << ground << ' ' << step;
        }
      }
    }
  }
}

TEST_F(Humanoid, EveryInstructionSetGivesTheSameToRounding) {
  std::vector<Configuration> ends;
  for (const Simd level : {Simd::kBaseline, Simd::kAvx2, Simd::kAvx512}) {
    lower_simd(level);
    ArticulatedWorld world(model, {});
    EXPECT_EQ(world.set(thrown()), Status::kOk);
    hold(world, Eigen::VectorXd::Zero(model.joint_count()));
    for (int i = 0; i < 10; ++i) EXPECT_EQ(world.step(), Status::kOk);
    ends.push_back(world.configuration());
  }
  lower_simd(Simd::kAvx512);
  for (const Configuration& end : ends) {
    EXPECT_LT((end.q - ends[0].q).norm(), 1e-12);
    EXPECT_LT((end.base.translation() - ends[0].base.translation()).norm(), 1e-12);
  }
}

TEST_F(Humanoid, StopsHoldToABillionthWhateverIsAsked) {
  ArticulatedWorld world(model, {});
  ASSERT_EQ(world.set(thrown()), Status::kOk);
  Random random(9);
  double worst = 0.0;
  for (int i = 0; i < 500; ++i) {
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      if (i % 10 == 0) {
        ASSERT_EQ(world.set_servo(j, {.q = world.configuration().q[j] + 2.0 * random.normal(),
                                      .qd = 0.0,
                                      .tau = 0.0,
                                      .kp = joint.kp,
                                      .kd = joint.kd}),
                  Status::kOk);
      }
    }
    ASSERT_EQ(world.step(), Status::kOk);
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      const double at = world.configuration().q[j];
      worst = std::max({worst, at - joint.upper, joint.lower - at});
      ASSERT_LE(std::abs(world.tau(j)), joint.effort);
    }
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_EQ(world.unsettled(), 0);
}

// Bit by bit: repeated, and continued from a configuration that was read out of it in flight.
TEST_F(Humanoid, SameStartSameBits) {
  ArticulatedWorld one(model, {}), two(model, {});
  for (ArticulatedWorld* world : {&one, &two}) {
    ASSERT_EQ(world->set(thrown()), Status::kOk);
    hold(*world, Eigen::VectorXd::Zero(model.joint_count()));
  }
  const auto same = [&] {
    const Configuration &a = one.configuration(), &b = two.configuration();
    return a.q == b.q && a.qd == b.qd && a.base.matrix() == b.base.matrix() &&
           a.base_velocity == b.base_velocity && a.base_angular_velocity == b.base_angular_velocity;
  };
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(one.step(), Status::kOk);
    ASSERT_EQ(two.step(), Status::kOk);
    if (i == 100) {
      const Configuration saved = two.configuration();
      ASSERT_EQ(two.set(saved), Status::kOk);
    }
    ASSERT_TRUE(same()) << i;
  }
}

// A robot that has fallen and slides: another world takes over, and both go on.
TEST_F(Humanoid, AnotherWorldResumesBitByBit) {
  for (const int order : {1, 2}) {
    WorldConfig config;
    config.order = order;
    ArticulatedWorld one(model, config), two(model, config);
    ASSERT_EQ(one.set(thrown()), Status::kOk);
    hold(one, Eigen::VectorXd::Zero(model.joint_count()));
    for (int i = 0; i < 700; ++i) ASSERT_EQ(one.step(), Status::kOk);
    ASSERT_FALSE(one.contacts().empty());
    {
      const NoAlloc guard;
      ASSERT_TRUE(two.resume(one));
      EXPECT_EQ(guard.count(), 0);
    }
    for (int i = 0; i < 200; ++i) {
      ASSERT_EQ(one.step(), Status::kOk);
      ASSERT_EQ(two.step(), Status::kOk);
      const Configuration &a = one.configuration(), &b = two.configuration();
      ASSERT_EQ(a.q, b.q) << i;
      ASSERT_EQ(a.qd, b.qd) << i;
      ASSERT_EQ(a.base.matrix(), b.base.matrix()) << i;
    }
  }
}

// A block pushed for a while on its two soles: error against a fine run of the same engine, and the
// fine runs of both.
Eigen::Vector3d pushed_block(Engine engine, double step, int order = 1) {
  const Model model = test::block();
  WorldConfig config;
  config.engine = engine;
  config.step = step;
  config.order = order;
  const auto world = make_world(model, config);
  Configuration start(model);
  start.base.translation().z() = -world->mass() * kGravity / 2e5;
  EXPECT_EQ(world->set(start), Status::kOk);
  EXPECT_EQ(world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 20}), Status::kOk);
  const int steps = static_cast<int>(std::lround(0.1 / step));
  for (int i = 0; i < steps; ++i) {
    const Eigen::Vector3d point = world->link_in_world(0) * Eigen::Vector3d(0.0, 0.0, 0.2);
    if (i < steps / 2) {
      EXPECT_EQ(world->push(0, point, {30.0, 60.0, 0.0}), Status::kOk);
    }
    EXPECT_EQ(world->step(), Status::kOk);
  }
  return world->link_in_world(0) * Eigen::Vector3d(0.0, 0.0, 0.2);
}

// Strong servos that are sent far beyond the stops: none is passed and every step settles.
TEST(ArticulatedWorld, StopsHoldAgainstServosOfAnyStrengthAtAnyStep) {
  const Model model = load_robot("hrp1s");
  const auto pose = static_cast<std::size_t>(model.find_pose("half_sitting"));
  for (const int order : {1, 2, 3}) {
    for (const double step : {2e-2, 1e-2, 1e-3}) {
      ArticulatedWorld world(model, test::stepped(step, order));
      Configuration start(model);
      start.base.translation().z() = 10.0;
      start.base_angular_velocity = {1.0, 2.0, 0.5};
      for (int j = 0; j < model.joint_count(); ++j) {
        start.q[j] = model.poses[pose].q[static_cast<std::size_t>(j)];
      }
      ASSERT_EQ(world.set(start), Status::kOk);
      for (int j = 0; j < model.joint_count(); ++j) {
        const Joint& joint = model.joints[static_cast<std::size_t>(j)];
        ASSERT_EQ(world.set_servo(j, {.q = start.q[j] + 2.0,
                                      .qd = 0,
                                      .tau = 0,
                                      .kp = 10.0 * joint.kp,
                                      .kd = 10.0 * joint.kd}),
                  Status::kOk);
      }
      for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(world.step(), Status::kOk);
        for (int j = 0; j < model.joint_count(); ++j) {
          const Joint& joint = model.joints[static_cast<std::size_t>(j)];
          const double q = world.configuration().q[j];
          ASSERT_LE(std::max(q - joint.upper, joint.lower - q), 1e-9) << joint.name << ' ' << step;
          ASSERT_LE(std::abs(world.tau(j)), joint.effort);
        }
      }
      EXPECT_EQ(world.unsettled(), 0) << order << ' ' << step;
    }
  }
}

// A humanoid on its own stiff servos, dropped 10 mm with 0.2 m/s forward, after 0.6 s.
std::vector<Eigen::Vector3d> landed_humanoid(const std::shared_ptr<const Model>& model, double step,
                                             int order) {
  const int pose = model->find_pose("half_sitting");
  Eigen::VectorXd q(model->joint_count());
  for (int j = 0; j < q.size(); ++j) {
    q[j] = model->poses[static_cast<std::size_t>(pose)].q[static_cast<std::size_t>(j)];
  }
  Eigen::Isometry3d above = Eigen::Isometry3d::Identity();
  above.translation().z() = 0.01;
  OtherRobot robot = standing_robot("humanoid", model, q, above);
  robot.start.base_velocity.x() = 0.2;
  ArticulatedWorld world(*model, test::stepped(step, order));
  EXPECT_EQ(world.set(robot.start), Status::kOk);
  for (int j = 0; j < q.size(); ++j) {
    EXPECT_EQ(world.set_servo(j, robot.servos[static_cast<std::size_t>(j)]), Status::kOk);
  }
  for (int i = 0; i < std::lround(0.6 / step); ++i) EXPECT_EQ(world.step(), Status::kOk);
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < model->link_count(); ++i) {
    places.emplace_back(world.link_in_world(i) * model->links[static_cast<std::size_t>(i)].com);
  }
  return places;
}

// What the landing has shaken rings on for many steps; order 2 resolves it.
TEST(ArticulatedWorld, AtOrder2AHumanoidLandsWithinAFiftiethOfAMillimetre) {
  const auto model = std::make_shared<const Model>(load_robot("hrp1s"));
  const std::vector<Eigen::Vector3d> coarse = landed_humanoid(model, 2e-3, 2);
  const std::vector<Eigen::Vector3d> fine = landed_humanoid(model, 1.25e-4, 3);
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_LT((coarse[i] - fine[i]).norm(), 2e-5) << i;
}

// A block that lands on its soles while it moves along.
Eigen::Vector3d dropped_block(double step, int order) {
  const Model model = test::block();
  ArticulatedWorld world(model, test::stepped(step, order));
  Configuration start(model);
  start.base.translation().z() = 0.01;
  start.base_velocity.x() = 0.2;
  EXPECT_EQ(world.set(start), Status::kOk);
  EXPECT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 20}), Status::kOk);
  for (long i = 0; i < std::lround(0.2 / step); ++i) EXPECT_EQ(world.step(), Status::kOk);
  return world.link_in_world(0) * Eigen::Vector3d(0.0, 0.0, 0.2);
}

TEST(ArticulatedWorld, ALandingWithinAStepIsFoundAndTakenInParts) {
  const Eigen::Vector3d fine = dropped_block(5e-5, 3);
  EXPECT_LT((dropped_block(5e-5, 2) - fine).norm(), 2e-6);
  for (const double step : {1e-2, 5e-3, 2e-3}) {
    const double rough = (dropped_block(step, 1) - fine).norm();
    EXPECT_LT((dropped_block(step, 2) - fine).norm(), rough / 8) << step;
    EXPECT_LT((dropped_block(step, 3) - fine).norm(), rough / 20) << step;
  }
}

// One step of 0.2 s in which the block lands, then lies: what is tried in vain costs little, and small parts are for the
// landing only.
TEST(ArticulatedWorld, WhatFollowsALandingWithinALongStepIsTakenInLargeParts) {
  const Model model = test::block();
  ArticulatedWorld world(model, test::stepped(0.2, 2));
  Configuration start(model);
  start.base.translation().z() = 0.01;
  ASSERT_EQ(world.set(start), Status::kOk);
  ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_LT(world.configuration().base_velocity.norm(), 2e-3);
  EXPECT_LT(world.counters().newton, 10);  // 17 if what comes to touch is solved for before the step is divided
  EXPECT_LT(world.work(), 45.0);           // 50 if parts grow from step to step only
}

TEST(ArticulatedWorld, APushConvergesToWhatTheOtherEngineFinds) {
  const Eigen::Vector3d fine = pushed_block(Engine::kArticulated, 1e-5);
  const double error_2 = (pushed_block(Engine::kArticulated, 2e-3) - fine).norm();
  const double error_05 = (pushed_block(Engine::kArticulated, 5e-4) - fine).norm();
  const double error_01 = (pushed_block(Engine::kArticulated, 1e-4) - fine).norm();
  EXPECT_LT(error_05, 0.5 * error_2);
  EXPECT_LT(error_01, 0.4 * error_05);
  EXPECT_LT((pushed_block(Engine::kOde, 1e-4) - fine).norm(), 1e-4);
}

TEST(ArticulatedWorld, OrderTwoIsBetterThanATenthOfTheStep) {
  const Eigen::Vector3d fine = pushed_block(Engine::kArticulated, 2e-5, 2);
  const double first = (pushed_block(Engine::kArticulated, 2e-4) - fine).norm();
  const double second = (pushed_block(Engine::kArticulated, 2e-3, 2) - fine).norm();
  EXPECT_LT(second, first);
}

TEST(ArticulatedWorld, InFlightMomentumIsKeptAndEnergyAtTheOrderOfTheStep) {
  const Model model = test::chain(6, true);
  Kinematics kinematics(model);
  for (const int order : {1, 2, 3}) {
    const int coarser = order == 3 ? 8 : 1;  // or there is nothing but rounding to see
    double drift[3] = {};
    for (int k = 0; k < 3; ++k) {
      WorldConfig config;
      config.order = order;
      config.step = 0.001 * coarser / (1 << k);
      ArticulatedWorld world(model, config);
      Configuration start(model);
      start.base.translation().z() = 50.0;
      start.base_angular_velocity = {1.0, -0.5, 0.7};
      start.qd << 0.5, -1.0, 0.3, 0.8, -0.2, 0.4;
      ASSERT_EQ(world.set(start), Status::kOk);
      const double before = test::energy(model, world, kinematics);
      const Eigen::Vector3d spin = kinematics.angular_momentum();
      const Eigen::Vector3d velocity = kinematics.com_velocity();
      const int steps = 512 * (1 << k) / coarser;
      for (int i = 0; i < steps; ++i) ASSERT_EQ(world.step(), Status::kOk);
      // The centre of mass itself falls half a step's speed too far at order 1.
      const double fall = order == 1 ? 0.5 * config.step * kGravity * kGravity * 0.512 : 0.0;
      drift[k] = std::abs(test::energy(model, world, kinematics) - before + world.mass() * fall);
      EXPECT_LT((kinematics.angular_momentum() - spin).norm(), 1e-10);
      EXPECT_NEAR((kinematics.com_velocity() - velocity).head<2>().norm(), 0.0, 1e-11);
    }
    const double ratio = 1 << order;
    EXPECT_NEAR(drift[0] / drift[1], ratio, 0.2 * ratio);
    EXPECT_NEAR(drift[1] / drift[2], ratio, 0.2 * ratio);
  }
}

// A sliding block stops after v^2 / (2 mu g) less half a step's way, exactly alike in all
// directions.
TEST(ArticulatedWorld, FrictionHasNoFavouriteDirection) {
  Model model = test::block();
  for (Sole& sole : model.soles) sole.friction = 0.4;
  model.links[0].collision.clear();
  WorldConfig config;
  config.ground_friction = 0.4;
  double first = 0.0;
  for (const double angle : {0.0, 0.785, 2.0}) {
    ArticulatedWorld world(model, config);
    Configuration start(model);
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    start.base.linear() = turn;
    start.base.translation().z() = -world.mass() * kGravity / 2e5;
    start.base_velocity = turn * Eigen::Vector3d(1.0, 0.0, 0.0);
    ASSERT_EQ(world.set(start), Status::kOk);
    ASSERT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 10}), Status::kOk);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(world.step(), Status::kOk);
    const double way = world.configuration().base.translation().head<2>().norm();
    const double expected = 1.0 / (2.0 * 0.4 * kGravity) - 0.5 * config.step;
    EXPECT_NEAR(way, expected, 0.005 * expected);
    if (angle == 0.0) first = way;
    EXPECT_NEAR(way, first, 1e-6);
    EXPECT_EQ(world.counters().unconverged, 0);
    const double speed = world.configuration().base_velocity.norm();
    EXPECT_LT(speed, 1e-9) << "it creeps";
  }
}

// A hand pressed on a table stops at its surface; a sole on a box stands on it as on the ground.
TEST(ArticulatedWorld, ObstaclesCarry) {
  const Model model = test::block();
  WorldConfig config;
  const Obstacle box = test::box_at({0.0, 0.0, 0.15}, {1.0, 1.0, 0.3});
  config.obstacles = {box};
  ArticulatedWorld world(model, config);
  Configuration start(model);
  start.base.translation().z() = 0.32;
  ASSERT_EQ(world.set(start), Status::kOk);
  test::settle_block(world);
  EXPECT_NEAR(world.configuration().base.translation().z(), 0.3, 1e-3);
  EXPECT_LT(world.configuration().base_velocity.norm(), 1e-6);
}

}  // namespace
}  // namespace twinbus
