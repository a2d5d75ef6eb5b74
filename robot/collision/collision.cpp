#include "robot/collision/collision.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "robot/description/model.h"
#include "robot/collision/collision_pairs.h"
#include "robot/collision/collision_impl.h"
#include "common/math/index.h"

namespace twinbus::inline robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

using Body = CollisionShape;
using Owner = CollisionOwner;

constexpr double kMicrometre = 1e-6;  // [m]
constexpr float kCoarse = 1e-6F;      // what a bound in single precision may lose [m]

}  // namespace

Collision::Impl::Impl(const Model& robot, bool goes_on_ways)
    : self_pairs(pairs_to_check(robot)), model(&robot), link_count(robot.link_count()), on_ways(goes_on_ways) {
  owner_of.assign(static_cast<std::size_t>(link_count + kMaxObstacles), -1);
  link_radius.assign(static_cast<std::size_t>(link_count), 0.0);
  for (int link = 0; link < link_count; ++link) {
    const auto index = static_cast<std::size_t>(link);
    if (robot.links[index].collision.empty()) continue;
    Owner owner;
    owner.link = owner.index = link;
    for (const Shape& shape : robot.links[index].collision) {
      owner.shapes.push_back(collision_shape(shape));
      if (owner.shapes.back().mesh) gap.meshes.reserve(*owner.shapes.back().mesh);
    }
    enclose(owner);
    owner_of[index] = static_cast<int>(owners.size());
    link_radius[index] = owner.center.norm() + owner.radius;
    owners.push_back(std::move(owner));
  }
  link_owners = moved_owners = static_cast<int>(owners.size());
  measure_reach();
  travel_to.assign(robot.links.size(), 0.0);
  walked_to = step = Eigen::VectorXd::Zero(robot.joint_count());
  build_pairs();
}

// Of links with what they hold.
void Collision::Impl::measure_reach() {
  std::vector<double> radius = link_radius;
  for (int o = link_owners; o < moved_owners; ++o) {
    const Owner& held = owner(o);
    radius[at(held.link)] = std::max(radius[at(held.link)], held.center.norm() + held.radius);
  }
  swept.reset();
  reach.emplace(*model, radius);
  swept.emplace(*model, *reach);
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
  held_pairs.clear();
  for (int b = link_owners; b < moved_owners; ++b) {
    for (int a = 0; a < b; ++a) {
      if (!hangs_on(*model, owner(a).link, owner(b).link))
        held_pairs.push_back({owner(a).index, owner(b).index});
    }
  }
  for (const auto* listed : {&self_pairs, &held_pairs}) {
    for (const CollisionPair& pair : *listed)
      pairs.push_back(make_pair(owner_of[at(pair.link_a)], owner_of[at(pair.link_b)]));
  }
  for (int b = moved_owners; b < static_cast<int>(owners.size()); ++b) {
    for (int a = 0; a < moved_owners; ++a) {  // nothing moves a fixed base on what stands
      if (!model->floating_base && owner(a).link == 0) continue;
      if (owner(b).ground && a < link_owners && stays_above_ground(*model, owner(a).link)) continue;
      pairs.push_back(make_pair(a, b));
    }
  }
  build_shapes();
}

