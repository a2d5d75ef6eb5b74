#include "viewer_log/view/arm_path_view.h"

#include <gtest/gtest.h>

#include <string>

namespace twinbus {
namespace {

ArmPathPiece piece_of(int number, int of, std::int64_t path = 5) {
  ArmPathPiece piece;
  piece.path_id = path;
  piece.goal_id = path;
  piece.piece = static_cast<std::int16_t>(number);
  piece.pieces = static_cast<std::int16_t>(of);
  piece.joint_count = 2;
  piece.knot_count = 3;
  for (std::size_t i = 0; i < 3; ++i) piece.time[i] = 3.0 * number + static_cast<double>(i);
  return piece;
}

TEST(ArmPathView, IsShownOnceEveryPieceIsThereInAnyOrder) {
  ArmPathView view;
  view.on_piece(piece_of(1, 2));
  view.on_piece(piece_of(1, 2));
  EXPECT_EQ(view.version(), 0);
  view.on_piece(piece_of(0, 2));
  EXPECT_EQ(view.version(), 1);
  ASSERT_EQ(view.knots().size(), 6u);
  EXPECT_DOUBLE_EQ(view.duration(), 5.0);
  EXPECT_EQ(view.joints().size(), 2u);
  view.on_piece(piece_of(0, 2));  // said again
  view.on_piece(piece_of(1, 2));
  EXPECT_EQ(view.version(), 1);
}

TEST(ArmPathView, SixtyFourPiecesAreAPath) {
  ArmPathView view;
  for (int i = 0; i < 64; ++i) view.on_piece(piece_of(i, 64));
  EXPECT_EQ(view.knots().size(), 192u);
}

TEST(ArmPathView, ARefusalSaysWhy) {
  ArmPathView view;
  ArmPathPiece none = piece_of(0, 0, 6);
  none.status = ArmPathStatus::kUnreachable;
  view.on_piece(none);
  EXPECT_EQ(view.version(), 1);
  EXPECT_TRUE(view.knots().empty());
  EXPECT_EQ(std::string(view.status_text()), "the hand cannot get there");
}

TEST(ArmPathView, NonsenseIsIgnored) {
  ArmPathView view;
  for (auto [number, of] : {std::pair{2, 2}, {-1, 2}, {0, 65}, {0, -1}}) {
    view.on_piece(piece_of(number, of));
  }
  ArmPathPiece wide = piece_of(0, 1);
  wide.joint_count = kArmJoints + 1;
  view.on_piece(wide);
  ArmPathPiece tall = piece_of(0, 1);
  tall.knot_count = kKnotsPerPiece + 1;
  view.on_piece(tall);
  EXPECT_EQ(view.version(), 0);
}

}  // namespace
}  // namespace twinbus
