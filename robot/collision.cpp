#include "robot/collision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "robot/collision_body.h"
#include "robot/collision_fcl.h"
#include "robot/collision_pairs.h"
#include "robot/config_node.h"
#include "robot/convex_shape.h"
#include "robot/gjk.h"
#include "robot/mesh_distance.h"
#include "robot/near_shapes.h"

namespace twinbus {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

using Body = CollisionShape;
using Owner = CollisionOwner;

constexpr double kRounding = 1e-9;  // [m]; what a bound may be wrong by
// GJK has converged when its distance agrees with the lower bound of its own direction to this [m].
constexpr double kConverged = 1e-6;
// The distance of hulls stands for that of meshes above this [m].
constexpr double kHullsApart = 0.02;

// Of two shapes at the last look.
struct ShapeMemory {
  Vector3d apart = Vector3d::Zero();  // a separating direction, in the frame of the first
  MeshMemory nearest;
};

struct FlatShape {  // all shapes in a row
  int owner = 0;
  int shape = 0;  // of the owner
};

struct OwnerPair {
  int a = 0;
  int b = 0;
  int first_memory = 0;  // of shapes(a) x shapes(b)
};

// robot.yaml, collision: own or fcl.
bool by_fcl(const Model& model) {
  if (model.yaml_text.empty()) return false;
  return ConfigNode::parse(model.yaml_text, "robot.yaml of " + model.name)
             .choice("collision", {"own", "fcl"}, 0) == 1;
}

}  // namespace

struct Collision::Impl {
  std::vector<CollisionPair> self_pairs;
  std::vector<Owner> owners;  // links that bear geometry, then obstacles
  std::vector<int> owner_of;  // [link_count + kMaxObstacles] -> owner, -1
  std::vector<double> link_radius;
  std::vector<OwnerPair> pairs;  // self pairs, then link x obstacle
  std::vector<ShapeMemory> memory;
  std::vector<int> memory_of;  // [owners x owners]: first_memory, -1 when they are no pair
  MeshDistance meshes;
  NearShapes near_shapes;
  std::vector<FlatShape> shapes;
  std::vector<int> pair_of;  // [shapes x shapes], a < b
  std::vector<int> only_joints;
  const Model* model = nullptr;
  int link_count = 0;
  int link_owners = 0;
  int last_hit = 0;
  bool asks_fcl = false;
  bool depths = true;  // of what touches, in this query
  std::int64_t query = 0;

  explicit Impl(const Model& robot);
  void build_pairs();
  void build_shapes();
  OwnerPair make_pair(int a, int b);
  int index_of(const Owner& owner) const {  // link, or obstacle + link_count
    return owner.link >= 0 ? owner.link
                           : link_count + static_cast<int>(&owner - owners.data()) - link_owners;
  }
  Owner& owner(int i) { return owners[static_cast<std::size_t>(i)]; }

  void place(const Kinematics& kinematics) noexcept;
  const Isometry3d& placed(const Kinematics& kinematics, const Owner& owner, Body& body) noexcept;
  const OwnerPair& pair_of_shapes(const NearShapes::Candidate& c, int& index) const noexcept;
  bool nearer(const NearShapes::Candidate& candidate, double near, PairDistance& result) noexcept;
  bool shapes_nearer(Body& a, Body& b, ShapeMemory& remembered, const Vector3d& towards,
                     double near, PairDistance& result) noexcept;
  bool own_distance(const Body& a, const Body& b, const Vector3d& towards_b, double near,
                    PairDistance& result) noexcept;
  bool mesh_distance(const Body& a, const Body& b, double near, double at_least, MeshMemory& memory,
                     PairDistance& result) noexcept;
};