void Collision::Impl::build_shapes() {
  shapes.clear();
  std::vector<Capsule> capsules;
  std::vector<SweptShapes::Part> parts;
  std::vector<int> first;  // shape of every owner
  link_of_shape.clear();
  std::size_t wanted = 0;
  for (int o = 0; o < static_cast<int>(owners.size()); ++o) {
    first.push_back(static_cast<int>(shapes.size()));
    for (int s = 0; s < static_cast<int>(owner(o).shapes.size()); ++s) {
      shapes.push_back({o, s});
      if (owner(o).link >= 0) link_of_shape.push_back(owner(o).link);
      const Body& body = owner(o).shapes[static_cast<std::size_t>(s)];
      Capsule capsule = body.capsule;  // of the link
      capsule.a = body.local * capsule.a;
      capsule.b = body.local * capsule.b;
      capsules.push_back(capsule);
      parts.push_back({owner(o).link, &body.convex,
                       body.convex.kind == ShapeKind::kMesh ? &body.core : nullptr, body.inside, body.local});
    }
  }
  link_shapes = link_of_shape.size();
  near_shapes.set(capsules);
  if (on_ways) swept->set(parts);
  open_pairs.assign(shapes.size() * shapes.size() / 2, 0);
  ahead = {};
  looked_at = {};
  many_left = 0;
  pair_of.assign(shapes.size() * shapes.size(), -1);
  by_legs.clear();
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const OwnerPair& pair = pairs[p];
    const auto moves = [&](int joint) { return joint_moves_pair(*model, joint, owner(pair.a).link, owner(pair.b).link); };
    by_legs.push_back(std::any_of(model->leg_joints.begin(), model->leg_joints.end(), moves) ? 1 : 0);
    if (!only_joints.empty() && std::none_of(only_joints.begin(), only_joints.end(), moves)) continue;
    for (std::size_t i = 0; i < owner(pair.a).shapes.size(); ++i) {
      for (std::size_t k = 0; k < owner(pair.b).shapes.size(); ++k) {
        const auto a = static_cast<std::size_t>(first[static_cast<std::size_t>(pair.a)]) + i;
        const auto b = static_cast<std::size_t>(first[static_cast<std::size_t>(pair.b)]) + k;
        pair_of[std::min(a, b) * shapes.size() + std::max(a, b)] = static_cast<int>(p);
        near_shapes.want(static_cast<int>(a), static_cast<int>(b), true);
        if (on_ways) swept->want(static_cast<int>(std::min(a, b)), static_cast<int>(std::max(a, b)));
        ++wanted;
      }
    }
  }
  travel_of.assign(shapes.size(), 0.0);
  not_parted.assign(shapes.size() * shapes.size(), 0);
  walks = false;
  apart.assign(wanted, {});
  left.assign(wanted, {});
  by_bound.assign(wanted, nullptr);
}

// Bodies are placed when something asks for them.
void Collision::Impl::look_at(const Kinematics& posture) noexcept {
  ++query;
  kinematics = &posture;
  gap.close = kGjkClose;
}

void Collision::Impl::place() noexcept {
  const Vector3d& origin = kinematics->link_in_world(0).translation();
  for (std::size_t s = 0; s < link_shapes; ++s)
    near_shapes.place(static_cast<int>(s), kinematics->link_in_world(link_of_shape[s]), origin);
  for (std::size_t s = link_shapes; s < shapes.size(); ++s)
    near_shapes.place(static_cast<int>(s), Isometry3d::Identity(), origin);
}

const Isometry3d& Collision::Impl::placed(const Owner& owner, Body& body) noexcept {
  if (body.stamp != query) {
    body.stamp = query;
    body.world = owner.link >= 0 ? kinematics->link_in_world(owner.link) * body.local : body.local;
  }
  return body.world;
}

const OwnerPair& Collision::Impl::pair_of_shapes(const NearShapes::Candidate& c,
                                                 int& index) const noexcept {
  index = pair_of[static_cast<std::size_t>(c.a) * shapes.size() + static_cast<std::size_t>(c.b)];
  return pairs[static_cast<std::size_t>(index)];
}

ShapePair Collision::Impl::shape_pair(const NearShapes::Candidate& candidate) noexcept {
  int index = 0;
  const OwnerPair& links = pair_of_shapes(candidate, index);
  const FlatShape& one = shapes[at(candidate.a)];
  const FlatShape& other = shapes[at(candidate.b)];
  const bool same_way = one.owner == links.a;
  const auto shape_a = at(same_way ? one.shape : other.shape);
  const auto shape_b = at(same_way ? other.shape : one.shape);
  ShapePair pair;
  pair.a = &owner(links.a);
  pair.b = &owner(links.b);
  for (int d = 0; d < 3; ++d) pair.towards[d] = static_cast<double>(candidate.towards[d]);
  if (!same_way) pair.towards = -pair.towards;
  pair.body_a = &pair.a->shapes[shape_a];
  pair.body_b = &pair.b->shapes[shape_b];
  pair.memory = &memory[at(links.first_memory) + shape_a * pair.b->shapes.size() + shape_b];
  return pair;
}

// As ShapeGap::nearer.
bool Collision::Impl::nearer(const NearShapes::Candidate& candidate, double near,
                             PairDistance& result) noexcept {
  const ShapePair pair = shape_pair(candidate);
  result.link_a = pair.a->index;
  result.link_b = pair.b->index;
  placed(*pair.a, *pair.body_a);
  placed(*pair.b, *pair.body_b);
  return gap.nearer(*pair.body_a, *pair.body_b, *pair.memory, pair.towards, near, result);
}

