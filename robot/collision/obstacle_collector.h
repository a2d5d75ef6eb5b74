// Puts the numbered pieces of OBSTACLES together until the scene is whole.

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/collision/collision.h"

namespace twinbus {

class ObstacleCollector {
 public:
  ObstacleCollector() { obstacles_.reserve(kMostPieces * kObstaclesPerPiece); }

  // True when a scene other than the last became complete.  Allocates nothing.
  bool add(const ObstaclesPiece& piece) noexcept {
    if (piece.pieces < 1 || piece.pieces > static_cast<int>(kMostPieces) || piece.piece < 0 ||
        piece.piece >= piece.pieces || (complete_ && piece.scene_id == scene_)) {
      return false;
    }
    if (piece.scene_id != scene_ || piece.pieces != pieces_) {
      scene_ = piece.scene_id;
      pieces_ = piece.pieces;
      have_ = 0;
      complete_ = false;
      obstacles_.clear();
    }
    const std::uint64_t bit = std::uint64_t{1} << piece.piece;
    if ((have_ & bit) != 0) return false;
    have_ |= bit;
    for (std::size_t i = 0; i < static_cast<std::size_t>(piece.count); ++i)
      obstacles_.push_back(obstacle(piece, i));
    complete_ = have_ == (~std::uint64_t{0} >> (64 - pieces_));
    return complete_;
  }

  const std::vector<Obstacle>& obstacles() const noexcept { return obstacles_; }

 private:
  static constexpr std::size_t kMostPieces = 64;

  static Obstacle obstacle(const ObstaclesPiece& piece, std::size_t i) noexcept {
    Obstacle o;
    o.shape = piece.shape[i];
    o.size = Eigen::Vector3f(piece.size[i].data()).cast<double>();
    const auto& a = piece.attitude[i];
    o.pose.linear() =
        Eigen::Quaternionf(a[0], a[1], a[2], a[3]).normalized().toRotationMatrix().cast<double>();
    o.pose.translation() = Eigen::Vector3f(piece.position[i].data()).cast<double>();
    return o;
  }

  std::vector<Obstacle> obstacles_;
  std::int64_t scene_ = -1;
  std::uint64_t have_ = 0;
  int pieces_ = 0;
  bool complete_ = false;
};

}  // namespace twinbus