Collision::Impl::Impl(const Model& robot)
    : self_pairs(pairs_to_check(robot)), model(&robot), link_count(robot.link_count()) {
  owner_of.assign(static_cast<std::size_t>(link_count + kMaxObstacles), -1);
  link_radius.assign(static_cast<std::size_t>(link_count), 0.0);
  for (int link = 0; link < link_count; ++link) {
    const auto index = static_cast<std::size_t>(link);
    if (robot.links[index].collision.empty()) continue;
    Owner owner;
    owner.link = link;
    for (const Shape& shape : robot.links[index].collision) {
      owner.shapes.push_back(collision_shape(shape));
      if (owner.shapes.back().mesh) meshes.reserve(*owner.shapes.back().mesh);
    }
    enclose(owner);
    owner_of[index] = static_cast<int>(owners.size());
    link_radius[index] = owner.center.norm() + owner.radius;
    owners.push_back(std::move(owner));
  }
  link_owners = static_cast<int>(owners.size());
  asks_fcl = by_fcl(robot);
  build_pairs();
}

OwnerPair Collision::Impl::make_pair(int a, int b) {
  const auto bodies = owner(a).shapes.size() * owner(b).shapes.size();
  const OwnerPair pair{a, b, static_cast<int>(memory.size())};
  memory_of[static_cast<std::size_t>(a) * owners.size() + static_cast<std::size_t>(b)] =
      pair.first_memory;
  memory.resize(memory.size() + bodies);
  return pair;
}

void Collision::Impl::build_pairs() {
  pairs.clear();
  memory.clear();
  memory_of.assign(owners.size() * owners.size(), -1);
  last_hit = 0;
  for (const CollisionPair& pair : self_pairs) {
    pairs.push_back(make_pair(owner_of[static_cast<std::size_t>(pair.link_a)],
                              owner_of[static_cast<std::size_t>(pair.link_b)]));
  }
  for (int b = link_owners; b < static_cast<int>(owners.size()); ++b) {
    for (int a = 0; a < link_owners; ++a) pairs.push_back(make_pair(a, b));
  }
  build_shapes();
}

void Collision::Impl::build_shapes() {
  shapes.clear();
  std::vector<Capsule> capsules;
  std::vector<int> first;  // shape of every owner
  for (int o = 0; o < static_cast<int>(owners.size()); ++o) {
    first.push_back(static_cast<int>(shapes.size()));
    for (int s = 0; s < static_cast<int>(owner(o).shapes.size()); ++s) {
      shapes.push_back({o, s});
      capsules.push_back(owner(o).shapes[static_cast<std::size_t>(s)].capsule);
    }
  }
  near_shapes.set(capsules);
  pair_of.assign(shapes.size() * shapes.size(), -1);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const OwnerPair& pair = pairs[p];
    if (!only_joints.empty() &&
        std::none_of(only_joints.begin(), only_joints.end(), [&](int joint) {
          return joint_moves_pair(*model, joint, owner(pair.a).link, owner(pair.b).link);
        }))
      continue;
    for (std::size_t i = 0; i < owner(pair.a).shapes.size(); ++i) {
      for (std::size_t k = 0; k < owner(pair.b).shapes.size(); ++k) {
        const auto a = static_cast<std::size_t>(first[static_cast<std::size_t>(pair.a)]) + i;
        const auto b = static_cast<std::size_t>(first[static_cast<std::size_t>(pair.b)]) + k;
        pair_of[std::min(a, b) * shapes.size() + std::max(a, b)] = static_cast<int>(p);
        near_shapes.want(static_cast<int>(a), static_cast<int>(b), true);
      }
    }
  }
}

void Collision::Impl::place(const Kinematics& kinematics) noexcept {
  ++query;
  const Vector3d& origin = kinematics.link_in_world(0).translation();
  int shape = 0;
  for (Owner& o : owners) {
    for (Body& body : o.shapes) near_shapes.place(shape++, placed(kinematics, o, body), origin);
  }
}

const Isometry3d& Collision::Impl::placed(const Kinematics& kinematics, const Owner& owner,
                                          Body& body) noexcept {
  if (body.stamp != query) {
    body.stamp = query;
    body.world = owner.link >= 0 ? kinematics.link_in_world(owner.link) * body.local : body.local;
  }
  return body.world;
}

