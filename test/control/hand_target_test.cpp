#include "control/teleop/hand_target.h"

#include <gtest/gtest.h>

#include <limits>

namespace twinbus {
namespace {

using Phase = HandTarget::Phase;
constexpr std::int64_t kMs = 1'000'000;
const Eigen::Vector3d kStill(0.0, 0.0, 0.0);

Eigen::Isometry3d hand_at(const Eigen::Vector3d& place) {
  Eigen::Isometry3d hand = Eigen::Isometry3d::Identity();
  hand.translation() = place;
  return hand;
}
const Eigen::Isometry3d kHand = hand_at({0.3, 0.25, 0.8});

ArmPathPiece answer(const ArmGoal& goal, ArmPathStatus status, std::int64_t path) {
  ArmPathPiece piece;
  piece.goal_id = goal.goal_id;
  piece.path_id = path;
  piece.status = status;
  return piece;
}

ControllerStatus follows(std::int64_t path) {
  ControllerStatus status;
  status.arm_path_id = path;
  return status;
}

// A way of 20 mm that was asked for as goal 100, and its answer.
void answered(HandTarget& target, ArmGoal& goal, ArmPathStatus status, std::int64_t path) {
  target.move({0.02, 0.0, 0.0}, kStill, kHand);
  ASSERT_TRUE(target.next(kMs, 5, 100, goal));
  target.on_path(answer(goal, status, path));
}

TEST(HandTarget, StepsAreAskedForWhereTheHandIs) {
  HandTarget target;
  ArmGoal goal;
  EXPECT_FALSE(target.next(kMs, 5, 100, goal));
  target.choose(ArmSide::kRight);
  target.move({0.02, 0.0, 0.0}, kStill, kHand);
  target.move({0.0, 0.0, 0.02}, kStill, kHand);
  ASSERT_TRUE(target.next(2 * kMs, 5, 100, goal));
  EXPECT_EQ(goal.run_id, 5);
  EXPECT_EQ(goal.goal_id, 100);
  EXPECT_EQ(goal.side, ArmSide::kRight);
  EXPECT_EQ(goal.kind, ArmGoalKind::kPosition);
  EXPECT_NEAR(goal.position[0], 0.32, 1e-12);
  EXPECT_NEAR(goal.position[1], 0.25, 1e-12);
  EXPECT_NEAR(goal.position[2], 0.82, 1e-12);
  EXPECT_FALSE(target.next(3 * kMs, 5, 101, goal));
  ASSERT_TRUE(target.next(70 * kMs, 5, 101, goal)) << "said again while nobody answers";
  EXPECT_EQ(goal.goal_id, 100);
}

TEST(HandTarget, TheNextWayIsAskedForWhenTheLastIsGone) {
  HandTarget target;
  ArmGoal goal;
  answered(target, goal, ArmPathStatus::kOk, 9);
  EXPECT_EQ(target.phase(), Phase::kGoing);
  target.move({0.02, 0.0, 0.0}, kStill, kHand);
  target.on_status(follows(0));  // not yet begun
  EXPECT_FALSE(target.next(2 * kMs, 5, 101, goal));
  target.on_status(follows(9));
  EXPECT_FALSE(target.next(200 * kMs, 5, 101, goal));
  target.on_status(follows(0));
  ASSERT_TRUE(target.next(400 * kMs, 5, 101, goal));
  EXPECT_EQ(goal.goal_id, 101);
  EXPECT_NEAR(goal.position[0], 0.34, 1e-12);
}

TEST(HandTarget, WhereThereIsNoWayTheWishFallsBack) {
  HandTarget target;
  ArmGoal goal;
  answered(target, goal, ArmPathStatus::kUnreachable, 0);
  EXPECT_EQ(target.phase(), Phase::kRefused);
  EXPECT_FALSE(target.next(2 * kMs, 5, 101, goal));
  target.move({0.0, 0.0, 0.02}, kStill, kHand);
  ASSERT_TRUE(target.next(3 * kMs, 5, 101, goal));
  EXPECT_NEAR(goal.position[0], 0.30, 1e-12);
  EXPECT_NEAR(goal.position[2], 0.82, 1e-12);
}

TEST(HandTarget, LettingGoCancelsAndForgets) {
  HandTarget target;
  ArmGoal goal;
  target.stop();
  EXPECT_FALSE(target.next(kMs, 5, 100, goal)) << "nothing to cancel";
  target.move({0.02, 0.0, 0.0}, kStill, kHand);
  ASSERT_TRUE(target.next(2 * kMs, 5, 100, goal));
  target.on_path(answer(goal, ArmPathStatus::kOk, 9));
  target.stop();
  for (int k = 0; k < 5; ++k) {
    ASSERT_TRUE(target.next((3 + k) * kMs, 5, 101, goal));
    EXPECT_EQ(goal.kind, ArmGoalKind::kCancel);
  }
  EXPECT_FALSE(target.next(9 * kMs, 5, 101, goal));
  target.move({0.02, 0.0, 0.0}, kStill, hand_at({0.1, 0.2, 0.9}));
  ASSERT_TRUE(target.next(10 * kMs, 5, 102, goal));
  EXPECT_NEAR(goal.position[0], 0.12, 1e-12) << "from where the hand is now";
}

TEST(HandTarget, ThoseWhoDoNotAnswerAreNotWaitedForForever) {
  HandTarget target;
  ArmGoal goal;
  target.move({0.02, 0.0, 0.0}, kStill, kHand);
  for (std::int64_t ms = 1; ms < 3500; ++ms) (void)target.next(ms * kMs, 5, 100, goal);
  EXPECT_EQ(target.phase(), Phase::kRefused);
  target.move({0.02, 0.0, 0.0}, kStill, kHand);
  ASSERT_TRUE(target.next(3500 * kMs, 5, 101, goal));
  target.on_path(answer(goal, ArmPathStatus::kOk, 9));  // and no controller follows
  bool cancelled = false;
  for (std::int64_t ms = 3501; ms < 7000; ++ms)
    cancelled =
        (target.next(ms * kMs, 5, 102, goal) && goal.kind == ArmGoalKind::kCancel) || cancelled;
  EXPECT_TRUE(cancelled);
  EXPECT_EQ(target.phase(), Phase::kIdle);
}

TEST(HandTarget, AWishStaysNearTheHandAndNonsenseIsIgnored) {
  HandTarget target;
  for (int k = 0; k < 100; ++k) target.move({0.02, 0.0, 0.0}, kStill, kHand);
  EXPECT_LT((target.wanted() - kHand.translation()).norm(), 0.151);
  const Eigen::Vector3d before = target.wanted();
  target.move(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()), kStill, kHand);
  target.move(kStill, Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), kHand);
  EXPECT_EQ(target.wanted(), before);
}

