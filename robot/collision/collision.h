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

namespace twinbus::inline robot {

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
  // read.  on_ways: shall paths be looked along?  What that needs takes milliseconds with each set of obstacles.
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
  // many, to a micrometre.
  int near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs, int capacity) noexcept;
  // The same, count of them, and what may follow; the posture stays as it is while that is asked.
  class PathsAhead;
  PathsAhead near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs, int capacity,
                        const Ahead& ahead, int& count) noexcept;
  // Distance of one pair if it is nearer than `near` [m]; false when it is not.
  bool pair_nearer_than(const Kinematics& kinematics, int link_a, int link_b, double near,
                        PairDistance& result) noexcept;

  // Two shapes on a path, as far as they have been looked at.  Bits are places, or ways to the next.
  struct PathPair {
    int pair = -1, link_a = 0, link_b = 0;
    double margin = 0.0;                        // places where they are nearer are asked for [m]
    double clear = 0.0;                         // nowhere between are they to be nearer, unseen [m]
    unsigned open = 0;                          // ways to the next place that are not proved
    unsigned asked = 0, far = 0, hopeless = 0;  // places; places; ways that places cannot prove
    double best = 0.0;                          // least gap along the direction that said most [m]
    SweptShapes::AtPlaces least;                // of the distance, at least [m]
    SweptShapes::AtPlaces left_out, travel;     // as SweptShapes has them
  };
  class PathPlaces;
  class PathSearch;

  // How far joints can move the geometry.
  const JointReach& reach() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// One path at its places, from PathSearch::along; the next one ends it.
class Collision::PathPlaces {
 public:
  // Of the shapes left, those that no direction at hand proves to stay `margin` apart at the places and
  // `clear` between [m]; at most capacity; how many there are, or that there are more.
  int open_pairs(double margin, double clear, PathPair* pairs, int capacity) const noexcept;
  // Begins to look at two shapes on the path.
  void begin(PathPair& pair, double margin, double clear) const noexcept;
  // The next place where they are nearer than the margin, -1 when there is none left; then pair.open
  // says what could not be proved.  result: with depth, points and normal if depths, else pairs that
  // touch have distance zero and no more.  looks: taken off for every distance measured; none is
  // when none is left, and everything may be open.
  int next_nearer(PathPair& pair, bool depths, int& looks, PairDistance& result) const noexcept;

 private:
  friend PathSearch;
  PathPlaces(Impl* impl, std::int64_t path) : impl_(impl), path_(path) {}
  Impl& impl() const noexcept;  // asserts that no other path was gone along since
  Impl* impl_;
  std::int64_t path_;
};

// The shapes that may come near one another, from PathsAhead::search; the next one ends it.
class Collision::PathSearch {
 public:
  explicit operator bool() const noexcept { return left_; }  // false: there are none
  // The places of a path whose joints move no farther than was said.
  PathPlaces along(const Eigen::Isometry3d& base, const SweptShapes::Way& way) const noexcept;

 private:
  friend PathsAhead;
  PathSearch(Impl* impl, bool left) : impl_(impl), left_(left) {}
  Impl* impl_;
  bool left_;
};

// Paths that may follow the posture of a near_pairs.  `on_ways` was said.
class Collision::PathsAhead {
 public:
  // Only those shapes that may come nearer than `margin` [m] when no joint moves farther than `moves`
  // from the posture, no more than its Ahead said.  joints: 1 for those that it depends on where these
  // shapes are, as SweptShapes::Way wants it [joint_count].  legs_alone: only shapes that a leg moves
  // against each other.
  PathSearch search(const Eigen::VectorXd& moves, double margin, std::vector<std::uint8_t>& joints,
                    bool legs_alone = false) const noexcept;

 private:
  friend class Collision;
  explicit PathsAhead(Impl* impl) : impl_(impl) {}
  Impl* impl_;
};

}  // namespace twinbus::robot
