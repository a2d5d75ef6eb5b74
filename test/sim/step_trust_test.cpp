// What engines say of steps that are wrong, in that step, and that they say nothing of good ones.

#include "sim/world/step_trust.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/articulated_world.h"
#include "sim/engine/energy_balance.h"
#include "test/obstacles.h"
#include "test_models.h"

namespace twinbus {
namespace {

// A ball of 20 mm flies at a plate of 2 mm that stands in its way at x = 1.
WorldConfig shot(double speed, double stiffness, double step) {
  WorldConfig config;
  config.step = step;
  config.obstacles = {test::box_at({1, 0, 1}, {0.002, 1, 1})};
  LooseBody ball;
  ball.name = "ball";
  ball.mass = 0.03;
  ball.solid = {SolidShape::kSphere, {0.01, 0, 0}};
  ball.stiffness = stiffness;
  ball.damping = 0.1 * std::sqrt(stiffness * ball.mass);
  ball.start.pose.translation() = Eigen::Vector3d(0.9, 0, 1);
  ball.start.velocity.x() = speed;
  config.loose = {ball};
  return config;
}

TWINBUS_BOTH_ENGINES(StepTrustTest);

TEST_P(StepTrustTest, WhatComesThroughAPlateIsSaidInThatStep) {
  const Model model = test::bystander();
  // Ours lets through what its spring cannot stop, ODE what moves too far in a step.
  WorldConfig config = is_ode() ? shot(50, 1e7, 1e-3) : shot(50, 1e5, 1e-4);
  if (is_ode()) config.loose[0].start.pose.translation().x() = 0.925;  // steps over it
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  double said_at = 2.0;
  for (double t = 0.0; t < 0.01 && !(world->loose(0).pose.translation().x() > 1.0); t += config.step) {
    ASSERT_EQ(world->step(), Status::kOk);
    if (world->trust()[Doubt::kThrough]) said_at = std::min(said_at, t);
  }
  EXPECT_GT(world->loose(0).pose.translation().x(), 1.0);
  EXPECT_LT(said_at, 1.0);
}

TEST_P(StepTrustTest, OfABallThatBouncesOffNothingIsSaid) {
  const Model model = test::bystander();
  const WorldConfig config = shot(2, 1e7, 1e-4);
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  EnergyBalance balance(model, config);
  balance.begin(*world);
  long doubted = 0;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(world->step(), Status::kOk);
    doubted += world->trust().any() || balance.add(*world, 0.0) ? 1 : 0;
  }
  EXPECT_LT(world->loose(0).velocity.x(), 0.0);
  EXPECT_EQ(doubted, 0);
}

// What the engine says of all links at once is what each of them says.
void expect_links_agree(const Model& model, double mass_scale, const ArticulatedWorld& world) {
  std::vector<Eigen::Vector3d> in_world(model.links.size()), own(model.links.size());
  const BodyEnergy energy = world.energy(in_world.data(), own.data());
  double kinetic = 0.0, potential = 0.0;
  for (int i = 0; i < model.link_count(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Link& link = model.links[at];
    const Eigen::Isometry3d pose = world.link_in_world(i);
    const Eigen::Vector3d com = pose * link.com, velocity = world.point_velocity(i, com);
    const Eigen::Vector3d spin = pose.linear().transpose() * world.angular_velocity(i);
    EXPECT_LT((in_world[at] - velocity).norm(), 1e-12) << i;
    EXPECT_LT((own[at] - pose.linear().transpose() * velocity).norm(), 1e-12) << i;
    kinetic += 0.5 * mass_scale * (link.mass * velocity.squaredNorm() + spin.dot(link.inertia * spin));
    potential += mass_scale * link.mass * kGravity * com.z();
  }
  EXPECT_GT(kinetic, 1.0);
  EXPECT_NEAR(energy.kinetic, kinetic, 1e-11 * kinetic);
  EXPECT_NEAR(energy.potential, potential, 1e-11 * std::abs(potential));
}

TEST(StepTrust, TheMotionsOfAllLinksAtOnceAreThoseOfEach) {
  for (const bool floating : {true, false}) {
    for (const int branches : {1, 4}) {  // links one after another, and in lanes beside one another
      Model model = test::chain(12, floating);
      for (int i = 1; i <= 12; ++i) {
        const int parent = branches == 1 ? i - 1 : std::max(0, i - branches);
        model.links[static_cast<std::size_t>(i)].parent = model.joints[static_cast<std::size_t>(i - 1)].parent = parent;
      }
      model.joints[5].kind = JointKind::kPrismatic;
      WorldConfig config;
      config.fixed_base = !floating;
      config.mass_scale = 1.3;
      config.step = 1e-3;
      ArticulatedWorld world(model, config);
      Configuration start(model);
      start.base.translation() = Eigen::Vector3d(3.0, -2.0, 50.0);
      start.base.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
      start.base_velocity = {0.4, -1.0, 0.3};
      start.base_angular_velocity = {0.5, 1.0, -2.0};
      for (int j = 0; j < start.q.size(); ++j) {
        start.q[j] = 0.3 * std::sin(2.0 * j);
        start.qd[j] = 3.0 * std::sin(1.7 * j + 0.3);
      }
      ASSERT_EQ(world.set(start), Status::kOk);
      expect_links_agree(model, config.mass_scale, world);
      for (int i = 0; i < 3; ++i) ASSERT_EQ(world.step(), Status::kOk);
      expect_links_agree(model, config.mass_scale, world);
    }
  }
}

TEST(StepTrust, AServoThatLiftsIsNoGainAndAThrowInMidAirIs) {
  const Model model = test::pendulum();
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-3;
  const auto world = make_world(model, config);
  Configuration start(model);
  ASSERT_EQ(world->set(start), Status::kOk);
  (void)world->set_servo(0, {.q = 1.0, .kp = 200.0, .kd = 20.0});
  EnergyBalance balance(model, config);
  balance.begin(*world);
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(world->step(), Status::kOk);
    EXPECT_FALSE(balance.add(*world, 0.0)) << i << ": " << balance.gain();
  }
  Configuration faster = world->configuration();
  faster.qd[0] += 1.0;
  ASSERT_EQ(world->set(faster), Status::kOk);
  ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_TRUE(balance.add(*world, 0.0));
  EXPECT_GT(balance.gain(), 0.1);
}

// A free chain takes off at a step too large for its gyroscopic forces: it is said before kDiverged.
TEST(StepTrust, AChainThatGainsEnergyIsDoubtedBeforeItDiverges) {
  const Model model = test::chain(30, true);
  WorldConfig config;
  config.step = 0.02;
  const auto world = make_world(model, config);
  Configuration start(model);
  start.base.translation().z() = 50.0;
  for (int j = 0; j < start.qd.size(); ++j) start.qd[j] = 6.0 * std::sin(1.7 * j + 0.3);
  ASSERT_EQ(world->set(start), Status::kOk);
  for (int j = 0; j < model.joint_count(); ++j) (void)world->set_servo(j, {});
  EnergyBalance balance(model, config);
  balance.begin(*world);
  double gained = 0.0, most = 0.0;
  long doubted = 0;
  for (int i = 0; i < 200 && world->step() == Status::kOk; ++i) {
    doubted += balance.add(*world, 0.0) ? 1 : 0;
    gained += balance.gain();
    most = std::max(most, gained);
  }
  EXPECT_GT(most, 10.0);  // [J]
  EXPECT_GT(doubted, 0);
}

// A pendulum swings freely, and from time to time something gives it energy that nobody accounts for.
struct Planted {
  long doubted = 0;
  double gain = 0.0, rise = 0.0;  // bands [J]
};
Planted planted(const TrustBands& bands, int every, double squared) {  // of its speed [rad^2/s^2]
  const Model model = test::pendulum();
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-3;
  config.bands = bands;
  const auto world = make_world(model, config);
  Configuration start(model);
  start.q[0] = 1.0;
  EXPECT_EQ(world->set(start), Status::kOk);
  EnergyBalance balance(model, config);
  balance.begin(*world);
  Planted found;
  for (int i = 1; i <= 1000; ++i) {
    if (i % every == 0) {
      Configuration faster = world->configuration();
      faster.qd[0] = std::copysign(std::sqrt(faster.qd[0] * faster.qd[0] + squared), faster.qd[0]);
      EXPECT_EQ(world->set(faster), Status::kOk);
    }
    EXPECT_EQ(world->step(), Status::kOk);
    found.doubted += balance.add(*world, 0.0) ? 1 : 0;
  }
  found.gain = balance.gain_band();
  found.rise = balance.rise_band();
  return found;
}

// A run whose error was measured is doubted beyond what its own steps gained.
TEST(StepTrust, WhatAMeasuredRunGainedIsKnownAndMoreIsDoubted) {
  const Planted measured = planted({}, 100, 2.0);
  EXPECT_GE(measured.doubted, 10);
  ASSERT_GT(measured.gain, 0.1);
  ASSERT_GT(measured.rise, 5.0 * measured.gain);
  const TrustBands known{.gain = measured.gain, .rise = measured.rise};
  EXPECT_EQ(planted(known, 100, 2.0).doubted, 0);
  EXPECT_GT(planted(known.times(0.99), 100, 2.0).doubted, 0);
  const TrustBands allowed = known.times(1.5);
  EXPECT_EQ(planted(allowed, 100, 2.0).doubted, 0);
  EXPECT_GT(planted(allowed, 500, 6.0).doubted, 0);  // more at once, less together
  EXPECT_GT(planted(allowed, 50, 2.0).doubted, 0);   // no more at once, more together
  EXPECT_EQ(planted({}, 2000, 2.0).gain, 0.0);       // nothing planted
  EXPECT_LT(planted({}, 2000, 2.0).rise, 0.1 * measured.gain);
}

TEST(StepTrust, BandsHaveABoundOrNone) {
  const TrustBands bands{1.0, 2.0, std::numeric_limits<double>::infinity(), std::nan("")};
  EXPECT_EQ(bands.times(1.5), (TrustBands{1.5, 3.0, 0.0, 0.0}));
}

// A command that leaps makes the torque of a stiff servo leap at the start of the step, where neither end of it shows the torque.
TEST(StepTrust, AServoThatIsAskedToLeapInEveryStepIsNoGain) {
  const Model model = test::pendulum();
  for (const int order : {1, 2, 3}) {
    WorldConfig config;
    config.fixed_base = true;
    config.step = 2e-3;
    config.order = order;
    const auto world = make_world(model, config);
    ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
    EnergyBalance balance(model, config);
    balance.begin(*world);
    double most = 0.0;
    for (int i = 0; i < 1000; ++i) {
      (void)world->set_servo(0, {.q = i % 3 == 0 ? 0.1 : 0.0, .kp = 3000.0, .kd = 100.0});
      ASSERT_EQ(world->step(), Status::kOk);
      EXPECT_FALSE(balance.add(*world, 0.0)) << order << " " << i << ": " << balance.gain();
      most = std::max(most, world->servo_work());
    }
    EXPECT_EQ(most > 0.1, order > 1) << most;
    EXPECT_EQ(std::isnan(world->servo_work()), order == 1);
  }
}

// A box slides at 2 m/s and is stopped by friction: of a step h it comes to rest h / 2 times its speed off.
WorldConfig sliding(double step) {
  WorldConfig config;
  config.step = step;
  config.twin = true;
  config.fixed_base = true;
  config.ground_friction = 0.8;
  LooseBody box;
  box.name = "box";
  box.solid.size << 0.4, 0.4, 0.02;
  box.friction = 0.8;
  box.stiffness = 1e6;
  box.damping = 1e3;
  box.start.pose.translation().z() = 0.01;
  box.start.velocity.x() = 2.0;
  config.loose = {box};
  return config;
}

TEST_P(StepTrustTest, ATwinOfHalfTheStepDoubtsACoarseStepBeforeItIsWrong) {
  const Model model = test::bystander();
  for (const double step : {1e-3, 0.02}) {
    const auto world = make(model, sliding(step));
    ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
    double wrong_at = 2.0, said_at = 2.0;
    for (double t = step; t < 0.5; t += step) {
      ASSERT_EQ(world->step(), Status::kOk);
      const double brake = 0.8 * kGravity, until = std::min(t, 2.0 / brake);
      const double off = world->loose(0).pose.translation().x() - (2.0 * until - 0.5 * brake * until * until);
      if (std::abs(off) > 5e-3) wrong_at = std::min(wrong_at, t);
      if (world->trust()[Doubt::kCoarse]) said_at = std::min(said_at, t);
    }
    EXPECT_EQ(wrong_at < 1.0, step > 0.01);
    EXPECT_EQ(said_at < 1.0, step > 0.01);
    EXPECT_LE(said_at, wrong_at);
  }
}

TEST(StepTrust, ATwinChangesNothingOfTheWorldAndTakesTheSameCommands) {
  const Model model = test::pendulum();  // its link's origin is the hinge, which rests
  WorldConfig config;
  config.fixed_base = true;
  config.step = 0.01;
  const auto alone = make_world(model, config);
  config.twin = true;
  const auto twinned = make_world(model, config);
  Configuration start(model);
  start.q[0] = 1.0;
  for (World* world : {alone.get(), twinned.get()}) ASSERT_EQ(world->set(start), Status::kOk);
  long doubted = 0;
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(alone->step(), Status::kOk);
    ASSERT_EQ(twinned->step(), Status::kOk);
    ASSERT_EQ(alone->configuration().q[0], twinned->configuration().q[0]);
    doubted += twinned->trust()[Doubt::kCoarse] ? 1 : 0;
  }
  EXPECT_GT(doubted, 0);  // order 1 at 10 ms loses a swing of 1 rad
  // Driven, it parts again and again, and always goes on from where the world is.
  int said = 0;
  for (int i = 0; i < 400; ++i) {
    for (World* world : {alone.get(), twinned.get()}) ASSERT_EQ(world->set_servo(0, {.q = i / 50 % 2 * 1.0, .kp = 50.0, .kd = 1.0}), Status::kOk);
    ASSERT_EQ(alone->step(), Status::kOk);
    ASSERT_EQ(twinned->step(), Status::kOk);
    ASSERT_EQ(alone->configuration().q[0], twinned->configuration().q[0]);
    said += twinned->trust()[Doubt::kCoarse] ? 1 : 0;
  }
  EXPECT_GT(said, 4);
  EXPECT_LT(said, 200);
}

