#include "planner/arm_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ArmPlanner, EveryRefusalHasItsReason) {
  const Configuration start = standing();
  ArmPlan plan = plan_with({}, hand_to(ArmSide::kLeft, 0.9, 0.26, 0.86), start, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kUnreachable);
  EXPECT_GT(plan.miss, 0.05);
  EXPECT_NE(describe(plan).find("out of reach by 0."), std::string::npos);

  plan = plan_with({}, hand_to(ArmSide::kLeft, 0.0, 0.0, 0.9), start, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kGoalInCollision) << describe(plan);
  EXPECT_NE(describe(plan).find("would touch"), std::string::npos);

  plan = plan_with({box(0.42, 0.26, 0.86, 0.2, 0.2, 0.2)},
                   hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86), start, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kGoalInCollision);
  EXPECT_NE(describe(plan).find("obstacle 1"), std::string::npos)
      << describe(plan);

  // Around the left hand as it stands.
  const ArmPlan probe = plan_with({}, hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86), start, 1);
  const Eigen::Vector3d hand = hand_at(probe, start, ArmSide::kLeft, 0.0);
  plan = plan_with({box(hand.x(), hand.y(), hand.z(), 0.1, 0.1, 0.1)},
                   hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86), start, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kStartInCollision);
  EXPECT_NE(describe(plan).find("already"), std::string::npos);
}

// A goal may be as near as the guard lets links be that are near by design; of others it is refused.
TEST(ArmPlanner, AGoalKeepsOfLinksThatAreNearByDesignWhatTheGuardKeeps) {
  const Configuration start = standing();
  Configuration at_goal = start;
  Collision collision(hrp1s());
  Kinematics kinematics(hrp1s());
  const int shoulder = hrp1s().find_joint("LARM_SHOULDER_R");
  ASSERT_GE(shoulder, 0);
  PairDistance nearest;
  for (nearest.distance = 1.0; nearest.distance > 0.009;) {  // towards the body
    at_goal.q[shoulder] -= 0.001;
    ASSERT_GT(at_goal.q[shoulder], hrp1s().joints[static_cast<std::size_t>(shoulder)].lower);
    kinematics.update(at_goal);
    collision.near_pairs(kinematics, 1.0, &nearest, 1);
  }
  ArmGoal goal = hand_to(ArmSide::kLeft, 0.0, 0.0, 0.0);
  goal.kind = ArmGoalKind::kJoints;
  for (std::size_t k = 0; k < hrp1s().bus_joints.size(); ++k) {
    const int joint = hrp1s().bus_joints[k];
    goal.q[k] = at_goal.q[joint];
    const auto& arm = hrp1s().hands[0].joints;
    if (std::find(arm.begin(), arm.end(), joint) != arm.end()) goal.joint_mask |= std::int64_t{1} << k;
  }
  EXPECT_EQ(plan_with({}, goal, start, 1).status, ArmPathStatus::kGoalInCollision);
  Model close = hrp1s();
  std::array<PairDistance, 16> near;
  const int count = collision.near_pairs(kinematics, 0.013, near.data(), 16);
  for (int i = 0; i < count; ++i) {
    const PairDistance& pair = near[static_cast<std::size_t>(i)];
    close.near_pairs.push_back({pair.link_a, pair.link_b, 0.003});
  }
  ArmPlanner planner(close);
  const ArmPlan plan = planner.plan(goal, start, kGround, 1);
  EXPECT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_GT(plan.clearance, 0.003);
}

TEST(ArmPlanner, ABoxedInHandIsToldThatThereIsNoWay) {
  const Configuration start = standing();
  const ArmPlan probe = plan_with({}, hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86), start, 1);
  const Eigen::Vector3d hand = hand_at(probe, start, ArmSide::kLeft, 0.0);
  // Walls on all sides but above, where the arm comes in.
  const double r = 0.14;
  const std::vector<Obstacle> cage = {box(hand.x() + r, hand.y(), hand.z(), 0.01, 2 * r, 0.5),
                                      box(hand.x() - r, hand.y(), hand.z(), 0.01, 2 * r, 0.5),
                                      box(hand.x(), hand.y() + r, hand.z(), 2 * r, 0.01, 0.5),
                                      box(hand.x(), hand.y() - r, hand.z(), 2 * r, 0.01, 0.5)};
  const auto plan_by = [&](int rounds) {
    ArmPlannerConfig config;
    config.rrt_rounds = rounds;
    ArmPlanner planner(hrp1s(), config);
    planner.set_obstacles(cage);
    return planner.plan(hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86), start, kGround, 1);
  };
  const ArmPlan plan = plan_by(60);
  EXPECT_EQ(plan.status, ArmPathStatus::kTimeLimit);
  EXPECT_EQ(plan.rounds, 5 * 60);  // not before it was looked for with patience
  EXPECT_TRUE(plan.path.empty());
  EXPECT_GT(describe(plan).size(), 20U);
  const ArmPlan patient = plan_by(150);  // over the walls
  ASSERT_EQ(patient.status, ArmPathStatus::kOk) << describe(patient);
  EXPECT_GT(patient.rounds, 150);
  SecondOpinion opinion(cage);
  EXPECT_EQ(opinion.touching(patient, start, 0.005), 0);
}

