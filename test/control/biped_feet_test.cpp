// Bipeds whose feet are lines, and feet with toes: proposed and never tuned, they stand or step, and walk.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "common/math/pose_math.h"
#include "control/point_feet/point_feet.h"
#include "control/walk/footsteps.h"
#include "robot/description/model.h"
#include "robot/estimation/standing_feet.h"
#include "sim/world/felt_feet.h"
#include "test/control/made_biped.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

using test::FootShape;
using test::MadeBiped;
using test::ProposedBiped;

struct FootWalker : SimRig {
  explicit FootWalker(const Model& model, const Settings& settings = {}) : SimRig(model, Scene{}, settings, {}), period(model.period()) {}
  bool walk(double vx, double seconds) {
    const auto ticks = static_cast<int>(std::lround(seconds / period));
    WalkCommand command = walk_command(state().run_id, vx, 0.0, 0.0);
    for (int i = 0; i < ticks; ++i) {
      if (i % 10 == 0) {
        command.sequence = ++sequence;
        loop().on_walk_command(command, state().time_ns);
      }
      if (!tick()) return false;
    }
    return !record().fell;
  }
  double period;
  std::int32_t sequence = 0;
};

// Stands, or steps in place, for a while, then walks.
void expect_walks(const Model& model, double vx, double most_tilt) {
  FootWalker robot(model);
  ASSERT_TRUE(robot.run(2.0));
  robot.ask(Mode::kWalk);
  ASSERT_TRUE(robot.walk(0.0, 3.0));
  EXPECT_LT(std::hypot(robot.truth().base_position[0], robot.truth().base_position[1]), 0.2) << "in place";
  ASSERT_TRUE(robot.walk(vx, 3.0));
  const double from = robot.truth().base_position[0];
  ASSERT_TRUE(robot.walk(vx, 10.0));
  EXPECT_NEAR((robot.truth().base_position[0] - from) / 10.0, vx, 0.2 * vx);
  EXPECT_LT(robot.record().base_tilt_max, most_tilt);
  robot.ask(Mode::kBalance);
  ASSERT_TRUE(robot.run(4.0));
  EXPECT_FALSE(robot.record().fell);
}

TEST(LineFeet, ALineAlongTheFootIsASoleWithoutAWidthThatHolds) {
  for (const char* joints : {"yrpka", "yrpkao"}) {
    const ProposedBiped robot({.joints = joints, .shape = FootShape::kLyingAlong, .length = 0.2, .width = 0.02});
    EXPECT_TRUE(robot.says("is a line along the foot, 200 mm long")) << joints;
    const Sole& sole = robot.model.soles[0];
    ASSERT_GE(sole.link, 0);
    EXPECT_NEAR(sole.front + sole.back, 0.2, 1e-6);
    EXPECT_NEAR(sole.left + sole.right, 0.01, 1e-6);
    const Gait gait = gait_of(robot.model, robot.model.walking, 0.010);
    EXPECT_LE(gait.sole_low.y(), gait.sole_high.y());
    EXPECT_LE(gait.sole_high.y(), 0.005);
    expect_walks(robot.model, 0.2, 0.09);
  }
}

// A blade, of a box, whose edges are both on the ground.
TEST(LineFeet, ABladeWalksToo) {
  const ProposedBiped robot({.joints = "yrpka", .length = 0.2, .width = 0.02});
  EXPECT_TRUE(robot.says("is a line along the foot, 200 mm long"));
  expect_walks(robot.model, 0.25, 0.09);
}

TEST(LineFeet, WhatIsWideOrShortIsNoLine) {
  EXPECT_FALSE(ProposedBiped({.length = 0.2, .width = 0.07}).says("is a line"));
  EXPECT_FALSE(ProposedBiped({.length = 0.2, .width = 0.12}).says("is a line"));
}

// Nobody stands on two lines that are one: it steps, as on points.
TEST(LineFeet, ALineAcrossTheFootSteps) {
  const ProposedBiped robot({.joints = "rpk", .shape = FootShape::kLyingAcross, .length = 0.12, .width = 0.015});
  EXPECT_TRUE(robot.says("on two feet that are points, or lines"));
  EXPECT_LT(robot.model.soles[0].link, 0);
  ASSERT_EQ(why_no_point_feet(robot.model), nullptr);
  FootWalker walker(robot.model);
  ASSERT_TRUE(walker.run(2.0));
  walker.ask(Mode::kWalk);
  ASSERT_TRUE(walker.walk(0.2, 20.0));
  EXPECT_LT(walker.record().base_tilt_max, 0.2);
}

// No point gives a moment about the vertical; two of them do for as long as both stand.
TEST(PointFeet, TwoKeepTheHeadingOfAWalk) {
  const ProposedBiped robot({.joints = "rpk", .shape = FootShape::kLyingAlong, .length = 0.12, .width = 0.015});
  FootWalker walker(robot.model);
  ASSERT_TRUE(walker.run(2.0));
  walker.ask(Mode::kWalk);
  ASSERT_TRUE(walker.walk(0.2, 20.0));
  const auto& truth = walker.truth();
  EXPECT_LT(std::abs(yaw_of(quaternion_from_array(truth.base_attitude).toRotationMatrix())), 0.1);
  EXPECT_LT(std::abs(truth.base_position[1]), 0.1 * truth.base_position[0]);
}

