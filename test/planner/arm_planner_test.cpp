#include "planner/arm_planner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "common/math/index.h"
#include "common/math/splitmix64.h"
#include "planner/timing/motion_effort.h"
#include "robot/dynamics/gravity_load.h"
#include "test/planner/reach_rig.h"
#include "test/rounds.h"
#include "test/oracles/fcl_oracle.h"

namespace twinbus {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Eigen::Isometry3d kGround = Eigen::Isometry3d::Identity();

ArmPlan plan_with(const std::vector<Obstacle>& obstacles, const ArmGoal& goal,
                  const Configuration& start, std::uint64_t seed) {
  ArmPlanner planner(hrp1s());
  planner.set_obstacles(obstacles);
  return planner.plan(goal, start, kGround, seed);
}

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