Collision::Collision(const Model& model, bool on_ways) : impl_(std::make_unique<Impl>(model, on_ways)) {}
Collision::~Collision() = default;

const std::vector<CollisionPair>& Collision::pairs() const noexcept { return impl_->self_pairs; }

int Collision::pair_count() const noexcept { return static_cast<int>(impl_->pairs.size()); }

const std::vector<CollisionPair>& Collision::held_pairs() const noexcept { return impl_->held_pairs; }

int Collision::carrier(int link) const noexcept {
  if (link < impl_->link_count) return link;
  const int owner = impl_->owner_of[at(link)];
  return owner < 0 ? -1 : impl_->owner(owner).link;
}

const JointReach& Collision::reach() const noexcept { return *impl_->reach; }

bool takes_part(const Obstacle& obstacle, const Model& model) {
  const int sizes = obstacle.shape == ObstacleShape::kBox        ? 3
                    : obstacle.shape == ObstacleShape::kCylinder ? 2
                                                                 : 1;
  return obstacle.shape != ObstacleShape::kNone && obstacle.size.head(sizes).minCoeff() > 0.0 &&
         obstacle.size.allFinite() && obstacle.pose.matrix().allFinite() &&
         (obstacle.hand < 0 || hand_of(model, obstacle.hand) != nullptr);
}

Shape shape_of(const Obstacle& obstacle, const Model& model) {
  Shape shape;
  shape.kind = obstacle.shape == ObstacleShape::kBox      ? ShapeKind::kBox
               : obstacle.shape == ObstacleShape::kSphere ? ShapeKind::kSphere
                                                          : ShapeKind::kCylinder;
  shape.size = obstacle.size;
  const Hand* hand = obstacle.hand < 0 ? nullptr : hand_of(model, obstacle.hand);
  shape.pose = hand != nullptr ? hand->frame * obstacle.pose : obstacle.pose;
  return shape;
}

void Collision::set_obstacles(const std::vector<Obstacle>& obstacles) {
  Impl& i = *impl_;
  const bool held_before = i.moved_owners > i.link_owners;
  i.owners.resize(static_cast<std::size_t>(i.link_owners));
  std::fill(i.owner_of.begin() + i.link_count, i.owner_of.end(), -1);
  int kept = 0;
  std::vector<Owner> still;
  for (const Obstacle& obstacle : obstacles) {
    if (kept == kMaxObstacles) break;
    if (!takes_part(obstacle, *i.model)) continue;
    const Hand* hand = obstacle.hand < 0 ? nullptr : hand_of(*i.model, obstacle.hand);
    Owner owner;
    owner.link = hand != nullptr ? hand->link : -1;
    owner.index = i.link_count + kept++;
    owner.ground = is_ground(obstacle);
    owner.shapes.push_back(collision_shape(shape_of(obstacle, *i.model)));
    enclose(owner);
    (hand != nullptr ? i.owners : still).push_back(std::move(owner));
  }
  i.moved_owners = static_cast<int>(i.owners.size());
  std::move(still.begin(), still.end(), std::back_inserter(i.owners));
  for (int o = i.link_owners; o < static_cast<int>(i.owners.size()); ++o)
    i.owner_of[at(i.owner(o).index)] = o;
  if (held_before || i.moved_owners > i.link_owners) i.measure_reach();
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
  i.look_at(kinematics);
  i.place();
  i.gap.depths = clearance < 0.0;
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

// A bound of a candidate is found.
void Collision::Impl::know(NearShapes::Candidate& candidate, double at_least) noexcept {
  candidate.bound = std::max(candidate.bound, static_cast<float>(at_least) - kCoarse);
  near_shapes.know(candidate.a, candidate.b, at_least);
}

// Of these candidates the pairs that are nearer than `near`, nearest first; how many.  Once there are
// `enough`, only what is nearer than them or than `all`: so those that may be nearest are looked at first.
// Of what may touch the order is kept, as bounds say nothing about depths.
int Collision::Impl::nearest(std::span<NearShapes::Candidate> candidates, double near, int enough,
                             double all, PairDistance* found_pairs, int capacity) noexcept {
  const auto sooner = [](const NearShapes::Candidate* x, const NearShapes::Candidate* y) {
    const float here = std::max(x->bound, 0.0F), there = std::max(y->bound, 0.0F);
    return here < there || (!(here > there) && x < y);
  };
  const auto first = by_bound.begin();
  auto end = first;
  for (NearShapes::Candidate& candidate : candidates) {
    if (static_cast<double>(candidate.bound) <= near) *end++ = &candidate;
  }
  if (enough < capacity) std::sort(first, end, sooner);
  int kept = 0;
  for (auto next = first; next != end; ++next) {
    NearShapes::Candidate& candidate = **next;
    const double wanted =
        kept < enough ? near : std::clamp(found_pairs[enough - 1].distance, all, near);
    if (static_cast<double>(candidate.bound) > wanted) continue;
    int index = 0;
    const OwnerPair& links = pair_of_shapes(candidate, index);
    const int link_a = owner(links.a).index, link_b = owner(links.b).index;
    // Of two links only what is nearer than the nearest so far matters.
    int place = 0;
    while (place < kept &&
           (found_pairs[place].link_a != link_a || found_pairs[place].link_b != link_b))
      ++place;
    const double reach_of = place < kept ? std::min(wanted, found_pairs[place].distance) : wanted;
    PairDistance found;
    found.distance = near + 1.0;
    if (static_cast<double>(candidate.bound) > std::max(reach_of, std::min(near, 0.0))) continue;
    const bool nearer_yet = nearer(candidate, reach_of, found);
    know(candidate, gap.parted);
    if (!nearer_yet) continue;
    if (place == kept) {
      if (kept == capacity && !(kept > 0 && found.distance < found_pairs[kept - 1].distance))
        continue;
      place = kept < capacity ? kept++ : capacity - 1;
    }
    for (; place > 0 && found.distance < found_pairs[place - 1].distance; --place)
      found_pairs[place] = found_pairs[place - 1];
    found_pairs[place] = found;
  }
  return kept;
}

int Collision::near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs,
                          int capacity) noexcept {
  Impl& i = *impl_;
  i.gap.depths = true;
  i.look_at(kinematics);
  i.place();
  return i.nearest(i.near_shapes.nearer_than(near), near, capacity, std::min(near, 0.0), pairs, capacity);
}

