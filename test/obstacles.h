// Obstacles for tests.

#pragma once

#include "robot/collision/collision.h"

namespace twinbus::test {

// size: edges [m]; upright, its middle at centre [m].
inline Obstacle box_at(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  Obstacle box{.shape = ObstacleShape::kBox, .size = size, .pose = Eigen::Isometry3d::Identity()};
  box.pose.translation() = centre;
  return box;
}

}  // namespace twinbus::test
