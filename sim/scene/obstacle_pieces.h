// The obstacles of a scene as the numbered pieces that go out on OBSTACLES.

#pragma once

#include <vector>

#include "robot/collision/collision.h"
#include "lcmtypes/msg/obstacle_row.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline sim {

// At least one piece, so that "no obstacles" is said too.
inline std::vector<ObstaclesPiece> obstacle_pieces(const std::vector<Obstacle>& obstacles,
                                                   std::int64_t scene_id) {
  constexpr auto kRows = static_cast<std::size_t>(kObstaclesPerPiece);
  std::vector<ObstaclesPiece> pieces(obstacles.empty() ? 1
                                                       : (obstacles.size() + kRows - 1) / kRows);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    pieces[i].scene_id = scene_id;
    pieces[i].piece = static_cast<std::int16_t>(i);
    pieces[i].pieces = static_cast<std::int16_t>(pieces.size());
    pieces[i].attitude.fill({1.0F, 0.0F, 0.0F, 0.0F});
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    ObstaclesPiece& piece = pieces[i / kRows];
    const std::size_t row = i % kRows;
    const Obstacle& obstacle = obstacles[i];
    piece.shape[row] = obstacle.shape;
    for (int k = 0; k < 3; ++k)
      piece.size[row][static_cast<std::size_t>(k)] = static_cast<float>(obstacle.size[k]);
    place_row(obstacle.pose, row, piece);
    piece.count = static_cast<std::int16_t>(row + 1);
  }
  return pieces;
}

}  // namespace twinbus::sim