// Distance, points and normal of the cores, the distance zero when they overlap; false when they
// are farther apart than near.
bool Collision::Impl::own_distance(const Body& a, const Body& b, const Vector3d& towards_b,
                                   double near, PairDistance& result) noexcept {
  const double far = std::max(near, 0.0) + kRounding;
  const GjkResult found = gjk_distance(a.core, a.world, b.core, b.world, far, towards_b);
  if (found.distance > 0.0 && found.below > near + kRounding) return false;
  result.distance = found.distance;
  result.point_a = found.point_a;
  result.point_b = found.point_b;
  result.normal = found.normal;
  return true;
}

// Distance and points where at least one is a mesh; false when they are farther apart than near.
bool Collision::Impl::mesh_distance(const Body& a, const Body& b, double near, double at_least,
                                    MeshMemory& nearest, PairDistance& result) noexcept {
  MeshGap gap;
  const double below = near + kRounding;
  if (a.mesh && b.mesh) {
    if (!meshes.between(*a.mesh, a.world, *b.mesh, b.world, below, at_least, nearest, gap))
      return false;
  } else if (a.mesh) {
    if (!meshes.between(*a.mesh, a.world, b.core, b.world, below, nearest, gap)) return false;
  } else {
    if (!meshes.between(*b.mesh, b.world, a.core, a.world, below, nearest, gap)) return false;
    std::swap(gap.point_a, gap.point_b);
  }
  result.distance = gap.distance;
  result.point_a = gap.point_a;
  result.point_b = gap.point_b;
  return true;
}

// result.distance, when lower than before, is the signed distance; true when it was improved.
// towards: where b may be seen from a.
bool Collision::Impl::shapes_nearer(Body& a, Body& b, ShapeMemory& remembered,
                                    const Vector3d& towards, double near,
                                    PairDistance& result) noexcept {
  const PlacedShape shape_a{&a.convex, &a.world};
  const PlacedShape shape_b{&b.convex, &b.world};
  const Vector3d between = b.world.translation() - a.world.translation();
  const double reach = a.radius + b.radius + near;
  if (!(reach > 0.0) || between.squaredNorm() > reach * reach) return false;
  const Vector3d before = a.world.linear() * remembered.apart;
  const double as_before = separation(shape_a, shape_b, before);
  if (as_before > near + kRounding) return false;
  const Vector3d seen = towards.squaredNorm() > 1e-8 ? towards.normalized() : between.normalized();
  const double as_seen = separation(shape_a, shape_b, seen);
  if (as_seen > near + kRounding) return false;
  const Vector3d first = a.world.linear().transpose() *
                         (as_before > as_seen && !remembered.apart.isZero(0.0) ? before : seen);

  PairDistance found;
  found.distance = near + 1.0;
  FclGap gap;
  const bool answered = asks_fcl && fcl_gap(*a.fcl, a.world, *b.fcl, b.world, gap);
  const bool mesh = !answered && (a.mesh || b.mesh);
  if (answered) {
    if (gap.distance > near) return false;
    found.distance = gap.distance;
    found.point_a = gap.point_a;
    found.point_b = gap.point_b;
    if (gap.distance > 0.0) found.normal = (gap.point_b - gap.point_a).normalized();
  } else if (!own_distance(a, b, first, near, found)) {
    return false;
  }
  if (found.distance > kConverged) remembered.apart = a.world.linear().transpose() * found.normal;
  const bool exact = mesh && !(found.distance > kHullsApart);
  if (exact && !mesh_distance(a, b, near, std::max(found.distance - kConverged, 0.0),
                              remembered.nearest, found))
    return false;
  if (!(found.distance > kConverged) && (depths || found.distance > 0.0)) {
    // Touching: the shortest way out.
    found.normal = way_out(shape_a, shape_b);
    const double out = separation(shape_a, shape_b, found.normal);
    found.distance = std::min(found.distance, out);
    found.point_a = a.world * a.convex.support(a.world.linear().transpose() * found.normal);
    found.point_b = b.world * b.convex.support(-(b.world.linear().transpose() * found.normal));
  } else if (exact && found.distance > 0.0) {
    found.normal = (found.point_b - found.point_a).normalized();
  }
  if (!(found.distance <= near) || found.distance >= result.distance) return false;
  found.link_a = result.link_a;
  found.link_b = result.link_b;
  result = found;
  return true;
}

