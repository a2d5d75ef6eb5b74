#include <gtest/gtest.h>

#include "planner/batch/check.h"
#include "test/oracles/clear_cells.h"
#include "test/planner/plates.h"
#include "test/oracles/sort_pairs.h"

namespace twinbus {
namespace {

using Corners = std::vector<Eigen::Vector3d>;
using test::corners_of_box;

// A post in the world, and a link that turns about z past it.
BlockRobot past_a_post(const std::vector<Corners>& link, double ball = 0.5) {
  const Model model = test::turning_link();
  const Eigen::Vector3d at_post(0.3, 0.0, 0.0);
  std::vector<BallGroup> groups{{.link = 0, .balls = {{at_post, 0.1}}, .pieces = {corners_of_box(at_post, {0.02, 0.02, 0.05})}},
                                {.link = 1, .balls = {{Eigen::Vector3d::Zero(), ball}}, .pieces = link}};
  if (link.empty()) groups[0].pieces.clear();
  return compile_robot(model, Configuration(model), {0}, groups, {{0, 1}}, 1e-5);
}

TEST(ClearCells, ChangeNoVerdict) {
  BlockRobot robot = past_a_post({corners_of_box({0.25, 0.0, 0.0}, {0.15, 0.01, 0.01})}), plain = robot;
  find_clear_cells(robot);
  ASSERT_EQ(robot.clear.size(), 1U);
  const ClearCells& cells = robot.clear[0];
  EXPECT_EQ(cells.joints, 1);
  EXPECT_GT(cells.open.back(), 0);
  EXPECT_LT(cells.open.back(), cells.count[0] / 4);
  const BlockScene nothing;
  BlockCheck check(robot, nothing), without(plain, nothing);
  check.settle_pairs(true);
  without.settle_pairs(true);
  int free = 0;
  for (float q = -2.0F; q < 1.6F; q += 0.01F) {
    for (const float step : {0.0F, 0.02F, 0.3F}) {
      EXPECT_EQ(check.line_free(&q, &step, 4), without.line_free(&q, &step, 4)) << q << " " << step;
      EXPECT_EQ(check.line_certain(&q, &step), without.line_certain(&q, &step)) << q << " " << step;
    }
    free += check.point_free(&q) ? 1 : 0;
    // The bar's side is 10 mm from its middle, the post's corner 20 mm: they touch up to an angle between.
    if (std::abs(q) < 0.09F) {
      EXPECT_FALSE(check.point_free(&q)) << q;
    }
    if (std::abs(q) > 0.12F) {
      EXPECT_TRUE(check.point_free(&q)) << q;
    }
  }
  EXPECT_GT(free, 300);
}

TEST(ClearCells, APairThatNeverTouchesIsDropped) {
  BlockRobot over = past_a_post({corners_of_box({0.25, 0.0, 0.08}, {0.15, 0.01, 0.01})});  // 20 mm above the post
  find_clear_cells(over);
  EXPECT_TRUE(over.pairs.empty());
  BlockRobot in = past_a_post({corners_of_box({0.25, 0.0, 0.055}, {0.15, 0.01, 0.01})});
  find_clear_cells(in);
  EXPECT_EQ(in.pairs.size(), 1U);
}

TEST(ClearCells, PiecesSettleAPairWhoseHullsTouch) {
  // Two plates with the post between them: the hull of both holds it.
  const Corners upper = corners_of_box({0.3, 0.0, 0.08}, {0.1, 0.1, 0.01}), lower = corners_of_box({0.3, 0.0, -0.08}, {0.1, 0.1, 0.01});
  for (const double sinks : {0.0, 0.03}) {
    Corners deep = lower;
    for (Eigen::Vector3d& corner : deep) corner.z() += sinks;
    Corners hull = upper;
    hull.insert(hull.end(), deep.begin(), deep.end());
    const BlockRobot robot = past_a_post({hull, upper, deep});
    const BlockScene nothing;
    BlockCheck check(robot, nothing);
    const float from = -0.05F, step = 0.1F;
    check.settle_pairs(true);
    EXPECT_FALSE(check.point_free(&from));
    check.settle_by_pieces(true);
    EXPECT_EQ(check.point_free(&from), sinks == 0.0);
    EXPECT_EQ(check.line_certain(&from, &step), sinks == 0.0);
  }
}

TEST(ClearCells, PiecesClearCellsInWhichHullsTouch) {
  const Corners upper = corners_of_box({0.3, 0.0, 0.08}, {0.1, 0.1, 0.01});
  // Below the post, and as high as it but behind: the hull of both plates holds the post wherever the upper one is above it.
  const Corners below = corners_of_box({0.3, 0.0, -0.08}, {0.1, 0.1, 0.01}), behind = corners_of_box({0.3, -0.3, 0.0}, {0.1, 0.1, 0.01});
  const auto with = [&](const Corners& second) {
    Corners hull = upper;
    hull.insert(hull.end(), second.begin(), second.end());
    return past_a_post({hull, upper, second});
  };
  BlockRobot apart = with(below);
  find_clear_cells(apart);
  EXPECT_TRUE(apart.pairs.empty());
  BlockRobot robot = with(behind), plain = robot;
  find_clear_cells(robot);
  ASSERT_EQ(robot.clear.size(), 1U);
  ASSERT_EQ(robot.clear[0].joints, 1);
  const BlockScene nothing;
  BlockCheck check(robot, nothing), without(plain, nothing), hulls(plain, nothing);
  for (BlockCheck* each : {&check, &without, &hulls}) each->settle_pairs(true);
  without.settle_by_pieces(true);
  int gained = 0, touching = 0;
  for (float q = -1.9F; q < 1.9F; q += 0.01F) {
    EXPECT_LE(check.point_free(&q), without.point_free(&q)) << q;
    EXPECT_GE(check.point_free(&q), hulls.point_free(&q)) << q;
    gained += check.point_free(&q) && !hulls.point_free(&q) ? 1 : 0;
    touching += without.point_free(&q) ? 0 : 1;
    for (const float step : {0.02F, 0.3F, -0.7F}) {
      EXPECT_LE(check.line_free(&q, &step, 4), without.line_free(&q, &step, 4)) << q << " " << step;
      if (!check.line_certain(&q, &step)) continue;
      for (int i = 0; i <= 100; ++i) {
        const float on = q + 0.01F * static_cast<float>(i) * step;
        EXPECT_TRUE(without.point_free(&on)) << q << " " << step << " " << i;
      }
    }
  }
  EXPECT_GT(gained, 20);
  EXPECT_GT(touching, 20);
}

// At the ends pieces are asked for, though cells are clear there: a line that leaves these cells begins between hulls that touch.
TEST(ClearCells, WhatTouchesAtTheEndsIsSettledByPiecesBesideCells) {
  const Corners upper = corners_of_box({0.3, 0.0, 0.08}, {0.1, 0.1, 0.01}), behind = corners_of_box({0.3, -0.3, 0.0}, {0.1, 0.1, 0.01});
  Corners hull = upper;
  hull.insert(hull.end(), behind.begin(), behind.end());
  BlockRobot robot = past_a_post({hull, upper, behind});
  find_clear_cells(robot);
  const BlockScene nothing;
  BlockCheck check(robot, nothing);
  check.settle_pairs(true);
  check.settle_by_pieces(true);
  // Up to where the plate behind is as near to the post as a cell is wide.
  const float from = 0.0F;
  float to = 0.0F;
  check.settle_touching({&from});
  for (float q = 0.0F; q < 1.0F && check.line_free(&from, &q, 8); q += 0.005F) to = q;
  BlockRobot plain = robot;
  plain.clear.clear();
  BlockCheck without(plain, nothing);
  without.settle_pairs(true);
  without.settle_by_pieces(true);
  float farthest = 0.0F;
  for (float q = 0.0F; q < 1.0F && without.line_free(&from, &q, 8); q += 0.005F) farthest = q;
  EXPECT_GT(to, 0.2F);
  EXPECT_EQ(to, farthest);
}

TEST(ClearCells, HullsSettleWhatTouchesAtTheEndsAlone) {
  const BlockRobot robot = past_a_post({corners_of_box({0.25, 0.0, 0.0}, {0.15, 0.01, 0.01})}, 0.25);
  const BlockScene nothing;
  BlockCheck check(robot, nothing);
  check.settle_pairs(true);
  const float beside = 0.5F;
  ASSERT_TRUE(check.point_free(&beside));
  check.settle_touching({});
  EXPECT_FALSE(check.point_free(&beside));
  check.settle_touching({&beside});
  EXPECT_TRUE(check.point_free(&beside));
  const float inside = 0.0F;
  EXPECT_FALSE(check.point_free(&inside));
  check.settle_all();
  EXPECT_TRUE(check.point_free(&beside));
}

TEST(ClearCells, BallsThatAlwaysTouchAreByDesign) {
  BlockRobot always = past_a_post({}), sometimes = past_a_post({});
  sometimes.balls[1] = {0.3F, 0.0F, 0.0F, 0.05F};
  sometimes.groups[1].around = sometimes.balls[1];
  sort_pairs(always);
  sort_pairs(sometimes);
  EXPECT_TRUE(always.pairs.empty());
  EXPECT_EQ(sometimes.pairs.size(), 1U);
}

}  // namespace
}  // namespace twinbus