Collision::PathsAhead Collision::near_pairs(const Kinematics& kinematics, double near, PairDistance* pairs,
                                            int capacity, const Ahead& ahead, int& count) noexcept {
  Impl& i = *impl_;
  i.gap.depths = true;
  i.look_at(kinematics);
  i.place();
  i.gap.close = kMicrometre;
  i.walk_on(ahead);
  i.let_shapes_move(ahead);
  i.ahead = i.near_shapes.nearer_than(near, ahead.near, i.walks);
  i.ahead_from = &kinematics;
  for (std::size_t c = 0; c < i.ahead.size(); ++c) i.apart[c].known = false;
  const int enough = ahead.enough > 0 ? std::min(ahead.enough, capacity) : capacity;
  count = i.nearest(i.ahead, near, enough, ahead.near, pairs, capacity);
  return PathsAhead(&i);
}

bool Collision::pair_nearer_than(const Kinematics& kinematics, int link_a, int link_b, double near,
                                 PairDistance& result) noexcept {
  Impl& i = *impl_;
  const int a = i.owner_of[static_cast<std::size_t>(link_a)];
  const int b = i.owner_of[static_cast<std::size_t>(link_b)];
  if (a < 0 || b < 0) return false;
  i.look_at(kinematics);
  i.gap.depths = true;
  result = PairDistance{};
  result.link_a = link_a;
  result.link_b = link_b;
  result.distance = near + 1.0;
  bool found = false;
  int index =
      i.memory_of[static_cast<std::size_t>(a) * i.owners.size() + static_cast<std::size_t>(b)];
  for (Body& body_a : i.owner(a).shapes) {
    i.placed(i.owner(a), body_a);
    for (Body& body_b : i.owner(b).shapes) {
      i.placed(i.owner(b), body_b);
      ShapeMemory nothing;
      ShapeMemory& known = index < 0 ? nothing : i.memory[static_cast<std::size_t>(index++)];
      const double reach = std::min(near, result.distance);
      found = i.gap.nearer(body_a, body_b, known, Vector3d::Zero(), reach, result) || found;
    }
  }
  return found;
}

}  // namespace twinbus::robot
