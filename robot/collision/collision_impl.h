// What Collision is made of: shapes of links and obstacles, the pairs of them, and what may come near
// on the way from a posture.  Shared by collision.cpp (at a posture) and continuous_query.cpp (on a way).

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robot/collision/collision.h"
#include "robot/collision/collision_body.h"
#include "geometry/distance/convex_shape.h"
#include "robot/kinematics/joint_reach.h"
#include "geometry/distance/broad_phase.h"
#include "robot/collision/shape_gap.h"
#include "robot/collision/continuous.h"

namespace twinbus::inline robot {

struct FlatShape {  // all shapes in a row
  int owner = 0;
  int shape = 0;  // of the owner
};

struct ShapePair {  // of a candidate, as its pair of links names them
  CollisionOwner *a = nullptr, *b = nullptr;
  CollisionShape *body_a = nullptr, *body_b = nullptr;
  ShapeMemory* memory = nullptr;
  Eigen::Vector3d towards;  // where b may be seen from a
};

struct OwnerPair {
  int a = 0;
  int b = 0;
  int first_memory = 0;  // of shapes(a) x shapes(b)
};

struct Collision::Impl {
  std::vector<CollisionPair> self_pairs;
  std::vector<CollisionOwner> owners;  // links that bear geometry, what hands hold, other obstacles
  std::vector<int> owner_of;           // [link_count + kMaxObstacles] -> owner, -1
  std::vector<CollisionPair> held_pairs;
  std::vector<OwnerPair> pairs;        // self pairs, held pairs, then what moves x obstacle
  std::vector<ShapeMemory> memory;
  std::vector<int> memory_of;  // [owners x owners]: first_memory, -1 when they are no pair
  ShapeGap gap;
  NearShapes near_shapes;
  std::vector<FlatShape> shapes;
  std::vector<int> pair_of;                // [shapes x shapes], a < b
  std::vector<std::uint8_t> by_legs;       // of pairs: a leg moves the two against each other
  std::span<NearShapes::Candidate> ahead;  // that can come near from a posture
  const Kinematics* ahead_from = nullptr;  // that posture
  struct Apart {                           // a direction that parts a candidate there
    Eigen::Vector3d n;                     // world
    double gap = 0.0;                      // along it [m]
    bool known = false;
  };
  std::vector<Apart> apart;              // of the candidates
  std::vector<std::uint8_t> not_parted;  // ways to wait since [shapes x shapes], a < b
  Eigen::VectorXd walked_to, step;       // from one posture to the next
  bool walks = false;
  int directions_left = 0;
  std::vector<NearShapes::Candidate> left;           // that narrow leaves
  int many_left = 0;                                 // ways for which it asks for no direction
  std::span<const NearShapes::Candidate> looked_at;  // what it left last
  std::vector<int> open_pairs;                       // room
  std::vector<NearShapes::Candidate*> by_bound;      // room
  std::size_t link_shapes = 0;                       // shapes that links move: before the others
  std::vector<int> link_of_shape;                    // [link_shapes]
  std::vector<double> travel_to, travel_of;          // of links, of shapes, seen from link 0 [m]
  std::vector<int> only_joints;
  std::optional<JointReach> reach;
  std::optional<SweptShapes> swept;
  const Model* model = nullptr;
  const Kinematics* kinematics = nullptr;  // of this query
  int link_count = 0;
  bool on_ways = true;  // paths may be looked along
  std::int64_t path = 0;  // number of the one that was gone along last
  int link_owners = 0, moved_owners = 0;  // links; with what they hold
  std::vector<double> link_radius;        // of a link's own shapes about its origin [m]
  int last_hit = 0;
  std::int64_t query = 0;

  Impl(const Model& robot, bool goes_on_ways);
  void measure_reach();
  void build_pairs();
  void build_shapes();
  OwnerPair make_pair(int a, int b);
  CollisionOwner& owner(int i) { return owners[static_cast<std::size_t>(i)]; }

  void look_at(const Kinematics& posture) noexcept;
  void place() noexcept;
  const Eigen::Isometry3d& placed(const CollisionOwner& owner, CollisionShape& body) noexcept;
  const OwnerPair& pair_of_shapes(const NearShapes::Candidate& c, int& index) const noexcept;
  ShapePair shape_pair(const NearShapes::Candidate& candidate) noexcept;
  void let_joints_move(const Eigen::VectorXd& moves) noexcept;
  int link_of(int shape) const noexcept {  // -1: obstacle
    return owners[static_cast<std::size_t>(shapes[static_cast<std::size_t>(shape)].owner)].link;
  }
  void let_shapes_move(const Ahead& ahead) noexcept;
  void walk_on(const Ahead& ahead) noexcept;
  const Apart& apart_at(std::size_t candidate) noexcept;
  bool stays_parted(std::size_t candidate, const Eigen::VectorXd& moves, double margin) noexcept;
  int nearest(std::span<NearShapes::Candidate> candidates, double near, int enough, double all,
              PairDistance* pairs, int capacity) noexcept;
  void know(NearShapes::Candidate& candidate, double at_least) noexcept;
  static void note(PathPair& pair, const SweptShapes::AtPlaces& gaps) noexcept;
  static void note_hopeless(PathPair& pair, const SweptShapes::AtPlaces& most) noexcept;
  bool nearer(const NearShapes::Candidate& candidate, double near, PairDistance& result) noexcept;
};

}  // namespace twinbus::robot