// Nobody turned it: the planner may turn it.  Once turned it keeps that, on its further ways too.
TEST(HandTarget, ATurnIsAboutTheAxesOfTheGroundAndIsKept) {
  HandTarget target;
  ArmGoal goal;
  Eigen::Isometry3d hand = kHand;
  hand.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()).toRotationMatrix();
  target.move(kStill, {0.0, 0.0, 0.1}, hand);
  ASSERT_TRUE(target.next(kMs, 5, 100, goal));
  EXPECT_EQ(goal.kind, ArmGoalKind::kPose);
  const Eigen::Quaterniond expected(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()) * hand.linear());
  const auto asked = [&] {
    return Eigen::Quaterniond(goal.orientation[0], goal.orientation[1], goal.orientation[2], goal.orientation[3]);
  };
  EXPECT_LT(asked().angularDistance(expected), 1e-9);
  EXPECT_NEAR(goal.position[0], 0.3, 1e-12) << "it turns on the spot";
  target.on_path(answer(goal, ArmPathStatus::kOk, 9));
  target.on_status(follows(9));
  target.on_status(follows(0));
  EXPECT_FALSE(target.next(2 * kMs, 5, 101, goal)) << "it has come to its end";
  target.move({0.02, 0.0, 0.0}, kStill, hand);
  ASSERT_TRUE(target.next(3 * kMs, 5, 101, goal));
  EXPECT_EQ(goal.kind, ArmGoalKind::kPose);
  EXPECT_LT(asked().angularDistance(expected), 1e-9);
  for (int k = 0; k < 100; ++k) target.move(kStill, {0.05, 0.0, 0.0}, hand);
  target.on_path(answer(goal, ArmPathStatus::kUnreachable, 0));
  EXPECT_FALSE(target.next(4 * kMs, 5, 102, goal)) << "refused: the wish is what was reached";
  for (int k = 0; k < 100; ++k) target.move(kStill, {0.05, 0.0, 0.0}, hand);
  ASSERT_TRUE(target.next(5 * kMs, 5, 102, goal));
  EXPECT_LT(asked().angularDistance(Eigen::Quaterniond(hand.linear())), 0.501) << "no further ahead of the hand";
  target.stop();
  for (int k = 0; k < 5; ++k) ASSERT_TRUE(target.next((6 + k) * kMs, 5, 103, goal));
  target.move({0.02, 0.0, 0.0}, kStill, hand);
  ASSERT_TRUE(target.next(20 * kMs, 5, 103, goal));
  EXPECT_EQ(goal.kind, ArmGoalKind::kPosition) << "stopped, it keeps no turn";
}

}  // namespace
}  // namespace twinbus