const OwnerPair& Collision::Impl::pair_of_shapes(const NearShapes::Candidate& c,
                                                 int& index) const noexcept {
  index = pair_of[static_cast<std::size_t>(c.a) * shapes.size() + static_cast<std::size_t>(c.b)];
  return pairs[static_cast<std::size_t>(index)];
}

// Of two placed shapes; as shapes_nearer.
bool Collision::Impl::nearer(const NearShapes::Candidate& candidate, double near,
                             PairDistance& result) noexcept {
  int index = 0;
  const OwnerPair& pair = pair_of_shapes(candidate, index);
  const FlatShape& one = shapes[static_cast<std::size_t>(candidate.a)];
  const FlatShape& other = shapes[static_cast<std::size_t>(candidate.b)];
  const FlatShape& of_a = one.owner == pair.a ? one : other;
  const FlatShape& of_b = one.owner == pair.a ? other : one;
  Owner& a = owner(pair.a);
  Owner& b = owner(pair.b);
  result.link_a = index_of(a);
  result.link_b = index_of(b);
  const std::size_t shape_b = static_cast<std::size_t>(of_b.shape);
  const std::size_t shape_a = static_cast<std::size_t>(of_a.shape);
  const std::size_t known =
      static_cast<std::size_t>(pair.first_memory) + shape_a * b.shapes.size() + shape_b;
  Vector3d towards(static_cast<double>(candidate.towards[0]),
                   static_cast<double>(candidate.towards[1]),
                   static_cast<double>(candidate.towards[2]));
  if (one.owner != pair.a) towards = -towards;
  return shapes_nearer(a.shapes[shape_a], b.shapes[shape_b], memory[known], towards, near, result);
}

Collision::Collision(const Model& model) : impl_(std::make_unique<Impl>(model)) {}
Collision::~Collision() = default;

const std::vector<CollisionPair>& Collision::pairs() const noexcept { return impl_->self_pairs; }

int Collision::pair_count() const noexcept { return static_cast<int>(impl_->pairs.size()); }

double Collision::link_radius(int link) const noexcept {
  return impl_->link_radius[static_cast<std::size_t>(link)];
}

void Collision::set_obstacles(const std::vector<Obstacle>& obstacles) {
  Impl& i = *impl_;
  i.owners.resize(static_cast<std::size_t>(i.link_owners));
  std::fill(i.owner_of.begin() + i.link_count, i.owner_of.end(), -1);
  int kept = 0;
  for (const Obstacle& obstacle : obstacles) {
    if (kept == kMaxObstacles) break;
    const int needed = obstacle.shape == ObstacleShape::kBox
                           ? 3
                           : (obstacle.shape == ObstacleShape::kCylinder ? 2 : 1);
    if (obstacle.shape == ObstacleShape::kNone || !(obstacle.size.head(needed).minCoeff() > 0.0) ||
        !obstacle.size.allFinite() || !obstacle.pose.matrix().allFinite()) {
      continue;
    }
    const ShapeKind kind = obstacle.shape == ObstacleShape::kBox      ? ShapeKind::kBox
                           : obstacle.shape == ObstacleShape::kSphere ? ShapeKind::kSphere
                                                                      : ShapeKind::kCylinder;
    Owner owner;
    Shape shape;
    shape.kind = kind;
    shape.size = obstacle.size;
    shape.pose = obstacle.pose;
    owner.shapes.push_back(collision_shape(shape));
    enclose(owner);
    i.owner_of[static_cast<std::size_t>(i.link_count + kept++)] = static_cast<int>(i.owners.size());
    i.owners.push_back(std::move(owner));
  }
  i.build_pairs();
}

void Collision::check_only_moved_by(const std::vector<int>& joints) {
  impl_->only_joints = joints;
  impl_->build_shapes();
}

bool Collision::in_collision(const Kinematics& kinematics, CollisionPair* hit) noexcept {
  return nearer_than(kinematics, 0.0, hit);
}

