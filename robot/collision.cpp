#include "robot/collision.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "robot/collision_body.h"
#include "robot/collision_fcl.h"
#include "robot/collision_pairs.h"
#include "robot/convex_shape.h"
#include "robot/gjk.h"
#include "robot/mesh_distance.h"

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

struct OwnerPair {
  int a = 0;
  int b = 0;
  int first_memory = 0;  // of shapes(a) x shapes(b)
  bool checked = true;
};

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
  std::vector<int> candidates;  // scratch of one query
  std::vector<int> only_joints;
  const Model* model = nullptr;
  int link_count = 0;
  int link_owners = 0;
  int last_hit = 0;
  std::int64_t query = 0;

  explicit Impl(const Model& robot);
  void build_pairs();
  OwnerPair make_pair(int a, int b);
  int index_of(const Owner& owner) const {  // link, or obstacle + link_count
    return owner.link >= 0 ? owner.link
                           : link_count + static_cast<int>(&owner - owners.data()) - link_owners;
  }
  Owner& owner(int i) { return owners[static_cast<std::size_t>(i)]; }

  void place(const Kinematics& kinematics) noexcept;
  const Isometry3d& placed(const Kinematics& kinematics, const Owner& owner, Body& body) noexcept;
  bool spheres_nearer_than(const OwnerPair& pair, double near) noexcept;
  bool nearer(const Kinematics& kinematics, const OwnerPair& pair, double near,
              PairDistance& result) noexcept;
  bool shapes_nearer(Body& a, Body& b, ShapeMemory& remembered, double near,
                     PairDistance& result) noexcept;
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
  build_pairs();
}

OwnerPair Collision::Impl::make_pair(int a, int b) {
  const auto bodies = owner(a).shapes.size() * owner(b).shapes.size();
  const OwnerPair pair{a, b, static_cast<int>(memory.size()), true};
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
  for (OwnerPair& pair : pairs) {
    if (only_joints.empty()) break;
    pair.checked = std::any_of(only_joints.begin(), only_joints.end(), [&](int joint) {
      return joint_moves_pair(*model, joint, owner(pair.a).link, owner(pair.b).link);
    });
  }
  candidates.assign(pairs.size(), 0);
}

void Collision::Impl::place(const Kinematics& kinematics) noexcept {
  ++query;
  for (int i = 0; i < static_cast<int>(owners.size()); ++i) {
    Owner& o = owner(i);
    o.center_in_world = o.link >= 0 ? kinematics.link_in_world(o.link) * o.center : o.center;
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

bool Collision::Impl::spheres_nearer_than(const OwnerPair& pair, double near) noexcept {
  const Owner& a = owner(pair.a);
  const Owner& b = owner(pair.b);
  const double reach = a.radius + b.radius + near;
  return (a.center_in_world - b.center_in_world).squaredNorm() <= reach * reach;
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
bool Collision::Impl::shapes_nearer(Body& a, Body& b, ShapeMemory& remembered, double near,
                                    PairDistance& result) noexcept {
  const PlacedShape shape_a{&a.convex, &a.world};
  const PlacedShape shape_b{&b.convex, &b.world};
  const Vector3d between = b.world.translation() - a.world.translation();
  const double reach = a.radius + b.radius + near;
  if (!(reach > 0.0) || between.squaredNorm() > reach * reach) return false;
  if (separation(shape_a, shape_b, a.world.linear() * remembered.apart) > near + kRounding)
    return false;
  if (separation(shape_a, shape_b, between.normalized()) > near + kRounding) return false;

  PairDistance found;
  found.distance = near + 1.0;
  const bool mesh = a.mesh || b.mesh;
  if (!own_distance(a, b, remembered.apart, near, found)) return false;
  if (found.distance > kConverged) remembered.apart = a.world.linear().transpose() * found.normal;
  const bool exact = mesh && !(found.distance > kHullsApart);
  if (exact && !mesh_distance(a, b, near, std::max(found.distance - kConverged, 0.0),
                              remembered.nearest, found))
    return false;
  if (!(found.distance > kConverged)) {  // touching: the shortest way out
    found.normal = way_out(shape_a, shape_b);
    const double out = separation(shape_a, shape_b, found.normal);
    found.distance = std::min(found.distance, out);
    found.point_a = a.world * a.convex.support(a.world.linear().transpose() * found.normal);
    found.point_b = b.world * b.convex.support(-(b.world.linear().transpose() * found.normal));
  } else if (exact) {
    found.normal = (found.point_b - found.point_a).normalized();
  }
  if (!(found.distance <= near) || found.distance >= result.distance) return false;
  found.link_a = result.link_a;
  found.link_b = result.link_b;
  result = found;
  return true;
}

bool Collision::Impl::nearer(const Kinematics& kinematics, const OwnerPair& pair, double near,
                             PairDistance& result) noexcept {
  Owner& a = owner(pair.a);
  Owner& b = owner(pair.b);
  result.link_a = index_of(a);
  result.link_b = index_of(b);
  result.distance = near + 1.0;
  auto memory_index = static_cast<std::size_t>(pair.first_memory);
  bool found = false;
  for (Body& body_a : a.shapes) {
    placed(kinematics, a, body_a);
    for (Body& body_b : b.shapes) {
      placed(kinematics, b, body_b);
      // Only what is nearer than the nearest so far matters.
      const double reach = std::min(near, result.distance);
      found = shapes_nearer(body_a, body_b, memory[memory_index++], reach, result) || found;
    }
  }
  return found;
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
  impl_->build_pairs();
}

bool Collision::in_collision(const Kinematics& kinematics, CollisionPair* hit) noexcept {
  return nearer_than(kinematics, 0.0, hit);
}

bool Collision::nearer_than(const Kinematics& kinematics, double clearance,
                            CollisionPair* hit) noexcept {
  Impl& i = *impl_;
  i.place(kinematics);
  PairDistance found;
  const int count = static_cast<int>(i.pairs.size());
  // What was hit last is likely hit again; asked who was hit, the answer must not depend on the
  // past.
  for (int k = hit == nullptr ? -1 : 0; k < count; ++k) {
    const int index = k < 0 ? i.last_hit : k;
    if (index >= count) continue;
    const OwnerPair& pair = i.pairs[static_cast<std::size_t>(index)];
    if (!pair.checked || !i.spheres_nearer_than(pair, clearance)) continue;
    if (!i.nearer(kinematics, pair, clearance, found)) continue;
    i.last_hit = index;
    if (hit != nullptr) *hit = {found.link_a, found.link_b};
    return true;
  }
  return false;
}

int Collision::near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs,
                          int capacity, const double* travel) noexcept {
  Impl& i = *impl_;
  i.place(kinematics);
  const auto travel_of = [&](int index) {
    const int link = i.owner(index).link;
    return travel != nullptr && link >= 0 ? travel[link] : 0.0;
  };
  int kept = 0;
  for (const OwnerPair& pair : i.pairs) {
    if (!pair.checked) continue;
    const double reach = near + travel_of(pair.a) + travel_of(pair.b);
    PairDistance found;
    if (!i.spheres_nearer_than(pair, reach) || !i.nearer(kinematics, pair, reach, found)) continue;
    if (kept == capacity && !(kept > 0 && found.distance < pairs[kept - 1].distance)) continue;
    int place = kept < capacity ? kept++ : capacity - 1;
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
      found = i.shapes_nearer(body_a, body_b, known, reach, result) || found;
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
