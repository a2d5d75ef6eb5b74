// The walking robot in the simulator: flat ground, one command after the other.

#include "control/walk/walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"
#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

struct Walker : SimRig {
  explicit Walker(const Model& model = test::hrp1s()) : SimRig(model, Scene{}, {}, {}) {}

  // Asked to walk once it stands.
  bool set_off() {
    const bool stands = run(0.3);
    ask(Mode::kWalk);
    return stands;
  }
  // Walks so for some seconds; false when the robot fell.
  bool walk(double vx, double vy, double wz, double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds / test::hrp1s().period()));
    WalkCommand command = walk_command(state().run_id, vx, vy, wz);
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

void expect_stopped(Walker& robot, double within) {
  ASSERT_TRUE(robot.run(within));
  EXPECT_EQ(robot.command().flags & kCommandStopping, 0) << "at rest";
  EXPECT_FALSE(robot.record().fell);
}

TEST(Walk, WalksForwardSidewaysAndTurnsAtTheVelocityAskedAndComesToStand) {
  struct Case {
    double vx, vy, wz;
  };
  for (const Case c : {Case{0.4, 0.0, 0.0}, Case{0.0, 0.12, 0.0}, Case{0.0, 0.0, 0.4}}) {
    Walker robot;
    ASSERT_TRUE(robot.set_off());
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
  const Model model = test::with_pattern(test::hrp1s(), true);
  ASSERT_TRUE(model.walking.preview);
  Walker robot(model), closed;
  for (Walker* each : {&robot, &closed}) {
    ASSERT_TRUE(each->set_off());
    ASSERT_TRUE(each->walk(0.3, 0.05, 0.2, 5.0));
    EXPECT_GT(std::hypot(each->truth().base_position[0], each->truth().base_position[1]), 0.7);
    EXPECT_LT(each->record().base_tilt_max, 0.035);
    EXPECT_GT(each->record().zmp_margin_min, 0.020);
  }
  EXPECT_NE(robot.truth().base_position, closed.truth().base_position) << "it is another reference";
  robot.state().stop_kind = StopKind::kBalanced;
  expect_stopped(robot, 4.1);
}

// Each where the foot that stood then said; the robot stands where the last two led.
TEST(Walk, WalksAListOfFootstepsAndStands) {
  Walker robot;
  ASSERT_TRUE(robot.set_off());
  ASSERT_TRUE(robot.run(0.1));
  StepList list;
  list.run_id = robot.state().run_id;
  list.sequence = 1;
  list.count = 4;
  list.first_foot = FootSide::kRight;
  list.x = {0.2F, 0.25F, 0.1F, 0.0F};
  list.y = {-0.2F, 0.2F, -0.24F, 0.2F};
  list.yaw = {0.0F, 0.0F, -0.3F, 0.0F};
  const SimTruth from = robot.truth();
  robot.loop().on_step_list(list);
  ASSERT_TRUE(robot.run(2.0));
  robot.loop().on_step_list(list);  // the same again
  ASSERT_TRUE(robot.run(4.0));
  EXPECT_EQ(robot.loop().take_sentence(), nullptr);
  const auto at = [&](std::size_t foot) {
    return Eigen::Vector2d(robot.truth().foot_position[foot][0],
                           robot.truth().foot_position[foot][1]);
  };
  // The left foot stood and stepped twice: 0.2 + 0.25 + 0.1 ahead with the right one between.
  const double left_x = static_cast<double>(from.foot_position[0][0]);
  const double right_y = static_cast<double>(from.foot_position[0][1]) - 0.2;
  const Eigen::Vector2d right(left_x + 0.55, right_y + 0.2 - 0.24);
  EXPECT_LT((at(1) - right).norm(), 0.012);
  const Eigen::Vector2d left = right + 0.2 * Eigen::Vector2d(std::sin(0.3), std::cos(0.3));
  EXPECT_LT((at(0) - left).norm(), 0.012);
  EXPECT_FALSE(robot.record().fell);
  EXPECT_GT(robot.record().zmp_margin_min, 0.02);
}

TEST(Walk, AListThatCannotBeWalkedIsRefusedAndNothingMoves) {
  Walker robot;
  ASSERT_TRUE(robot.run(0.3));
  StepList list;
  list.run_id = robot.state().run_id;
  list.count = 2;
  list.first_foot = FootSide::kLeft;
  list.x = {0.1F, 0.1F};
  list.y = {0.2F, -0.2F};
  const auto said = [&](float second) {
    list.x[1] = second;
    ++list.sequence;
    (void)robot.loop().take_sentence();
    robot.loop().on_step_list(list);
    EXPECT_TRUE(robot.run(1.5));
    const char* sentence = robot.loop().take_sentence();
    return std::string(sentence != nullptr ? sentence : "");
  };
  EXPECT_NE(said(0.1F).find("mode walk"), std::string::npos);
  robot.ask(Mode::kWalk);
  ASSERT_TRUE(robot.run(0.1));
  EXPECT_NE(said(0.8F).find("farther than the legs reach"), std::string::npos);
  EXPECT_LT(std::abs(robot.truth().base_position[0]), 0.02F);
  EXPECT_EQ(said(0.1F), "");
  EXPECT_NE(said(0.1F).find("begins where the robot stands"), std::string::npos) << "it walks";
}

TEST(Walk, ACommandThatIsNotRepeatedEnds) {
  Walker robot;
  ASSERT_TRUE(robot.set_off());
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
    ASSERT_TRUE(robot.set_off());
    ASSERT_TRUE(robot.walk(0.4, 0.0, 0.0, 3.0 + 0.15 * phase));
    robot.state().stop_kind = StopKind::kBalanced;
    ASSERT_TRUE(robot.run(0.1));
    EXPECT_NE(robot.command().flags & kCommandStopping, 0);
    expect_stopped(robot, 4.0);
  }
}

TEST(Walk, TheGamepadsSticksWalk) {
  Walker robot;
  ASSERT_TRUE(robot.set_off());
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
  for (const bool preview : {false, true}) {
    const Model model = test::with_pattern(test::hrp1s(), preview);
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
    EXPECT_EQ(no_alloc.count(), 0) << (preview ? "preview" : "closed_form");
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
