#include "planner/arm_planner.h"

#include <gtest/gtest.h>

#include "common/math/index.h"
#include "planner/timing/motion_effort.h"
#include "robot/dynamics/gravity_load.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

// A posture that its joints cannot hold is no answer, however free it is.
TEST(ArmPlanner, AGoalWhereTheArmIsTooHeavyIsRefusedWithTheJoint) {
  Model weak = hrp1s();
  const int elbow = weak.hands[0].joints[3];
  weak.joints[at(elbow)].effort = 0.1;
  const ArmPlan plan = ArmPlanner(weak).plan(hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86), standing(), kGround, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kBadGoal);
  EXPECT_EQ(plan.complaint, "there joint " + weak.joints[at(elbow)].name + " would need more than its effort limit to hold the arm");
  EXPECT_EQ(plan.heavy, ArmPlan::Heavy::kThere);
  EXPECT_EQ(describe(plan).find(plan.complaint), 0U) << "such a goal makes sense";
}

// Where the straight way is too heavy in its middle another one is taken.
TEST(ArmPlanner, AWayThatIsTooHeavyIsGoneAround) {
  Model weak = hrp1s();
  const int shoulder = weak.hands[0].joints[0], elbow = weak.hands[0].joints[3];
  Configuration there = standing();
  there.q[elbow] = -0.1;
  there.q[shoulder] = -1.57;
  GravityLoad load(weak);
  weak.joints[at(shoulder)].effort = 0.8 * load.of(there, {shoulder}).effort;
  there.q[shoulder] = 0.0;
  ArmGoal goal;
  goal.kind = ArmGoalKind::kJoints;
  goal.speed = 0.2F;
  for (const int joint : weak.hands[0].joints) {
    const auto k = static_cast<std::size_t>(weak.bus_index[at(joint)]);
    goal.joint_mask |= std::int64_t{1} << k;
    goal.q[k] = there.q[joint];
  }
  const auto k = static_cast<std::size_t>(weak.bus_index[at(shoulder)]);
  goal.q[k] = -2.6;
  const ArmPlan plan = ArmPlanner(weak).plan(goal, there, kGround, 1);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_EQ(plan.complaint, "") << "of the way that was too heavy";
  MotionEffort effort(weak, there, plan.joints);
  JointPoint q, qd, qdd;
  for (double t = 0.0; t <= plan.duration(); t += 0.01) {
    sample(plan.path, t, q, qd, qdd);
    EXPECT_TRUE(effort.holds(q)) << t;
  }
  EXPECT_FALSE(effort.holds(0.5 * (plan.path.front().q + plan.path.back().q)));
  EXPECT_NEAR(q[0], -2.6, 0.01);
}

// With no way around it is looked for again, nearer to what stands around, before the joint is named.
TEST(ArmPlanner, OnlyWaysThatAreTooHeavyAreRefusedWithTheJointAfterAllPatience) {
  Model weak = hrp1s();
  const std::vector<int>& arm = weak.hands[0].joints;
  Configuration there = standing();
  there.q[arm[3]] = -0.1;
  there.q[arm[0]] = -1.57;
  GravityLoad load(weak);
  weak.joints[at(arm[0])].effort = 0.8 * load.of(there, {arm[0]}).effort;
  there.q[arm[0]] = 0.0;
  ArmGoal goal;
  goal.kind = ArmGoalKind::kJoints;
  goal.speed = 0.2F;
  for (const int joint : arm) {
    const auto k = static_cast<std::size_t>(weak.bus_index[at(joint)]);
    goal.joint_mask |= std::int64_t{1} << k;
    goal.q[k] = there.q[joint];
    if (joint == arm[0]) continue;
    weak.joints[at(joint)].lower = there.q[joint] - 0.05;
    weak.joints[at(joint)].upper = there.q[joint] + 0.05;
  }
  goal.q[static_cast<std::size_t>(weak.bus_index[at(arm[0])])] = -2.6;
  ArmPlanner planner(weak);
  planner.set_obstacles({post(2.0, 0.0)});
  const ArmPlan plan = planner.plan(goal, there, kGround, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kBadGoal) << describe(plan);
  EXPECT_EQ(plan.heavy, ArmPlan::Heavy::kOnTheWay);
  EXPECT_NE(plan.complaint.find(weak.joints[at(arm[0])].name), std::string::npos) << plan.complaint;
  EXPECT_EQ(plan.padding, 0.0);
}

// Damping and friction take of the efforts: the motion leaves its joints enough for them, and where friction takes all it is refused.
TEST(ArmPlanner, JointsThatRubMoveAsFastAsTheirEffortsAllowAndAreNamedWhereTheyDoNot) {
  const ArmGoal goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
  const ArmPlan easy = plan_with({}, goal, standing(), 1);
  Model rubs = hrp1s();
  for (const int j : rubs.hands[0].joints) {
    Joint& joint = rubs.joints[at(j)];
    joint.friction = 0.3 * joint.effort;
    joint.damping = 8.0 * joint.effort / joint.velocity;
  }
  const ArmPlan plan = ArmPlanner(rubs).plan(goal, standing(), kGround, 1);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_GT(plan.duration(), 1.2 * easy.duration());
  MotionEffort effort(rubs, standing(), plan.joints);
  EXPECT_LE(effort.slower(plan.path), 1.0 + 1e-9);
  EXPECT_GT(effort.largest(), 0.5) << "of an arm that could be faster";
  const int elbow = rubs.hands[0].joints[3];
  rubs.joints[at(elbow)].friction = 2.0 * rubs.joints[at(elbow)].effort;
  ArmGoal bend;
  bend.kind = ArmGoalKind::kJoints;
  bend.speed = 0.5F;
  const auto k = static_cast<std::size_t>(rubs.bus_index[at(elbow)]);
  bend.joint_mask = std::int64_t{1} << k;
  bend.q[k] = standing().q[elbow] - 0.5;
  const ArmPlan none = ArmPlanner(rubs).plan(bend, standing(), kGround, 1);
  EXPECT_EQ(none.status, ArmPathStatus::kBadGoal) << describe(none);
  EXPECT_EQ(none.complaint, "on the way joint " + rubs.joints[at(elbow)].name + " would need more than its effort limit to move the arm against its friction");
}

}  // namespace
}  // namespace twinbus
