// The walking robot in the simulator: flat ground, one command after the other.

#include "control/walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/dynamics.h"
#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"
#include "test/no_alloc.h"

namespace twinbus {
namespace {

struct Walker : SimRig {
  explicit Walker(const Model& model = test::hrp1s()) : SimRig(model, Scene{}, {}, {}) {}

  // Walks so for some seconds; false when the robot fell.
  bool walk(double vx, double vy, double wz, double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds / test::hrp1s().period()));
    WalkCommand command;
    command.run_id = state().run_id;
    command.vx = static_cast<float>(vx);
    command.vy = static_cast<float>(vy);
    command.wz = static_cast<float>(wz);
    command.timeout = 0.1F;
    for (int i = 0; i < ticks; ++i) {
      if (i % 10 == 0) {
        command.sequence = ++sequence;
        loop().on_walk_command(command, state().time_ns);
      }
      if (!tick()) return false;
    }
    return !record().fell;
  }
  double heading() const {
    const auto& q = truth().base_attitude;
    return std::atan2(2.0 * (q[0] * q[3] + q[1] * q[2]), 1.0 - 2.0 * (q[2] * q[2] + q[3] * q[3]));
  }
  std::int32_t sequence = 0;
};

TEST(Walk, WalksForwardSidewaysAndTurnsAtTheVelocityAskedAndComesToStand) {
  struct Case {
    double vx, vy, wz;
  };
  for (const Case c : {Case{0.4, 0.0, 0.0}, Case{0.0, 0.12, 0.0}, Case{0.0, 0.0, 0.4}}) {
    Walker robot;
    ASSERT_TRUE(robot.run(0.3));
    robot.ask(Mode::kWalk);
    ASSERT_TRUE(robot.walk(c.vx, c.vy, c.wz, 3.0));
    const SimTruth from = robot.truth();
    const double heading = robot.heading();
    const double time = 3.6;
    ASSERT_TRUE(robot.walk(c.vx, c.vy, c.wz, time));
    EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
    EXPECT_NEAR((robot.truth().base_position[0] - from.base_position[0]) / time, c.vx, 0.05);
    EXPECT_NEAR((robot.truth().base_position[1] - from.base_position[1]) / time, c.vy, 0.04);
    EXPECT_NEAR(std::remainder(robot.heading() - heading, 6.283185307) / time, c.wz, 0.06);
    EXPECT_LT(robot.record().base_tilt_max, 0.035);
    EXPECT_GT(robot.record().zmp_margin_min, 0.020);
    robot.ask(Mode::kBalance);
    ASSERT_TRUE(robot.run(3.0));
    EXPECT_EQ(robot.loop().status().mode, Mode::kBalance);
    EXPECT_FALSE(robot.record().fell);
  }
}

TEST(Walk, WithAReferenceOfPreviewControlItWalksTurnsAndComesToStandToo) {
  const Model model = test::say_walking(test::hrp1s(), "pattern: preview");
  ASSERT_TRUE(walking_of(model).preview);
  Walker robot(model), closed;
  for (Walker* each : {&robot, &closed}) {
    ASSERT_TRUE(each->run(0.3));
    each->ask(Mode::kWalk);
    ASSERT_TRUE(each->walk(0.3, 0.05, 0.2, 5.0));
    EXPECT_GT(std::hypot(each->truth().base_position[0], each->truth().base_position[1]), 0.7);
    EXPECT_LT(each->record().base_tilt_max, 0.035);
    EXPECT_GT(each->record().zmp_margin_min, 0.020);
  }
  EXPECT_NE(robot.truth().base_position, closed.truth().base_position) << "it is another reference";
  robot.state().stop_kind = StopKind::kBalanced;
  ASSERT_TRUE(robot.run(4.1));
  EXPECT_EQ(robot.command().flags & kCommandStopping, 0) << "at rest";
  EXPECT_FALSE(robot.record().fell);
}

TEST(Walk, ACommandThatIsNotRepeatedEnds) {
  Walker robot;
  ASSERT_TRUE(robot.run(0.3));
  robot.ask(Mode::kWalk);
  ASSERT_TRUE(robot.walk(0.3, 0.0, 0.0, 3.0));
  ASSERT_TRUE(robot.run(3.5));
  const double x = robot.truth().base_position[0];
  ASSERT_TRUE(robot.run(1.0));
  EXPECT_NEAR(robot.truth().base_position[0], x, 0.01);
  EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
  EXPECT_FALSE(robot.record().fell);
}

TEST(Walk, ABalancedStopInAnyPhaseEndsStanding) {
  for (int phase = 0; phase < 4; ++phase) {
    Walker robot;
    ASSERT_TRUE(robot.run(0.3));
    robot.ask(Mode::kWalk);
    ASSERT_TRUE(robot.walk(0.4, 0.0, 0.0, 3.0 + 0.15 * phase));
    robot.state().stop_kind = StopKind::kBalanced;
    ASSERT_TRUE(robot.run(0.1));
    EXPECT_NE(robot.command().flags & kCommandStopping, 0);
    ASSERT_TRUE(robot.run(4.0));
    EXPECT_EQ(robot.command().flags & kCommandStopping, 0) << "at rest";
    EXPECT_FALSE(robot.record().fell);
  }
}

TEST(Walk, TheGamepadsSticksWalk) {
  Walker robot;
  ASSERT_TRUE(robot.run(0.3));
  robot.ask(Mode::kWalk);
  Gamepad pad;
  pad.connected = pad.deadman = true;
  pad.run_id = robot.state().run_id;
  pad.left_y = 0.5F;
  for (int i = 0; i < 2000; ++i) {
    if (i % 10 == 0) robot.loop().on_gamepad(pad, robot.state().time_ns);
    ASSERT_TRUE(robot.tick());
  }
  EXPECT_GT(robot.truth().base_position[0], 0.4);
  EXPECT_FALSE(robot.record().fell);
}

TEST(Walk, NoTickAllocates) {
  if (!allocations_counted()) GTEST_SKIP() << "not counted in this build";
  for (const char* pattern : {"pattern: closed_form", "pattern: preview"}) {
    const Model model = test::say_walking(test::hrp1s(), pattern);
    Walker robot(model);
    ASSERT_TRUE(robot.run(0.3));
    Estimator estimator(model);
    estimator.update(robot.state());
    Walk walk(model, {});
    walk.start(estimator);
    walk.want({0.3, 0.0, 0.1});
    const Eigen::VectorXd q = estimator.configuration().q;
    NoAlloc no_alloc;
    for (int i = 0; i < 1500; ++i) walk.update(estimator, q, model.period());
    EXPECT_EQ(no_alloc.count(), 0) << pattern;
  }
}

// The robot is a tenth heavier than its controller knows: the forces that feet are asked for are those they find.
TEST(Walk, WhatTheRobotCarriesIsWeighedWhileItWalks) {
  SimRig robot(test::hrp1s(), Scene{}, {{"model.mass_scale", "1.1"}}, {});
  ASSERT_TRUE(robot.run(0.3));
  robot.ask(Mode::kWalk);
  ASSERT_TRUE(robot.run(3.0));
  double asked = 0.0;
  constexpr int kTicks = 600;
  for (int i = 0; i < kTicks; ++i) {
    ASSERT_TRUE(robot.tick());
    const auto forces = robot.loop().foot_forces();
    asked += (forces[0] + forces[1]) / kTicks;
  }
  EXPECT_NEAR(asked / (test::hrp1s().total_mass() * kGravity), 1.1, 0.02);
}

}  // namespace
}  // namespace twinbus
