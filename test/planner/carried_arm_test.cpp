#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "common/math/index.h"
#include "planner/arm_planner.h"
#include "robot/collision/collision_pairs.h"
#include "test/carried_arms.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

const Eigen::Isometry3d kGroundFrame = Eigen::Isometry3d::Identity();
constexpr double kArm = 0.3 + 0.25 + 0.06;  // from the shoulder to the middle of the hand [m]

std::vector<std::string> names(const Model& model, const std::vector<int>& joints) {
  std::vector<std::string> found;
  for (const int j : joints) found.push_back(model.joints[at(j)].name);
  return found;
}

Eigen::Vector3d right_hand(const Model& model, const Configuration& there) {
  Kinematics k(model);
  k.update(there);
  return (k.link_in_world(model.hands[1].link) * model.hands[1].frame).translation();
}

struct CarriedArm : testing::Test {
  Model model = test::carried_arms(true);
  Configuration start{model, "half_sitting"};
  std::vector<Obstacle> around = {box(0.0, 0.0, -0.05, 12.0, 12.0, 0.1)};  // the ground

  ArmPlan to(double x, double y, double z) {
    ArmPlanner planner(model);
    planner.set_obstacles(around);
    const ArmPlan plan = planner.plan(hand_to(ArmSide::kRight, x, y, z), start, kGroundFrame, 3);
    if (plan.status == ArmPathStatus::kOk) {
      EXPECT_LT((right_hand(model, posture_at(plan, start, plan.duration())) - Eigen::Vector3d(x, y, z)).norm(), 1e-3);
      EXPECT_TRUE(planner.path_free(plan, start, 0.5 * plan.clearance));
    }
    return plan;
  }
};

TEST_F(CarriedArm, WhatTheArmReachesByItselfLeavesLiftAndBaseAtRest) {
  const ArmPlan plan = to(0.40, -0.25, 0.70);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_EQ(plan.joints, model.hands[1].joints);
}

TEST_F(CarriedArm, TheLiftBringsItHigherAndTheBaseStays) {
  const ArmPlan plan = to(0.25, -0.22, 0.6 + 0.3 + kArm - 0.05);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_EQ(names(model, plan.joints).front(), "lift");
  EXPECT_EQ(plan.joints.size(), 7U);
  // As fast as the lift is: 0.1 m/s, of which half was asked for.
  EXPECT_LT(plan.duration(), 0.4 / 0.05 + 2.0);
}

TEST_F(CarriedArm, TheBaseDrivesToWhatIsFarAndAroundWhatStandsThere) {
  around.push_back(box(1.0, -0.1, 0.35, 0.1, 0.6, 0.7));
  const ArmPlan plan = to(2.0, -0.2, 0.75);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_EQ(names(model, plan.joints).front(), "base_x");
  EXPECT_EQ(plan.joints.size(), 9U) << "the lift rests";
  EXPECT_GT(plan.path.back().q[0], 2.0 - kArm - 0.3);
  EXPECT_LT(plan.duration(), 20.0) << "2 m at 0.25 m/s, and around";
  Collision collision(model);
  collision.set_obstacles(around);
  Kinematics k(model);
  for (double t = 0.0; t < plan.duration(); t += 0.01) {
    k.update(posture_at(plan, start, t));
    ASSERT_FALSE(collision.in_collision(k)) << t;
  }
}

TEST_F(CarriedArm, WhatIsFarAndHighTakesAll) {
  const ArmPlan plan = to(2.0, -0.2, 0.6 + 0.3 + kArm - 0.05);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_EQ(plan.joints.size(), 10U);
  EXPECT_GT(plan.path.back().q[3], 0.2);
}

TEST_F(CarriedArm, BeyondItsAreaIsOutOfReach) {
  EXPECT_EQ(to(3.0 + kArm + 0.5, 0.0, 0.7).status, ArmPathStatus::kUnreachable);
}

// The wheels are 2 mm above the ground wherever the base goes; a hand is kept off it.
TEST_F(CarriedArm, TheGroundIsInTheWayOfAnArmAloneNotOfWheels) {
  EXPECT_EQ(to(1.5, -0.2, 0.005).status, ArmPathStatus::kGoalInCollision);
  Collision collision(model);
  collision.set_obstacles(around);
  Kinematics k(model);
  k.update(start);
  EXPECT_FALSE(collision.nearer_than(k, 0.010));
  EXPECT_TRUE(stays_above_ground(model, model.find_link("trolley")));
  EXPECT_TRUE(stays_above_ground(model, model.find_link("carriage")));
  EXPECT_FALSE(stays_above_ground(model, model.find_link("left_hand")));
  around.front().pose.translation().z() = 0.0;  // a slab that stands out
  collision.set_obstacles(around);
  EXPECT_TRUE(collision.nearer_than(k, 0.010));
}

// Three arms, none a left or a right one: each goes where it is sent by its number, and the others rest.
TEST(NamedArm, EachOfThreeReaches) {
  const Model three = test::three_arms();
  const Configuration start(three);
  ArmPlanner planner(three);
  planner.set_obstacles({});
  const std::array<Eigen::Vector3d, 3> places{Eigen::Vector3d(0.45, 0.1, 0.85), Eigen::Vector3d(0.1, 0.45, 0.85), Eigen::Vector3d(-0.45, 0.1, 0.85)};
  for (const int i : {0, 1, 2}) {
    const Eigen::Vector3d& to = places[at(i)];
    const ArmPlan plan = planner.plan(hand_to(static_cast<ArmSide>(3 + i), to.x(), to.y(), to.z()), start, kGroundFrame, 3);
    ASSERT_EQ(plan.status, ArmPathStatus::kOk) << three.more_hands[at(i)].name << ": " << describe(plan);
    EXPECT_EQ(plan.joints, three.more_hands[at(i)].joints);
    Kinematics k(three);
    k.update(posture_at(plan, start, plan.duration()));
    const Hand& hand = three.more_hands[at(i)];
    EXPECT_LT((k.link_in_world(hand.link) * hand.frame.translation() - to).norm(), 1e-3);
  }
  // What says right means the first of them; a number that none has is refused.
  const ArmPlan right = planner.plan(hand_to(ArmSide::kRight, 0.45, 0.1, 0.85), start, kGroundFrame, 3);
  EXPECT_EQ(right.joints, three.more_hands[0].joints);
  const ArmPlan none = planner.plan(hand_to(ArmSide::kSixth, 0.45, 0.1, 0.85), start, kGroundFrame, 3);
  EXPECT_EQ(none.status, ArmPathStatus::kBadGoal);
  EXPECT_EQ(none.complaint, "the robot has no such hand");
}

TEST_F(CarriedArm, OnAFixedBaseTheLiftIsAllThatHelps) {
  model = test::carried_arms(false);
  start = Configuration(model, "half_sitting");
  around.clear();
  EXPECT_EQ(to(2.0, -0.2, 0.75).status, ArmPathStatus::kUnreachable);
  EXPECT_EQ(to(0.25, -0.22, 0.6 + 0.3 + kArm - 0.05).joints.size(), 7U);
}

}  // namespace
}  // namespace twinbus
