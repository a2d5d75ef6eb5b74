#include "robot/collision.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <variant>

#include "robot/coarse_mesh.h"
#include "robot/collision_pairs.h"
#include "robot/convex_hull.h"
#include "robot/convex_shape.h"
#include "robot/gjk.h"
#include "robot/mesh_file.h"

namespace twinbus {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

using MeshModel = fcl::BVHModel<fcl::OBBRSSd>;
using Primitive = std::variant<std::monostate, fcl::Boxd, fcl::Sphered, fcl::Cylinderd>;

constexpr double kRounding = 1e-9;  // [m]; what a bound may be wrong by
// GJK has converged when its distance agrees with the lower bound of its own direction to this [m].
constexpr double kConverged = 1e-6;
// The distance of hulls stands for that of meshes above this [m].
constexpr double kHullsApart = 0.02;

struct Body {  // one shape, of a link or an obstacle
  ConvexShape convex;
  GjkShape core;  // the same, or the hull of a mesh
  Isometry3d local =
      Isometry3d::Identity();  // of the convex shape, in the link frame (obstacle: world)
  Isometry3d world = Isometry3d::Identity();
  std::int64_t stamp = -1;  // query that world belongs to
  Primitive primitive;
  std::shared_ptr<MeshModel> mesh;     // in the frame of the convex shape
  std::shared_ptr<fcl::Convexd> hull;  // instead of a mesh of many triangles
};

struct Owner {    // a link or an obstacle: its shapes and the sphere around them
  int link = -1;  // -1: obstacle
  std::vector<Body> bodies;
  Vector3d center = Vector3d::Zero();  // in the link frame (obstacle: world)
  double radius = 0.0;
  Vector3d center_in_world = Vector3d::Zero();
};

struct OwnerPair {
  int a = 0;
  int b = 0;
  int first_memory = 0;  // of bodies(a) x bodies(b) remembered directions
  bool checked = true;
};

Body make_primitive(ShapeKind kind, const Vector3d& size, const Isometry3d& pose) {
  Body body;
  body.convex.kind = kind;
  body.local = pose;
  switch (kind) {
    case ShapeKind::kBox:
      body.convex.half = 0.5 * size;
      body.primitive = fcl::Boxd(size.x(), size.y(), size.z());
      break;
    case ShapeKind::kSphere:
      body.convex.half = Vector3d(size.x(), 0.0, 0.0);
      body.primitive = fcl::Sphered(size.x());
      break;
    case ShapeKind::kCylinder:
      body.convex.half = Vector3d(size.x(), 0.5 * size.y(), 0.0);
      body.primitive = fcl::Cylinderd(size.x(), size.y());
      break;
    case ShapeKind::kMesh:
      break;
  }
  body.core.kind = kind;
  body.core.half = body.convex.half;
  return body;
}

std::shared_ptr<fcl::Convexd> make_convex(const TriangleMesh& hull) {
  auto corners = std::make_shared<std::vector<Vector3d>>(hull.points);
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& t : hull.triangles) faces->insert(faces->end(), {3, t[0], t[1], t[2]});
  return std::make_shared<fcl::Convexd>(corners, static_cast<int>(hull.triangles.size()), faces);
}

