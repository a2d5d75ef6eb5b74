// Shapes that come in numbered pieces, each replaced by the newest of its number.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline viewer_log {

class ShapeSet {
 public:
  // What makes a piece a new picture: anything, or only what the shapes are, because where they are is drawn live.
  enum class Matters { kAll, kShapes };
  explicit ShapeSet(Matters matters) : matters_(matters) {}

  void add(const ObstaclesPiece& piece) {
    if (piece.pieces < 1 || piece.pieces > kMostPieces || piece.piece < 0 ||
        piece.piece >= piece.pieces || piece.count < 0 || piece.count > kObstaclesPerPiece) {
      return;
    }
    if (pieces_.size() != static_cast<std::size_t>(piece.pieces) ||
        pieces_.front().scene_id != piece.scene_id) {
      pieces_.assign(static_cast<std::size_t>(piece.pieces), ObstaclesPiece{});
      for (ObstaclesPiece& empty : pieces_) empty.scene_id = piece.scene_id;
      ++version_;
    }
    ObstaclesPiece& slot = pieces_[static_cast<std::size_t>(piece.piece)];
    const bool same_shapes =
        slot.count == piece.count && slot.shape == piece.shape && slot.size == piece.size;
    const bool same_places = slot.position == piece.position && slot.attitude == piece.attitude;
    if (!same_shapes || (!same_places && matters_ == Matters::kAll)) ++version_;
    slot = piece;
  }

  const std::vector<ObstaclesPiece>& pieces() const { return pieces_; }
  std::int64_t version() const { return version_; }  // counts up with every new picture
  std::int64_t scene_id() const { return pieces_.empty() ? 0 : pieces_.front().scene_id; }

 private:
  static constexpr int kMostPieces = 64;

  Matters matters_;
  std::vector<ObstaclesPiece> pieces_;
  std::int64_t version_ = 0;
};

}  // namespace twinbus::viewer_log