TEST(PointFeet, TwoWheelsAreNotBalanced) {
  Model model = ProposedBiped({.joints = "rpk", .shape = FootShape::kLyingAcross, .length = 0.12, .width = 0.015}).model;
  ASSERT_EQ(why_no_point_feet(model), nullptr);
  Joint& knee = model.joints[static_cast<std::size_t>(model.find_joint("left_knee"))];
  knee.lower = -10.0;
  knee.upper = 10.0;
  ASSERT_EQ(why_no_point_feet(model), nullptr) << "a shank that may turn round is no wheel";
  for (const char* name : {"left_knee", "right_knee"}) {
    Shape wheel;
    wheel.kind = ShapeKind::kCylinder;
    wheel.size = {0.15, 0.04, 0.0};
    wheel.pose.linear() = Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
    model.links[static_cast<std::size_t>(model.joints[static_cast<std::size_t>(model.find_joint(name))].child)].collision = {wheel};
  }
  ASSERT_NE(why_no_point_feet(model), nullptr);
  EXPECT_NE(std::string(why_no_point_feet(model)).find("its feet are wheels (joint left_knee turns on and on)"), std::string::npos);
}

TEST(LineFeet, ALineAcrossThatALegCanTurnIsSaidNotToBeWalked) {
  const ProposedBiped robot({.joints = "yrpka", .shape = FootShape::kLyingAcross, .length = 0.12, .width = 0.015});
  EXPECT_TRUE(robot.says("is a line across the foot, 120 mm long: nobody stands on two such lines"));
}

TEST(LineFeet, LegsThatCannotTurnAFootWalkOnALineAlongIt) {
  const ProposedBiped robot({.joints = "rpk", .shape = FootShape::kLyingAlong, .length = 0.12, .width = 0.015});
  ASSERT_EQ(why_no_point_feet(robot.model), nullptr);
  expect_walks(robot.model, 0.2, 0.11);
}

TEST(Toes, WithoutAMotorAreSpringsThatNobodyCommands) {
  const ProposedBiped robot({.toe_effort = 0.0});
  EXPECT_TRUE(robot.says("no motor drives [left_toe, right_toe]"));
  const Model& model = robot.model;
  const int toe = model.find_joint("left_toe");
  ASSERT_GE(toe, 0);
  EXPECT_EQ(model.bus_count(), 12);
  EXPECT_EQ(model.bus_index[static_cast<std::size_t>(toe)], -1);
  const std::vector<PassiveJoint> passive = passive_joints_of(model);
  ASSERT_EQ(passive.size(), 2U);
  EXPECT_GT(passive[0].stiffness, 1.0);
  EXPECT_EQ(StandingFeet(model).count(), 2) << "a toe is no foot of its own";
  EXPECT_EQ(felt_feet(model).count, 2);
  expect_walks(model, 0.3, 0.09);
}

// How far the left toe is bent at most while the robot walks.
double most_bent(const std::string& springs, const char* engine) {
  const ProposedBiped made({.toe_effort = 0.0, .springs = springs});
  FootWalker robot(made.model, {{"engine", engine}});
  const auto toe = static_cast<Eigen::Index>(made.model.find_joint("left_toe"));
  double most = 0.0;
  EXPECT_TRUE(robot.run(1.0));
  robot.ask(Mode::kWalk);
  for (int i = 0; i < 80 && robot.walk(0.3, 0.05); ++i) most = std::max(most, std::abs(robot.sim().world()->configuration().q[toe]));
  EXPECT_FALSE(robot.record().fell);
  return most;
}

// A slack toe hangs down while its foot is in the air.
TEST(Toes, BendAsFarAsTheirSpringsLetThem) {
  for (const char* engine : {"articulated", "ode"}) {
    const double slack = most_bent("stiffness: 0.2, damping: 0.02", engine), stiff = most_bent("stiffness: 20, damping: 0.02", engine);
    EXPECT_GT(slack, 0.05) << engine;
    EXPECT_LT(stiff, 0.4 * slack) << engine;
    EXPECT_GT(stiff, 0.0) << engine;
  }
}

TEST(Toes, WithAMotorStayJointsAndWalk) {
  const ProposedBiped robot({.toe_effort = 30.0});
  EXPECT_EQ(robot.model.bus_count(), 14);
  EXPECT_EQ(StandingFeet(robot.model).count(), 2);
  expect_walks(robot.model, 0.3, 0.09);
}

TEST(Toes, ThatRobotYamlNamesWronglyAreRefusedWithTheRemedy) {
  const auto refusal = [](const char* more) -> std::string {
    try {
      const ProposedBiped robot({.toe_effort = 30.0, .more = more});
      return "";
    } catch (const std::runtime_error& error) {
      return error.what();
    }
  };
  EXPECT_NE(refusal("passive_joints: [{joints: [left_tow]}]\n").find("there is no joint left_tow; did you mean left_toe"), std::string::npos);
  EXPECT_NE(refusal("passive_joints: [{joints: [left_toe], rest: 2}]\n").find("rest of left_toe is outside its limits"), std::string::npos);
  EXPECT_NE(refusal("passive_joints: [{joints: [left_toe, left_toe]}]\n").find("named twice"), std::string::npos);
  EXPECT_NE(refusal("passive_joints: [{joints: [left_hip_yaw]}]\n").find("no joint with a motor carries left_hip_yaw"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