// Meshes of many triangles become their hulls.
Body make_mesh(const Shape& shape) {
  TriangleMesh mesh = load_mesh(shape.mesh, shape.size);
  const std::optional<TriangleMesh> hull = coarse_hull(mesh);
  if (hull) mesh = *hull;
  Vector3d low = mesh.points.front();
  Vector3d high = low;
  for (const Vector3d& point : mesh.points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vector3d middle = 0.5 * (low + high);
  Body body;
  body.convex = {ShapeKind::kMesh, 0.5 * (high - low)};
  body.local = shape.pose * Eigen::Translation3d(middle);
  for (Vector3d& point : mesh.points) point -= middle;
  if (hull) {
    body.hull = make_convex(mesh);
    body.core = gjk_hull(mesh.points);
    return body;
  }
  body.mesh = std::make_shared<MeshModel>();
  body.mesh->beginModel(static_cast<int>(mesh.triangles.size()),
                        static_cast<int>(3 * mesh.triangles.size()));
  const auto corner = [&](int k) { return mesh.points[static_cast<std::size_t>(k)]; };
  for (const auto& t : mesh.triangles)
    body.mesh->addTriangle(corner(t[0]), corner(t[1]), corner(t[2]));
  body.mesh->endModel();
  body.mesh->computeLocalAABB();
  body.core = gjk_hull(convex_hull(mesh.points).points);
  return body;
}

Body make_body(const Shape& shape) {
  return shape.kind == ShapeKind::kMesh ? make_mesh(shape)
                                        : make_primitive(shape.kind, shape.size, shape.pose);
}

void enclose(Owner& owner) {
  Vector3d low = Vector3d::Constant(1e300);
  Vector3d high = -low;
  for (const Body& body : owner.bodies) {
    for (int k = 0; k < 3; ++k) {
      const double reach = body.convex.extent(body.local.linear().row(k).transpose());
      low[k] = std::min(low[k], body.local.translation()[k] - reach);
      high[k] = std::max(high[k], body.local.translation()[k] + reach);
    }
  }
  owner.center = 0.5 * (low + high);
  for (const Body& body : owner.bodies) {
    owner.radius = std::max(
        owner.radius, (body.local.translation() - owner.center).norm() + body.convex.radius());
  }
}

const fcl::CollisionGeometryd& geometry(const Body& body) {
  if (body.mesh) return *body.mesh;
  if (body.hull) return *body.hull;
  if (const auto* box = std::get_if<fcl::Boxd>(&body.primitive)) return *box;
  if (const auto* sphere = std::get_if<fcl::Sphered>(&body.primitive)) return *sphere;
  return std::get<fcl::Cylinderd>(body.primitive);
}

}  // namespace

struct Collision::Impl {
  std::vector<CollisionPair> self_pairs;
  std::vector<Owner> owners;  // links that bear geometry, then obstacles
  std::vector<int> owner_of;  // [link_count + kMaxObstacles] -> owner, -1
  std::vector<double> link_radius;
  std::vector<OwnerPair> pairs;  // self pairs, then link x obstacle
  std::vector<Vector3d> memory;  // separating directions, in the frame of the first body
  std::vector<int> candidates;   // scratch of one query
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
  bool bodies_nearer(Body& a, Body& b, Vector3d& remembered, double near,
                     PairDistance& result) noexcept;
  bool own_distance(const Body& a, const Body& b, double near, PairDistance& result) noexcept;
  void mesh_distance(Body& a, Body& b, double near, PairDistance& result);
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
    for (const Shape& shape : robot.links[index].collision)
      owner.bodies.push_back(make_body(shape));
    enclose(owner);
    owner_of[index] = static_cast<int>(owners.size());
    link_radius[index] = owner.center.norm() + owner.radius;
    owners.push_back(std::move(owner));
  }
  link_owners = static_cast<int>(owners.size());
  build_pairs();
}

OwnerPair Collision::Impl::make_pair(int a, int b) {
  const auto bodies = owner(a).bodies.size() * owner(b).bodies.size();
  const OwnerPair pair{a, b, static_cast<int>(memory.size()), true};
  memory.resize(memory.size() + bodies, Vector3d::Zero());
  return pair;
}

