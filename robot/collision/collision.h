// Self-collision and distance to obstacles on the link geometry.
//
// Capsules around all shapes first (broad_phase.h), then a separating direction remembered from the last query (a lower
// bound, so what is remembered never changes an answer), then the distance of convex shapes
// (gjk.h), which is the hull's for a mesh.  Meshes whose hulls are nearer than 20 mm are measured
// triangle by triangle (mesh_distance.h).  No query allocates.  Callers pass finite configurations
// (convert has checked them).

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "robot/kinematics/joint_reach.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/messages.h"
#include "robot/collision/continuous.h"

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
  int hand = -1;  // 0 left, 1 right: that hand holds it, and pose is in the hand's frame
};

// Of positive size, finite, and in the world or in a hand that the robot has; what is not, is left out.
bool takes_part(const Obstacle& obstacle, const Model& model);
// As a shape in the world, or in the frame of the link that holds it.
Shape shape_of(const Obstacle& obstacle, const Model& model);

class Collision {
 public:
  static constexpr int kMaxObstacles = 256;

  // Loads geometry; drops adjacent pairs and the SRDF's disabled ones.  Throws if a mesh cannot be
  // read.  on_ways: shall go() and what follows it be called?  What that needs takes milliseconds with each set of obstacles.
  explicit Collision(const Model& model, bool on_ways = true);
  ~Collision();

  const std::vector<CollisionPair>& pairs() const noexcept;  // of links, that are checked
  int pair_count() const noexcept;                           // self pairs and link-obstacle pairs
  // The first kMaxObstacles that take part.  What a hand holds moves with it, is
  // looked at like one of its links, and may touch that hand and what hangs on it.  May allocate.
  void set_obstacles(const std::vector<Obstacle>& obstacles);
  // Those of what hands hold: with a link, or with what the other hand holds.
  const std::vector<CollisionPair>& held_pairs() const noexcept;
  // The link that moves an obstacle (or link) of a pair; -1: it stands still in the world.
  int carrier(int link) const noexcept;
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
    Eigen::VectorXd q;  // of the posture [joint_count]; empty: nothing is kept from one to the next
    int enough = 0;     // of the pairs not nearer than `near`, the nearest; 0: all
  };
  // Distances of the pairs nearer than `near` [m], nearest first, at most capacity; returns how
  // many, to a micrometre.  With `ahead`, a way may be looked along afterwards.
  int near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs, int capacity,
                 const Ahead* ahead = nullptr) noexcept;
  // Distance of one pair if it is nearer than `near` [m]; false when it is not.
  bool pair_nearer_than(const Kinematics& kinematics, int link_a, int link_b, double near,
                        PairDistance& result) noexcept;

  // Two shapes on a way, as far as they have been looked at.  Bits are places, or ways to the next.
  struct OnWay {
    int pair = -1, link_a = 0, link_b = 0;
    double margin = 0.0;                        // places where they are nearer are asked for [m]
    double clear = 0.0;                         // nowhere between are they to be nearer, unseen [m]
    unsigned open = 0;                          // ways to the next place that are not proved
    unsigned asked = 0, far = 0, hopeless = 0;  // places; places; ways that places cannot prove
    double best = 0.0;                          // least gap along the direction that said most [m]
    SweptShapes::AtPlaces least;                // of the distance, at least [m]
    SweptShapes::AtPlaces left_out, travel;     // as SweptShapes has them
  };
  // From now on only those shapes are looked at that may come nearer than `margin` [m] when no joint
  // moves farther than `moves` from the posture of the last near_pairs that had `ahead`, which is still
  // as it was; moves: no more than that said.  joints: 1 for those that it depends on where these
  // shapes are, as SweptShapes::Way wants it [joint_count].  legs_alone: only shapes that a leg moves
  // against each other.  False when no shapes are left.
  bool narrow(const Eigen::VectorXd& moves, double margin,
              std::vector<std::uint8_t>& joints, bool legs_alone = false) noexcept;
  // Goes to the places of a way; `on_ways` was said.  Its joints move no farther than narrow was told.
  void go(const Eigen::Isometry3d& base, const SweptShapes::Way& way) noexcept;
  // Of the shapes left, those that no direction at hand proves to stay `margin` apart at the places and
  // `clear` between [m]; at most capacity; how many there are, or that there are more.
  int open_on_way(double margin, double clear, OnWay* pairs, int capacity) noexcept;
  // Begins to look at two shapes on the way, margin and clear as they say.
  void begin(OnWay& pair) noexcept;
  // The next place where they are nearer than the margin, -1 when there is none left; then pair.open
  // says what could not be proved.  result: with depth, points and normal if depths, else pairs that
  // touch have distance zero and no more.  looks: taken off for every distance measured; none is
  // when none is left, and everything may be open.
  int nearer_on_way(OnWay& pair, bool depths, int& looks, PairDistance& result) noexcept;

  // How far joints can move the geometry.
  const JointReach& reach() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
