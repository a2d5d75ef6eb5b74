// Self-collision and distance to obstacles on the link geometry, through FCL.
//
// FCL asserts on NaN: callers pass finite configurations (convert has checked them).

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "robot/kinematics.h"
#include "robot/model.h"

namespace twinbus {

struct CollisionPair {
  int link_a = 0;
  int link_b = 0;   // or obstacle index + link_count
};

struct PairDistance {
  int link_a = 0;
  int link_b = 0;
  double distance = 0.0;  // [m]; 0 or below when touching
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();  // world
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
};

struct Obstacle {
  ObstacleShape shape = ObstacleShape::kNone;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // as in obstacles_t
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

class Collision {
 public:
  // Loads geometry; drops adjacent pairs and the SRDF's disabled ones.  Throws if a mesh cannot be read.
  explicit Collision(const Model& model);
  ~Collision();

  const std::vector<CollisionPair>& pairs() const noexcept;  // self pairs that are checked
  void set_obstacles(const std::vector<Obstacle>& obstacles);  // world; may allocate

  // Is anything touching?  Stops at the first hit and says which.
  bool in_collision(const Kinematics& kinematics, CollisionPair* hit = nullptr) noexcept;
  // Distances of the pairs nearer than `near` [m], nearest first, at most capacity; returns how many.
  int near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs, int capacity) noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
