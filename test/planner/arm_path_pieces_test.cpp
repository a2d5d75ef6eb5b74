#include "planner/arm_path_pieces.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

ArmPlan plan_of(int knots, int joints) {
  ArmPlan plan;
  plan.status = ArmPathStatus::kOk;
  plan.clearance = 0.014;
  for (int k = 0; k < joints; ++k) plan.joints.push_back(10 + k);
  for (int i = 0; i < knots; ++i) {
    Knot knot;
    knot.time = 0.1 * i;
    knot.q = JointPoint::Constant(joints, 1.0 + i);
    knot.qd = JointPoint::Constant(joints, -1.0 * i);
    plan.path.push_back(knot);
  }
  return plan;
}

const ArmPathIds kIds{.planner_id = 1, .run_id = 2, .goal_id = 3, .path_id = 4};

TEST(ArmPathPieces, PutTogetherAgainArePathThatWasPlanned) {
  for (const int knots : {2, 6, 7, 12, 13, 360}) {
    const ArmPlan plan = plan_of(knots, 7);
    const std::vector<ArmPathPiece> pieces = to_pieces(plan, kIds);
    ASSERT_EQ(pieces.size(),
              static_cast<std::size_t>((knots + kKnotsPerPiece - 1) / kKnotsPerPiece));
    std::size_t knot = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const ArmPathPiece& piece = pieces[p];
      EXPECT_EQ(piece.planner_id, 1);
      EXPECT_EQ(piece.run_id, 2);
      EXPECT_EQ(piece.goal_id, 3);
      EXPECT_EQ(piece.path_id, 4);
      EXPECT_EQ(piece.piece, static_cast<int>(p));
      EXPECT_EQ(piece.pieces, static_cast<int>(pieces.size()));
      EXPECT_EQ(piece.joint_count, 7);
      EXPECT_EQ(piece.joint[6], 16);
      EXPECT_FLOAT_EQ(piece.clearance, 0.014F);
      for (int row = 0; row < piece.knot_count; ++row, ++knot) {
        const auto r = static_cast<std::size_t>(row);
        EXPECT_DOUBLE_EQ(piece.time[r], plan.path[knot].time);
        EXPECT_DOUBLE_EQ(piece.q[r][6], plan.path[knot].q[6]);
        EXPECT_FLOAT_EQ(piece.qd[r][6], static_cast<float>(plan.path[knot].qd[6]));
      }
    }
    EXPECT_EQ(knot, plan.path.size());
  }
}

TEST(ArmPathPieces, ARefusalIsOneMessageWithItsReasonAndNoPiece) {
  ArmPlan plan;
  plan.status = ArmPathStatus::kGoalInCollision;
  plan.pair = {5, 500};
  plan.miss = 0.25;
  const std::vector<ArmPathPiece> pieces = to_pieces(plan, kIds);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].pieces, 0);
  EXPECT_EQ(pieces[0].status, ArmPathStatus::kGoalInCollision);
  EXPECT_EQ(pieces[0].link_a, 5);
  EXPECT_EQ(pieces[0].link_b, 127) << "what does not fit is cut off, not wrapped";
  EXPECT_FLOAT_EQ(pieces[0].miss, 0.25F);
}

}  // namespace
}  // namespace twinbus
