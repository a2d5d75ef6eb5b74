#include "planner/joint_turns.h"

#include <gtest/gtest.h>

#include "planner/arm_planner.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

constexpr double kTurn = 2.0 * M_PI;

// hrp1s, whose right arm turns farther: by `range` to either side, or without an end.
Model turning(double range) {
  Model model = hrp1s();
  for (const int joint : model.hands[1].joints) {
    Joint& j = model.joints[static_cast<std::size_t>(joint)];
    if (range > 0.0) {
      j.lower = -range;
      j.upper = range;
    } else {
      j.kind = JointKind::kContinuous;
      j.lower = -std::numeric_limits<double>::infinity();
      j.upper = std::numeric_limits<double>::infinity();
    }
  }
  return model;
}

TEST(JointTurns, ARangeOfMoreThanATurnIsLookedAtOnceAround) {
  const Model model = turning(kTurn);
  const std::vector<int>& joints = model.hands[1].joints;
  for (const double at : {-6.28, -5.0, 0.0, 1.0, 6.27}) {
    const JointPoint start = JointPoint::Constant(static_cast<int>(joints.size()), at);
    const JointTurns range(model, joints, start);
    for (int k = 0; k < start.size(); ++k) {
      EXPECT_NEAR(range.upper[k] - range.lower[k], kTurn, 0.02);
      EXPECT_LE(range.lower[k], at);
      EXPECT_GE(range.upper[k], at);
      EXPECT_GE(range.lower[k], -kTurn);
      EXPECT_LE(range.upper[k], kTurn);
    }
    for (double q = -6.2; q < 6.2; q += 0.1) {
      const JointPoint there = range.within(JointPoint::Constant(start.size(), q));
      for (int k = 0; k < start.size(); ++k) {
        EXPECT_GE(there[k], range.lower[k] - 1e-9);
        EXPECT_LE(there[k], range.upper[k] + 1e-9);
        EXPECT_NEAR(std::remainder(there[k] - q, kTurn), 0.0, 1e-9);
      }
    }
  }
}

TEST(JointTurns, ARangeOfLessThanATurnIsLeftAsItIs) {
  const Model model = turning(3.0);
  const std::vector<int>& joints = model.hands[1].joints;
  const JointPoint start = JointPoint::Constant(static_cast<int>(joints.size()), 0.5);
  const JointTurns range(model, joints, start);
  EXPECT_EQ(range.lower[0], -3.0);
  EXPECT_EQ(range.upper[0], 3.0);
  EXPECT_EQ(range.within(start), start);
}

// A joint without an end that has turned more than once is told a posture, which it takes by the shorter way.
TEST(ArmPlanner, JointsWithoutAnEndTakeTheShorterWayToAPosture) {
  const Model model = turning(0.0);
  ArmPlanner planner(model);
  Configuration start = named_posture(model, "half_sitting");
  const auto wrist = static_cast<std::size_t>(model.hands[1].joints.back());
  const double home = start.q[static_cast<Eigen::Index>(wrist)];
  start.q[static_cast<Eigen::Index>(wrist)] = home + kTurn + 0.5;
  ArmGoal goal;
  goal.kind = ArmGoalKind::kJoints;
  goal.speed = 0.5F;
  const auto bus = std::find(model.bus_joints.begin(), model.bus_joints.end(), static_cast<int>(wrist)) - model.bus_joints.begin();
  goal.joint_mask = std::int64_t{1} << bus;
  goal.q[static_cast<std::size_t>(bus)] = home;
  const ArmPlan plan = planner.plan(goal, start, Eigen::Isometry3d::Identity(), 1);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_NEAR(plan.path.back().q[0], home + kTurn, 1e-9);
}

}  // namespace
}  // namespace twinbus
