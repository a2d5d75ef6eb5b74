// Where a row of an ObstaclesPiece is: pose to message.

#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

inline void place_row(const Eigen::Isometry3d& pose, std::size_t row,
                      ObstaclesPiece& piece) noexcept {
  const Eigen::Quaterniond q(pose.linear());
  for (int k = 0; k < 3; ++k)
    piece.position[row][static_cast<std::size_t>(k)] = static_cast<float>(pose.translation()[k]);
  piece.attitude[row] = {static_cast<float>(q.w()), static_cast<float>(q.x()),
                         static_cast<float>(q.y()), static_cast<float>(q.z())};
}

}  // namespace twinbus::lcmtypes