TEST(ArmPlanner, NonsenseIsRefusedWithOneSentence) {
  const Configuration start = standing();
  ArmPlanner planner(hrp1s());
  const auto complaint = [&](const ArmGoal& goal) {
    const ArmPlan plan = planner.plan(goal, start, kGround, 1);
    EXPECT_EQ(plan.status, ArmPathStatus::kBadGoal);
    EXPECT_TRUE(plan.path.empty());
    const std::string text = describe(plan);
    EXPECT_EQ(text.find("the goal makes no sense: "), 0U) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
    return text;
  };
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ArmGoal goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
      goal.position[axis] = bad;
      complaint(goal);
    }
    for (std::size_t part = 0; part < 4; ++part) {
      ArmGoal goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
      goal.kind = ArmGoalKind::kPose;
      goal.orientation[part] = bad;
      complaint(goal);
    }
    ArmGoal goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
    goal.speed = static_cast<float>(bad);
    complaint(goal);
  }
  ArmGoal goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
  goal.kind = ArmGoalKind::kPose;
  goal.orientation = {0.0, 0.0, 0.0, 0.0};
  complaint(goal);
  for (const float speed : {0.0F, -1.0F, 1.5F}) {
    goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
    goal.speed = speed;
    complaint(goal);
  }
  goal = hand_to(ArmSide::kNone, 0.42, 0.26, 0.86);
  complaint(goal);
  goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
  goal.kind = ArmGoalKind::kCancel;
  complaint(goal);

  goal = ArmGoal{};
  goal.kind = ArmGoalKind::kJoints;
  complaint(goal);  // no joint named
  const int leg = hrp1s().find_joint("LLEG_KNEE");
  goal.joint_mask = std::int64_t{1} << hrp1s().bus_index[static_cast<std::size_t>(leg)];
  EXPECT_NE(complaint(goal).find("not of an arm"), std::string::npos);
  const int elbow = hrp1s().find_joint("LARM_ELBOW");
  const auto bus = static_cast<std::size_t>(hrp1s().bus_index[static_cast<std::size_t>(elbow)]);
  goal.joint_mask = std::int64_t{1} << bus;
  goal.q[bus] = 5.0;
  EXPECT_NE(complaint(goal).find("limits"), std::string::npos);
  goal.q[bus] = kNan;
  complaint(goal);
  goal.joint_mask = ~std::int64_t{0};
  complaint(goal);
}

TEST(ArmPlanner, AbsurdObstaclesAreLeftOutOrRefusedNeverObeyed) {
  const Configuration start = standing();
  const ArmGoal goal = hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86);
  std::vector<Obstacle> none = {box(kNan, 0, 0, 1, 1, 1), box(0.3, 0.2, 0.8, kNan, 1, 1),
                                box(0.3, 0.2, 0.8, -1, 1, 1), box(0.3, 0.2, 0.8, 0, 1, 1)};
  none[0].pose.linear() *= kNan;
  EXPECT_EQ(plan_with(none, goal, start, 1).status, ArmPathStatus::kOk);
  const ArmPlan buried = plan_with({box(0, 0, 0, 1e3, 1e3, 1e3)}, goal, start, 1);
  EXPECT_EQ(buried.status, ArmPathStatus::kStartInCollision);
  const std::vector<Obstacle> many(500, box(5, 5, 5, 0.1, 0.1, 0.1));
  EXPECT_EQ(plan_with(many, goal, start, 1).status, ArmPathStatus::kOk);
}

// hrp1s with its left hand pinned to its trunk: the left arm is a closed loop, the right one is not.
TEST(ArmPlanner, AGoalForAnArmInAClosedLoopIsRefusedByTheNameOfAJoint) {
  const Model looped = load_robot_texts(
      {.folder = hrp1s().folder,
       .yaml = hrp1s().yaml_text + "\nloops:\n  - {link: LHAND, to: CHEST}\n",
       .urdf = hrp1s().urdf_text,
       .srdf = hrp1s().srdf_text});
  ArmPlanner planner(looped);
  const ArmPlan right =
      planner.plan(hand_to(ArmSide::kRight, 0.40, -0.30, 0.95), standing(), kGround, 1);
  EXPECT_EQ(right.status, ArmPathStatus::kOk) << describe(right);
  ArmGoal joints;
  joints.goal_id = 1;
  joints.kind = ArmGoalKind::kJoints;
  joints.speed = 0.5F;
  const int elbow = looped.find_joint("LARM_ELBOW");
  ASSERT_GE(elbow, 0);
  joints.joint_mask = std::int64_t{1} << looped.bus_index[static_cast<std::size_t>(elbow)];
  for (const ArmGoal& goal : {joints, hand_to(ArmSide::kLeft, 0.42, 0.26, 0.86)}) {
    const ArmPlan left = planner.plan(goal, standing(), kGround, 1);
    EXPECT_EQ(left.status, ArmPathStatus::kBadGoal);
    EXPECT_NE(describe(left).find("joint LARM_"), std::string::npos);
    EXPECT_NE(describe(left).find("closed loop"), std::string::npos);
  }
}

}  // namespace
}  // namespace twinbus
