// Links, obstacles and what hands hold by FCL alone: what our own collision checks are compared with.  Allocates.

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "robot/collision/collision.h"

namespace twinbus {

// Distance [m] and nearest points, in world; zero and no points when they touch.
struct FclGap {
  double distance = 0.0;
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero(), point_b = Eigen::Vector3d::Zero();
};

class FclOracle {
 public:
  explicit FclOracle(const Model& model);
  ~FclOracle();

  // Numbered as Collision numbers them.
  void set_obstacles(const std::vector<Obstacle>& obstacles);
  // By libccd.
  bool touches(const Kinematics& kinematics, const CollisionPair& pair) const;
  FclGap gap(const Kinematics& kinematics, const CollisionPair& pair) const;

 private:
  struct Body;   // a link or an obstacle
  template <class Take>
  void each(const Kinematics& kinematics, const CollisionPair& pair, const Take& take) const;

  Model model_;
  std::vector<Body> bodies_;  // links, then obstacles
};

}  // namespace twinbus