bool Collision::nearer_than(const Kinematics& kinematics, double clearance,
                            CollisionPair* hit) noexcept {
  Impl& i = *impl_;
  i.place(kinematics);
  i.depths = clearance < 0.0;
  const auto candidates = i.near_shapes.nearer_than(clearance);
  PairDistance found;
  // What was hit last is likely hit again; asked who was hit, the answer must not depend on the
  // past.
  for (const bool last : {true, false}) {
    if (last && hit != nullptr) continue;
    for (const NearShapes::Candidate& candidate : candidates) {
      int index = 0;
      i.pair_of_shapes(candidate, index);
      if (last && index != i.last_hit) continue;
      found.distance = clearance + 1.0;
      if (!i.nearer(candidate, clearance, found)) continue;
      i.last_hit = index;
      if (hit != nullptr) *hit = {found.link_a, found.link_b};
      return true;
    }
  }
  return false;
}

int Collision::near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs,
                          int capacity, bool depths) noexcept {
  Impl& i = *impl_;
  i.depths = depths;
  i.place(kinematics);
  const auto candidates = i.near_shapes.nearer_than(near);
  int kept = 0;
  for (const NearShapes::Candidate& candidate : candidates) {
    int index = 0;
    const OwnerPair& links = i.pair_of_shapes(candidate, index);
    const int link_a = i.index_of(i.owner(links.a)), link_b = i.index_of(i.owner(links.b));
    // Of two links only what is nearer than the nearest so far matters.
    int place = 0;
    while (place < kept && (pairs[place].link_a != link_a || pairs[place].link_b != link_b))
      ++place;
    const double reach = place < kept ? std::min(near, pairs[place].distance) : near;
    PairDistance found;
    found.distance = near + 1.0;
    if (static_cast<double>(candidate.bound) > reach || !i.nearer(candidate, reach, found))
      continue;
    if (place == kept) {
      if (kept == capacity && !(kept > 0 && found.distance < pairs[kept - 1].distance)) continue;
      place = kept < capacity ? kept++ : capacity - 1;
    }
    for (; place > 0 && found.distance < pairs[place - 1].distance; --place)
      pairs[place] = pairs[place - 1];
    pairs[place] = found;
  }
  return kept;
}

bool Collision::pair_nearer_than(const Kinematics& kinematics, int link_a, int link_b, double near,
                                 PairDistance& result) noexcept {
  Impl& i = *impl_;
  const int a = i.owner_of[static_cast<std::size_t>(link_a)];
  const int b = i.owner_of[static_cast<std::size_t>(link_b)];
  if (a < 0 || b < 0) return false;
  ++i.query;
  i.depths = true;
  result = PairDistance{};
  result.link_a = link_a;
  result.link_b = link_b;
  result.distance = near + 1.0;
  bool found = false;
  int index =
      i.memory_of[static_cast<std::size_t>(a) * i.owners.size() + static_cast<std::size_t>(b)];
  for (Body& body_a : i.owner(a).shapes) {
    i.placed(kinematics, i.owner(a), body_a);
    for (Body& body_b : i.owner(b).shapes) {
      i.placed(kinematics, i.owner(b), body_b);
      ShapeMemory nothing;
      ShapeMemory& known = index < 0 ? nothing : i.memory[static_cast<std::size_t>(index++)];
      const double reach = std::min(near, result.distance);
      found = i.shapes_nearer(body_a, body_b, known, Vector3d::Zero(), reach, result) || found;
    }
  }
  return found;
}

bool Collision::touches_by_fcl(const Kinematics& kinematics, const CollisionPair& pair) {
  Impl& i = *impl_;
  ++i.query;
  Owner& a = i.owner(i.owner_of[static_cast<std::size_t>(pair.link_a)]);
  Owner& b = i.owner(i.owner_of[static_cast<std::size_t>(pair.link_b)]);
  for (Body& body_a : a.shapes) {
    for (Body& body_b : b.shapes) {
      if (fcl_touches(*body_a.fcl, i.placed(kinematics, a, body_a), *body_b.fcl,
                      i.placed(kinematics, b, body_b)))
        return true;
    }
  }
  return false;
}

}  // namespace twinbus