// The doubt follows the accuracy that is asked for.
TEST(StepTrust, ATwinDoubtsByTheAccuracyAsked) {
  const Model model = test::pendulum();
  const auto doubted = [&model](double accuracy) {
    WorldConfig config;
    config.fixed_base = config.twin = true;
    config.step = 0.002;
    config.accuracy = accuracy;
    const auto world = make_world(model, config);
    Configuration start(model);
    start.q[0] = 1.0;
    EXPECT_EQ(world->set(start), Status::kOk);
    int said = 0;
    for (int i = 0; i < 250; ++i) {
      EXPECT_EQ(world->step(), Status::kOk);
      said += world->trust()[Doubt::kCoarse] ? 1 : 0;
    }
    return said;
  };
  EXPECT_EQ(doubted(0.1), 0);
  EXPECT_GT(doubted(1e-4), 100);
}

TEST(StepTrust, AContactFirstSeenNoDeeperThanInTheRunThatWasMeasuredIsKnown) {
  StepTrust step;
  step[Doubt::kDeep] = step[Doubt::kThrough] = true;
  step.first_depth = 0.01;
  step.know({.depth = 0.009});
  EXPECT_TRUE(step[Doubt::kDeep]);
  step.know({.depth = 0.01});
  EXPECT_FALSE(step[Doubt::kDeep]);
  EXPECT_TRUE(step[Doubt::kThrough]);
}

TEST(StepTrust, CountsSayHowOftenAndWhatCameFirst) {
  TrustCounts counts;
  StepTrust step;
  counts.add(step, 0.1, 1.0);
  EXPECT_EQ(counts.doubted, 0);
  step[Doubt::kDeep] = true;
  step.first_depth = 0.01;
  counts.add(step, 0.2, 2.0);
  step[Doubt::kUnconverged] = true;
  counts.add(step, 0.0, 3.0);
  EXPECT_EQ(counts.doubted, 2);
  EXPECT_EQ(counts.steps[static_cast<std::size_t>(Doubt::kDeep)], 2);
  EXPECT_EQ(counts.steps[static_cast<std::size_t>(Doubt::kUnconverged)], 1);
  EXPECT_EQ(counts.first, Doubt::kDeep);
  EXPECT_EQ(counts.first_at, 2.0);
  EXPECT_EQ(counts.energy_gain, 0.2);
}

}  // namespace
}  // namespace twinbus
