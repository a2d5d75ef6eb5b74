#include "planner/arm_planner.h"

#include <gtest/gtest.h>

#include <array>

#include "common/math/splitmix64.h"
#include "test/planner/reach_rig.h"
#include "test/rounds.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {
namespace {

void expect_within_limits(const ArmPlan& plan, double speed, double full_speed_time) {
  JointPoint q, qd, qdd;
  for (double t = 0.0; t <= plan.duration(); t += 0.001) {
    sample(plan.path, t, q, qd, qdd);
    for (int k = 0; k < q.size(); ++k) {
      const Joint& joint =
          hrp1s().joints[static_cast<std::size_t>(plan.joints[static_cast<std::size_t>(k)])];
      ASSERT_LE(q[k], joint.upper + 1e-6);
      ASSERT_GE(q[k], joint.lower - 1e-6);
      ASSERT_LE(std::abs(qd[k]), speed * joint.velocity * (1.0 + 1e-6));
      ASSERT_LE(std::abs(qdd[k]), speed * joint.velocity / full_speed_time * (1.0 + 1e-6));
    }
  }
}

TEST(ArmPlanner, TheHandArrivesWhereItWasSent) {
  const Configuration start = standing();
  for (const auto& [side, x, y, z] : {std::tuple{ArmSide::kLeft, 0.42, 0.26, 0.86},
                                      std::tuple{ArmSide::kRight, 0.40, -0.30, 0.95},
                                      std::tuple{ArmSide::kLeft, 0.30, 0.10, 1.05}}) {
    const ArmPlan plan = plan_with({}, hand_to(side, x, y, z), start, 1);
    ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
    EXPECT_LT((hand_at(plan, start, side, plan.duration()) - Eigen::Vector3d(x, y, z)).norm(),
              1e-3);
    for (std::size_t k = 0; k < plan.joints.size(); ++k)
      EXPECT_DOUBLE_EQ(plan.path.front().q[static_cast<int>(k)], start.q[plan.joints[k]]);
    expect_within_limits(plan, 0.5, ArmPlannerConfig{}.full_speed_time);
  }
}

// Posts put at random into the way: every path that is found is looked at by FCL's other solver.
TEST(ArmPlanner, PathsAroundPostsTouchNothing) {
  SplitMix64 random(20261121);
  int found = 0;
  int around = 0;
  for (int round = 0; round < test::rounds(24); ++round) {
    const ArmSide side = round % 2 == 0 ? ArmSide::kLeft : ArmSide::kRight;
    const double way = side == ArmSide::kLeft ? 1.0 : -1.0;
    const std::vector<Obstacle> obstacles = {
        post(random.uniform(0.25, 0.35), way * random.uniform(0.22, 0.34)),
        box(0.62, 0.0, 0.60, 0.40, 1.0, 0.04)};
    Configuration start = standing();
    const ArmPlan there =
        plan_with(obstacles, hand_to(side, 0.33, way * random.uniform(0.40, 0.48), 0.90), start,
                  100 + static_cast<std::uint64_t>(round));
    if (there.status != ArmPathStatus::kOk) continue;
    SecondOpinion opinion(obstacles);
    EXPECT_EQ(opinion.touching(there, start, 0.01), 0) << "round " << round;
    for (std::size_t k = 0; k < there.joints.size(); ++k)
      start.q[there.joints[k]] = there.path.back().q[static_cast<int>(k)];
    const ArmPlan back =
        plan_with(obstacles, hand_to(side, 0.33, way * random.uniform(0.06, 0.14), 0.95), start,
                  200 + static_cast<std::uint64_t>(round));
    if (back.status != ArmPathStatus::kOk) continue;
    ++found;
    around += back.rounds > 0 ? 1 : 0;
    EXPECT_EQ(opinion.touching(back, start, 0.005), 0) << "round " << round;
    EXPECT_GE(opinion.nearest(back, start, 0.002, 0.05), back.clearance - 1e-6)
        << "round " << round;
    expect_within_limits(back, 0.5, ArmPlannerConfig{}.full_speed_time);
    ArmPlanner planner(hrp1s());
    planner.set_obstacles(obstacles);
    EXPECT_TRUE(planner.path_free(back, start, 0.5 * back.clearance));
  }
  std::printf("%d of %d problems solved, %d around something\n", found, test::rounds(24), around);
  EXPECT_GE(found, test::rounds(12));
  EXPECT_GE(around, test::rounds(6));
}

// A balancing body moves by a centimetre or two while its arm does: where there is room, the way
// stays farther from obstacles than the guard's margin and that.
TEST(ArmPlanner, ObstaclesArePassedAtADistanceWhereThereIsRoom) {
  Configuration start = standing();
  const std::vector<Obstacle> obstacles = {post(0.30, 0.27)};
  for (const double y : {0.44, 0.12}) {
    const ArmPlan plan = plan_with(obstacles, hand_to(ArmSide::kLeft, 0.33, y, 0.92), start, 1);
    ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
    EXPECT_DOUBLE_EQ(plan.padding, ArmPlannerConfig{}.padding);
    const double to_post = nearest_to_obstacles(obstacles, plan, start);
    EXPECT_GE(to_post, plan.clearance + plan.padding - 1e-6);
    for (std::size_t k = 0; k < plan.joints.size(); ++k)
      start.q[plan.joints[k]] = plan.path.back().q[static_cast<int>(k)];
  }
  // A goal beside the post is not refused for that.
  const ArmPlan near_plan =
      plan_with(obstacles, hand_to(ArmSide::kLeft, 0.30, 0.36, 0.92), standing(), 1);
  ASSERT_EQ(near_plan.status, ArmPathStatus::kOk) << describe(near_plan);
}

// A long rod in the hand is brought around posts that the hand alone would pass.
TEST(ArmPlanner, WhatIsHeldTouchesNothingOnTheWay) {
  const Configuration start = standing();
  Obstacle rod;
  rod.shape = ObstacleShape::kCylinder;
  rod.size = Eigen::Vector3d(0.015, 0.3, 0.0);
  rod.pose.translation() = Eigen::Vector3d(0.03, 0.0, -0.12);  // clear of the wrist
  SplitMix64 random(20261122);
  int found = 0, other = 0;
  for (int round = 0; round < test::rounds(16); ++round) {
    const ArmSide side = round % 2 == 0 ? ArmSide::kLeft : ArmSide::kRight;
    const double way = side == ArmSide::kLeft ? 1.0 : -1.0;
    rod.hand = side == ArmSide::kLeft ? 0 : 1;
    const std::vector<Obstacle> posts{post(random.uniform(0.32, 0.5), way * random.uniform(0.1, 0.4))};
    std::vector<Obstacle> all = posts;
    all.push_back(rod);
    const ArmGoal goal = hand_to(side, random.uniform(0.3, 0.42), way * random.uniform(0.05, 0.45), random.uniform(0.8, 1.0));
    const ArmPlan plan = plan_with(all, goal, start, 1), empty = plan_with(posts, goal, start, 1);
    if (plan.status != ArmPathStatus::kOk) continue;
    ++found;
    other += empty.status != plan.status || empty.duration() != plan.duration() ? 1 : 0;
    Collision watch(hrp1s());
    watch.set_obstacles(all);
    FclOracle oracle(hrp1s());
    oracle.set_obstacles(all);
    Kinematics kinematics(hrp1s());
    for (double t = 0.0; t <= plan.duration(); t += 0.004) {
      kinematics.update(posture_at(plan, start, t));
      PairDistance pair;
      const int held = hrp1s().link_count() + 1;
      const bool known = watch.pair_nearer_than(kinematics, held - 1, held, 1.0, pair);
      ASSERT_TRUE(!known || pair.distance >= plan.clearance - 1e-5);
      for (const CollisionPair& each : watch.held_pairs()) ASSERT_FALSE(oracle.touches(kinematics, each));
    }
  }
  EXPECT_GE(found, test::rounds(6));
  EXPECT_GE(other, test::rounds(3));
}

TEST(ArmPlanner, TheSameSeedGivesTheSameMotionBitForBit) {
  const std::vector<Obstacle> obstacles = {post(0.30, 0.27)};
  const Configuration start = standing();
  const ArmGoal goal = hand_to(ArmSide::kLeft, 0.33, 0.10, 0.95);
  ArmPlanner planner(hrp1s());
  planner.set_obstacles(obstacles);
  const ArmPlan first = planner.plan(goal, start, kGround, 9);
  ASSERT_EQ(first.status, ArmPathStatus::kOk) << describe(first);
  planner.set_obstacles({});
  (void)planner.plan(hand_to(ArmSide::kRight, 0.4, -0.3, 0.95), start, kGround,
                     3);  // another question between
  planner.set_obstacles(obstacles);
  for (const ArmPlan& again :
       {planner.plan(goal, start, kGround, 9), plan_with(obstacles, goal, start, 9)}) {
    ASSERT_EQ(again.path.size(), first.path.size());
    EXPECT_EQ(again.rounds, first.rounds);
    for (std::size_t i = 0; i < first.path.size(); ++i) {
      ASSERT_EQ(again.path[i].time, first.path[i].time);
      ASSERT_EQ(again.path[i].q, first.path[i].q);
      ASSERT_EQ(again.path[i].qd, first.path[i].qd);
    }
  }
}

// Each thing has balls of its own, also when another one was held meanwhile.
TEST(ArmPlanner, WhatIsHeldAgainGivesTheMotionOfAPlannerThatKnewNoOther) {
  const Configuration start = standing();
  Obstacle rod;
  rod.shape = ObstacleShape::kCylinder;
  rod.pose.translation() = Eigen::Vector3d(0.03, 0.0, -0.12);
  rod.hand = 0;
  ArmPlanner planner(hrp1s());
  int found = 0, other = 0;
  for (const double y : {0.10, 0.25, 0.40}) {
    const ArmGoal goal = hand_to(ArmSide::kLeft, 0.33, y, 0.95);
    std::array<double, 2> before{};
    for (std::size_t round = 0; round < 4; ++round) {
      rod.size = Eigen::Vector3d(0.015, round % 2 == 0 ? 0.3 : 0.1, 0.0);
      const std::vector<Obstacle> things{post(0.36, 0.15), rod};
      planner.set_obstacles(things);
      const ArmPlan plan = planner.plan(goal, start, kGround, 9);
      if (round >= 2) EXPECT_EQ(plan.duration(), before[round - 2]);
      else before[round] = plan.duration();
      if (round > 1) continue;
      const ArmPlan fresh = plan_with(things, goal, start, 9);
      ASSERT_EQ(plan.status, fresh.status);
      ASSERT_EQ(plan.path.size(), fresh.path.size());
      for (std::size_t i = 0; i < plan.path.size(); ++i) ASSERT_EQ(plan.path[i].q, fresh.path[i].q);
      found += plan.status == ArmPathStatus::kOk ? 1 : 0;
    }
    other += before[0] != before[1] ? 1 : 0;
  }
  EXPECT_GE(found, 2);
  EXPECT_GE(other, 1);
}

TEST(ArmPlanner, JointGoalsOfBothArmsAreReached) {
  Configuration start = standing();
  ArmGoal goal;
  goal.kind = ArmGoalKind::kJoints;
  goal.speed = 1.0F;
  for (const char* name : {"LARM_SHOULDER_P", "RARM_SHOULDER_P", "LARM_ELBOW"}) {
    const int joint = hrp1s().find_joint(name);
    const int bus = hrp1s().bus_index[static_cast<std::size_t>(joint)];
    goal.joint_mask |= std::int64_t{1} << bus;
    goal.q[static_cast<std::size_t>(bus)] = -0.9;
  }
  const ArmPlan plan = plan_with({}, goal, start, 1);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk) << describe(plan);
  EXPECT_EQ(plan.joints.size(), 3U);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(plan.path.back().q[k], -0.9, 1e-9);
}

