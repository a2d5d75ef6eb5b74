#include "sim/world/world_origin.h"

namespace twinbus::inline sim {

void move_everything(const Eigen::Vector3d& by, WorldConfig& config) {
  for (Obstacle& obstacle : config.obstacles) obstacle.pose.translation() += by;
  for (Obstacle& tile : config.tiles) tile.pose.translation() += by;
  for (LooseBody& body : config.loose) body.start.pose.translation() += by;
  for (OtherRobot& robot : config.robots) robot.start.base.translation() += by;
  for (Tie& tie : config.ties) {
    for (TieEnd* end : {&tie.a, &tie.b}) {
      if (end->link < 0 && end->loose < 0) end->point += by;
    }
  }
}

}  // namespace twinbus::sim
