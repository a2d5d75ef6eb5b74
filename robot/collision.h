// Self-collision and distance to obstacles on the link geometry.
//
// Capsules around all shapes first (near_shapes.h), then a separating direction remembered from the last query (a lower
// bound, so what is remembered never changes an answer), then the distance of convex shapes
// (gjk.h), which is the hull's for a mesh.  Meshes whose hulls are nearer than 20 mm are measured
// triangle by triangle (mesh_distance.h).  A robot.yaml with collision: fcl has its distances from
// FCL instead, behind the same bounds; that is slow, and it allocates.  Otherwise no query
// allocates, except touches_by_fcl.  FCL asserts on
// NaN: callers pass finite configurations (convert has checked them).

#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "robot/joint_reach.h"
#include "robot/kinematics.h"
#include "robot/model.h"
#include "robot/requests.h"

namespace twinbus {

struct CollisionPair {
  int link_a = 0;
  int link_b = 0;  // or obstacle index + link_count
};

struct PairDistance {
  int link_a = 0;
  int link_b = 0;
  double distance = 0.0;                              // [m]; below zero: penetration depth
  Eigen::Vector3d point_a = Eigen::Vector3d::Zero();  // world
  Eigen::Vector3d point_b = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal =
      Eigen::Vector3d::UnitZ();  // world, unit: moving b along it takes the pair apart
};

struct Obstacle {
  ObstacleShape shape = ObstacleShape::kNone;
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // as in obstacles_t
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

class Collision {
 public:
  static constexpr int kMaxObstacles = 256;

  // Loads geometry; drops adjacent pairs and the SRDF's disabled ones.  Throws if a mesh cannot be
  // read.
  explicit Collision(const Model& model);
  ~Collision();

  const std::vector<CollisionPair>& pairs() const noexcept;  // self pairs that are checked
  int pair_count() const noexcept;                           // self pairs and link-obstacle pairs
  // World; the first kMaxObstacles that are shapes of positive size.  May allocate.
  void set_obstacles(const std::vector<Obstacle>& obstacles);
  // From now on only pairs whose distance some of these joints can change; an empty list means all
  // pairs again.
  void check_only_moved_by(const std::vector<int>& joints);

  // Is anything touching?  Stops at the first hit and says which.
  bool in_collision(const Kinematics& kinematics, CollisionPair* hit = nullptr) noexcept;
  // Is anything at `clearance` [m] or nearer?
  bool nearer_than(const Kinematics& kinematics, double clearance,
                   CollisionPair* hit = nullptr) noexcept;
  // What may come after a posture: no joint moves farther than `moves` from it [joint_count, rad or
  // m], and what comes nearer than `near` [m] is to be found.
  struct Ahead {
    Eigen::VectorXd moves;
    double near = 0.0;
  };
  // Distances of the pairs nearer than `near` [m], nearest first, at most capacity; returns how
  // many.  With `ahead`, also remembers which pairs near_pairs_ahead has to look at.
  int near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs, int capacity,
                 const Ahead* ahead = nullptr) noexcept;
  // As near_pairs for ahead.near, at a posture that joints reach by the moves of the last call that
  // had them.  Pairs that touch have distance zero and neither points nor normal: finding the way
  // out costs more than all the rest.
  int near_pairs_ahead(const Kinematics& kinematics, PairDistance* pairs, int capacity) noexcept;
  // Can any pair come that near at all?  If not, near_pairs_ahead finds nothing.
  bool any_ahead() const noexcept;
  // Distance of one pair if it is nearer than `near` [m]; false when it is not.
  bool pair_nearer_than(const Kinematics& kinematics, int link_a, int link_b, double near,
                        PairDistance& result) noexcept;

  // The pair by fcl::collide with its other solver (libccd), no filter: what tests compare with.
  // Allocates.
  bool touches_by_fcl(const Kinematics& kinematics, const CollisionPair& pair);

  // How far joints can move the geometry.
  const JointReach& reach() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