TEST(ArmPlanner, BeingThereAlreadyIsAMotionOfAnInstant) {
  const Configuration start = standing();
  ArmGoal goal;
  goal.kind = ArmGoalKind::kJoints;
  const int joint = hrp1s().find_joint("LARM_ELBOW");
  const auto bus = static_cast<std::size_t>(hrp1s().bus_index[static_cast<std::size_t>(joint)]);
  goal.joint_mask = std::int64_t{1} << bus;
  goal.q[bus] = start.q[joint];
  const ArmPlan plan = plan_with({}, goal, start, 1);
  ASSERT_EQ(plan.status, ArmPathStatus::kOk);
  EXPECT_GT(plan.duration(), 0.0);
  EXPECT_LT(plan.duration(), 0.5);
}

TEST(ArmPlanner, StopsWhenToldTo) {
  ArmPlannerConfig config;
  ArmPlanner planner(hrp1s(), config);
  planner.set_obstacles({post(0.30, 0.27)});
  const ArmPlan plan = planner.plan(hand_to(ArmSide::kLeft, 0.33, 0.10, 0.95), standing(), kGround,
                                    9, [](void*) { return false; });
  EXPECT_TRUE(plan.status == ArmPathStatus::kCancelled || plan.rounds == 0);
}

}  // namespace
}  // namespace twinbus
