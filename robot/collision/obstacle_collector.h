// Puts the numbered pieces of OBSTACLES together until the scene is whole, and adds what hands hold, of HELD.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/collision/collision.h"

namespace twinbus::inline robot {

// Of HELD: how many pieces a message about that hand says there are.
constexpr std::int16_t held_pieces(int hand) noexcept { return hand < 2 ? 2 : kMostHands; }

class ObstacleCollector {
 public:
  ObstacleCollector() {
    coming_.reserve(kMostPieces * kObstaclesPerPiece);
    obstacles_.reserve((kMostPieces + kMostHands) * kObstaclesPerPiece);
  }

  // True when a scene other than the last became complete.  Allocates nothing.
  bool add(const ObstaclesPiece& piece) noexcept {
    if (piece.pieces < 1 || piece.pieces > static_cast<int>(kMostPieces) || piece.piece < 0 ||
        piece.piece >= piece.pieces || !counted(piece) || (complete_ && piece.scene_id == scene_)) {
      return false;
    }
    if (piece.scene_id != scene_ || piece.pieces != pieces_) {
      scene_ = piece.scene_id;
      pieces_ = piece.pieces;
      have_ = 0;
      complete_ = false;
      coming_.clear();
    }
    const std::uint64_t bit = std::uint64_t{1} << piece.piece;
    if ((have_ & bit) != 0) return false;
    have_ |= bit;
    for (std::size_t i = 0; i < static_cast<std::size_t>(piece.count); ++i)
      coming_.push_back(obstacle(piece, i));
    complete_ = have_ == (~std::uint64_t{0} >> (64 - pieces_));
    if (complete_) {
      obstacles_ = coming_;
      standing_ = obstacles_.size();
      add_held();
    }
    return complete_;
  }

  // Piece 0 of 2 is all that the left hand holds, piece 1 the right one, piece N of kMostHands the further arm of that number;
  // nothing, when it has no rows.  True when that is other than the last.  Allocates nothing.
  bool hold(const ObstaclesPiece& piece) noexcept {
    if (piece.piece < 0 || piece.piece >= kMostHands || piece.pieces != held_pieces(piece.piece) || !counted(piece)) return false;
    ObstaclesPiece& held = held_[static_cast<std::size_t>(piece.piece)];
    if (held.scene_id == piece.scene_id) return false;
    held = piece;
    add_held();
    return true;
  }

  // Of the last whole scene, then what hands hold.
  const std::vector<Obstacle>& obstacles() const noexcept { return obstacles_; }

 private:
  static constexpr std::size_t kMostPieces = 64;

  static bool counted(const ObstaclesPiece& piece) noexcept {
    return piece.count >= 0 && piece.count <= static_cast<int>(kObstaclesPerPiece);
  }
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

  void add_held() noexcept {
    obstacles_.resize(standing_);
    for (int hand = 0; hand < kMostHands; ++hand) {
      const ObstaclesPiece& held = held_[static_cast<std::size_t>(hand)];
      for (std::size_t i = 0; i < static_cast<std::size_t>(held.count); ++i) {
        obstacles_.push_back(obstacle(held, i));
        obstacles_.back().hand = hand;
      }
    }
  }

  std::vector<Obstacle> coming_, obstacles_;
  std::array<ObstaclesPiece, kMostHands> held_{};
  std::size_t standing_ = 0;
  std::int64_t scene_ = -1;
  std::uint64_t have_ = 0;
  int pieces_ = 0;
  bool complete_ = false;
};

}  // namespace twinbus::robot
