#include "viewer_log/view/arm_path_view.h"

#include "lcmtypes/msg/labels.h"

namespace twinbus::inline viewer_log {

namespace {
constexpr int kMostPieces = 64;
}

void ArmPathView::on_piece(const ArmPathPiece& piece) {
  if (piece.path_id == shown_id_ && piece.goal_id == shown_goal_) return;  // said again
  if (piece.pieces == 0) {
    status_ = piece.status;
    shown_id_ = piece.path_id;
    shown_goal_ = piece.goal_id;
    joints_.clear();
    knots_.clear();
    ++version_;
    return;
  }
  if (piece.pieces < 0 || piece.pieces > kMostPieces || piece.piece < 0 ||
      piece.piece >= piece.pieces || piece.joint_count < 1 || piece.joint_count > kArmJoints ||
      piece.knot_count < 1 || piece.knot_count > kKnotsPerPiece) {
    return;
  }
  const auto count = static_cast<std::size_t>(piece.pieces);
  if (piece.path_id != collecting_ || pieces_.size() != count) {
    collecting_ = piece.path_id;
    pieces_.assign(count, ArmPathPiece{});
    have_ = 0;
  }
  pieces_[static_cast<std::size_t>(piece.piece)] = piece;
  have_ |= std::uint64_t{1} << piece.piece;
  const std::uint64_t all = ~std::uint64_t{0} >> (64 - piece.pieces);
  if (have_ == all) finish();
}

void ArmPathView::finish() {
  const ArmPathPiece& first = pieces_.front();
  joints_.assign(first.joint.begin(), first.joint.begin() + first.joint_count);
  knots_.clear();
  for (const ArmPathPiece& piece : pieces_) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(piece.knot_count); ++i) {
      knots_.push_back({piece.time[i], piece.q[i]});
    }
  }
  status_ = first.status;
  shown_id_ = collecting_;
  shown_goal_ = first.goal_id;
  collecting_ = 0;
  pieces_.clear();
  ++version_;
}

const char* ArmPathView::status_text() const { return label(status_); }

}  // namespace twinbus::viewer_log