void Collision::Impl::build_pairs() {
  pairs.clear();
  memory.clear();
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
bool Collision::Impl::own_distance(const Body& a, const Body& b, double near,
                                   PairDistance& result) noexcept {
  const double far = std::max(near, 0.0) + kRounding;
  const GjkResult found = gjk_distance(a.core, a.world, b.core, b.world, far);
  if (found.distance > 0.0 && found.below > near + kRounding) return false;
  result.distance = found.distance;
  result.point_a = found.point_a;
  result.point_b = found.point_b;
  result.normal = found.normal;
  return true;
}

void Collision::Impl::mesh_distance(Body& a, Body& b, double near, PairDistance& result) {
  fcl::CollisionRequestd touch_request;
  touch_request.gjk_solver_type = fcl::GST_INDEP;
  fcl::CollisionResultd touch;
  if (fcl::collide(&geometry(a), a.world, &geometry(b), b.world, touch_request, touch) > 0) {
    result.distance = 0.0;
    return;
  }
  fcl::DistanceRequestd request(true);
  request.gjk_solver_type = fcl::GST_INDEP;
  fcl::DistanceResultd found;
  found.min_distance = near + kRounding;
  fcl::distance(&geometry(a), a.world, &geometry(b), b.world, request, found);
  if (!(found.min_distance <= near)) return;
  result.distance = found.min_distance;
  result.point_a = found.nearest_points[0];
  result.point_b = found.nearest_points[1];
}

// result.distance, when lower than before, is the signed distance; true when it was improved.
bool Collision::Impl::bodies_nearer(Body& a, Body& b, Vector3d& remembered, double near,
                                    PairDistance& result) noexcept {
  const PlacedShape shape_a{&a.convex, &a.world};
  const PlacedShape shape_b{&b.convex, &b.world};
  const Vector3d between = b.world.translation() - a.world.translation();
  const double reach = a.convex.radius() + b.convex.radius() + near;
  if (!(reach > 0.0) || between.squaredNorm() > reach * reach) return false;
  if (separation(shape_a, shape_b, a.world.linear() * remembered) > near + kRounding) return false;
  if (separation(shape_a, shape_b, between.normalized()) > near + kRounding) return false;

  PairDistance found;
  found.distance = near + 1.0;
  const bool mesh = a.mesh || b.mesh;
  if (!own_distance(a, b, near, found)) return false;
  if (found.distance > kConverged) remembered = a.world.linear().transpose() * found.normal;
  const bool exact = mesh && !(found.distance > kHullsApart);
  if (exact) {
    found.distance = near + 1.0;
    mesh_distance(a, b, near, found);
    if (!(found.distance <= near)) return false;
  }
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
  for (Body& body_a : a.bodies) {
    placed(kinematics, a, body_a);
    for (Body& body_b : b.bodies) {
      placed(kinematics, b, body_b);
      // Only what is nearer than the nearest so far matters.
      const double reach = std::min(near, result.distance);
      found = bodies_nearer(body_a, body_b, memory[memory_index++], reach, result) || found;
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
    owner.bodies.push_back(make_primitive(kind, obstacle.size, obstacle.pose));
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
  for (Body& body_a : i.owner(a).bodies) {
    i.placed(kinematics, i.owner(a), body_a);
    for (Body& body_b : i.owner(b).bodies) {
      i.placed(kinematics, i.owner(b), body_b);
      Vector3d nothing = Vector3d::Zero();
      const double reach = std::min(near, result.distance);
      found = i.bodies_nearer(body_a, body_b, nothing, reach, result) || found;
    }
  }
  return found;
}

bool Collision::touches_by_fcl(const Kinematics& kinematics, const CollisionPair& pair) {
  Impl& i = *impl_;
  ++i.query;
  Owner& a = i.owner(i.owner_of[static_cast<std::size_t>(pair.link_a)]);
  Owner& b = i.owner(i.owner_of[static_cast<std::size_t>(pair.link_b)]);
  for (Body& body_a : a.bodies) {
    for (Body& body_b : b.bodies) {
      fcl::CollisionRequestd request;
      request.gjk_solver_type = fcl::GST_LIBCCD;
      fcl::CollisionResultd result;  // collide() appends: a fresh one each time
      if (fcl::collide(&geometry(body_a), i.placed(kinematics, a, body_a), &geometry(body_b),
                       i.placed(kinematics, b, body_b), request, result) > 0) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace twinbus
