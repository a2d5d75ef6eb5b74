#include "sim/objects/rigid_object_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/math/index.h"
#include "sim/contact/bristle.h"
#include "sim/contact/ground_contacts.h"
#include "sim/objects/rigid_object_mesh.h"

namespace twinbus::inline sim {

namespace {

constexpr double kAlong = 0.999;  // of a face's normal along the way out
constexpr double kRigid = std::numeric_limits<double>::infinity();

double thickness_of(bool solid, bool tile, const Solid& shape) {
  if (!solid || tile) return kRigid;
  switch (shape.shape) {
    case SolidShape::kBox:
      return shape.size.minCoeff();
    case SolidShape::kSphere:
    case SolidShape::kCapsule:
      return 2.0 * shape.size.x();
    case SolidShape::kCylinder:
      return std::min(2.0 * shape.size.x(), shape.size.y());
  }
  return kRigid;
}

// How far a point is beyond the edges of a face of a box, in its axes; below 0: it is over the face.
double beside(const Eigen::Vector3d& point, const Eigen::Vector3d& size, int face) noexcept {
  Eigen::Vector3d beyond = point.cwiseAbs() - 0.5 * size;
  beyond[face / 2] = 0.0;
  return beyond.maxCoeff();
}

// The face whose normal this is; -1: of none, at an edge.
int face_along(const Eigen::Vector3d& normal) noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > kAlong) return 2 * axis + (normal[axis] > 0.0 ? 0 : 1);
  }
  return -1;
}

ContactParams hard(double stiffness, double damping, double friction) {
  return {stiffness, damping, stiffness, damping, friction, kDampingRamp, 0.0, 0.0};
}

double series(double a, double b) {
  if (a == kRigid) return b;
  if (b == kRigid) return a;
  return a + b > 0.0 ? a * b / (a + b) : 0.0;
}

}  // namespace

ContactParams together(const ContactParams& a, const ContactParams& b) {
  return {series(a.stiffness, b.stiffness),
          series(a.damping, b.damping),
          series(a.tangent_stiffness, b.tangent_stiffness),
          series(a.tangent_damping, b.tangent_damping),
          std::sqrt(a.friction * b.friction),
          std::max(a.ramp, b.ramp),
          std::max(a.rolling, b.rolling),
          std::max(a.torsional, b.torsional)};
}

LooseContacts::LooseContacts(const Model& model, const WorldConfig& config)
    : robots_meet_(config.self_contact || !config.robots.empty()),
      self_contact_(config.self_contact),
      patches_(config.contact == ContactModel::kPatch),
      continuous_(config.continuous),
      apart_(1 + config.loose.size() + config.robots.size()),
      ground_(hard(kRigid, kRigid, config.ground_friction)) {
  int system = 0;
  for (const LooseBody& body : config.loose) {
    Piece piece;
    piece.system = ++system;
    piece.solid = body.solid;
    piece.mesh = body.mesh != nullptr || !patches_ ? body.mesh : mesh_of(body.solid);
    piece.only_mesh = piece.mesh != nullptr;
    if (!piece.only_mesh) piece.probes = probes_of(body.solid);
    piece.solid_too = !piece.only_mesh;
    if (patches_ && body.mesh == nullptr) {
      piece.ball = body.solid.shape == SolidShape::kSphere;
      if (body.solid.shape == SolidShape::kBox) piece.box_half = 0.5 * body.solid.size;
    }
    piece.params = as_asked(config, hard(body.stiffness, body.damping, body.friction));
    add(std::move(piece));
  }
  loose_ = pieces_.size();
  if (active()) add_robot(model, config, 0, config.fixed_base);
  for (const OtherRobot& robot : config.robots) add_robot(*robot.model, config, ++system, !robot.model->floating_base);
  alone_.assign(apart_.size(), 0);
  heap_.assign(apart_.size(), 0);
  woke_.assign(apart_.size(), 0);
  moving_ = pieces_.size();
  const auto add_fixed = [&](const Obstacle& obstacle, bool tile) {
    if (obstacle.shape == ObstacleShape::kNone || loose_ == 0) return;
    Piece piece;
    piece.solid = solid_of(obstacle);
    piece.rotation = obstacle.pose.linear();
    piece.center = obstacle.pose.translation();
    piece.params = ground_;
    piece.tile = tile;
    if (!tile && obstacle.shape == ObstacleShape::kBox) piece.probes = probes_of(piece.solid);
    add(std::move(piece));
  };
  for (const Obstacle& obstacle : config.obstacles) add_fixed(obstacle, false);
  for (const Obstacle& tile : config.tiles) add_fixed(tile, true);
  if (std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.only_mesh; })) {
    give_meshes();
  }
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    spans_.push_back({0.0, 0.0, static_cast<int>(i)});
  near_.reserve(spans_.size());
  const std::size_t robots = 1 + config.robots.size();
  const std::size_t most = active() ? robots * kMostContacts + loose_ * kMostLooseContacts : 0;
  memory_.reserve(most);
  saved_.reserve(most);
  if (config.asleep) slept_.reserve(most);
  remembered_.reserve(most);
  if (continuous_) faces_.reserve(most);
}

void LooseContacts::add_robot(const Model& model, const WorldConfig& config, int system, bool fixed_base) {
  const double scale = system == 0 ? config.stiffness_scale : 1.0;
  const double damping_scale = system == 0 ? config.damping_scale : 1.0;
  const auto untouched = [&](int link, int shape) {
    const std::array<int, 2> which{link, shape};
    return system == 0 && std::find(config.untouched.begin(), config.untouched.end(), which) != config.untouched.end();
  };
  Outline outline;
  outline.system = system;
  outline.first = pieces_.size();
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = model.soles[side];
    if (sole.link < 0 || untouched(static_cast<int>(side), -1)) continue;
    Piece piece;
    piece.system = system;
    piece.link = sole.link;
    piece.sole = static_cast<int>(side);
    piece.solid_too = false;
    piece.in_link = sole.frame;
    piece.params = as_asked(config, rubber(sole.stiffness / kSoleCorners * scale,
                                           sole.damping / kSoleCorners * damping_scale, sole.friction));
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      piece.probes.push_back({sole_corner(sole, corner), 0.0});
    }
    if (patches_) give_sole_mesh(sole, piece);
    add(std::move(piece));
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    for (const Shape& shape : model.links[i].collision) {
      if (untouched(static_cast<int>(i), static_cast<int>(&shape - model.links[i].collision.data()))) continue;
      Piece piece;
      piece.system = system;
      piece.link = static_cast<int>(i);
      if (shape.kind == ShapeKind::kMesh) {
        add_hull(shape, model, as_asked(config, shell(config.shell_stiffness, kLinkFriction)),
                 std::move(piece));
        continue;
      }
      piece.solid.size = shape.size;
      piece.solid.shape = shape.kind == ShapeKind::kBox      ? SolidShape::kBox
                          : shape.kind == ShapeKind::kSphere ? SolidShape::kSphere
                                                             : SolidShape::kCylinder;
      piece.in_link = shape.pose;
      piece.params = as_asked(config, shell(config.shell_stiffness, kLinkFriction));
      piece.probes = probes_of(piece.solid);
      // Near its sole a foot touches with the sole's corners.
      for (const Sole& sole : model.soles) {
        if (sole.link != piece.link) continue;
        const Eigen::Isometry3d in_sole = sole.frame.inverse() * shape.pose;
        std::erase_if(piece.probes,
                      [&](const Probe& p) { return (in_sole * p.center).z() < kSoleSkin; });
        piece.of_foot = true;
      }
      if (patches_ && piece.of_foot) give_foot_mesh(model, piece);
      add(std::move(piece));
    }
  }
  if (self_contact_) apart_[at(system)] = LinkPairs(model);
  outline.end = pieces_.size();
  outline.fixed = fixed_base && std::all_of(pieces_.begin() + static_cast<std::ptrdiff_t>(outline.first), pieces_.end(),
                                            [](const Piece& piece) { return piece.link == 0; });
  robots_.push_back(outline);
}

// a comes before b.  What robots do with fixed things is sim/contact/ground_contacts.h's business.
bool LooseContacts::may_meet(std::size_t a, std::size_t b) const noexcept {
  if (a < loose_) return !lies(pieces_[a]) || !lies(pieces_[b]);
  if (b >= moving_) return false;
  const Piece& one = pieces_[a];
  const Piece& other = pieces_[b];
  if (one.system != other.system) return true;
  if (!self_contact_) return false;
  return !apart_[at(one.system)].never_touch(one.link, other.link);
}

void LooseContacts::add(Piece piece) {
  for (const Probe& probe : piece.probes) {
    piece.radius = std::max(piece.radius, probe.center.norm() + probe.radius);
  }
  if (piece.solid_too) piece.radius = std::max(piece.radius, bounding_radius(piece.solid));
  if (piece.only_mesh) {
    for (const Eigen::Vector3d& vertex : piece.mesh->vertices()) {
      piece.radius = std::max(piece.radius, vertex.norm());
    }
  }
  piece.thickness = thickness_of(piece.solid_too, piece.tile, piece.solid);
  if (piece.only_mesh) piece.thickness = piece.mesh->box().sizes().minCoeff();
  if (patches_ && piece.solid_too && piece.solid.shape == SolidShape::kBox && piece.mesh == nullptr)
    piece.box_half = 0.5 * piece.solid.size;
  thinnest_ = std::min(thinnest_, piece.thickness);
  if (patches_ && piece.sole < 0)
    piece.per_area = kSoleCorners / mean_face(piece.solid, piece.mesh.get());
  piece.first_key = next_key_;
  // Two more for the ends of a cylinder that rolls.
  next_key_ += static_cast<int>(piece.probes.size()) + 2;
  pieces_.push_back(std::move(piece));
}

void LooseContacts::place(std::size_t first, std::size_t end, const std::vector<ArticulatedBody*>& systems) noexcept {
  for (std::size_t i = first; i < end;) {
    const int system = pieces_[i].system, number = pieces_[i].link;
    const ArticulatedBody& body = *systems[at(system)];
    const LinkNow link = body.link(number);
    const Eigen::Vector3d v = linear(link.velocity), w = angular(link.velocity);
    const double spin = w.norm();
    for (; i < end && pieces_[i].link == number && pieces_[i].system == system; ++i) {  // mostly many are of one link
      Piece& piece = pieces_[i];
      const Eigen::Vector3d middle = link.origin + link.rotation * piece.in_link.translation();
      piece.rotation = link.rotation * piece.in_link.linear();
      piece.center = body.origin() + middle;
      piece.velocity.x() = v.x() + (w.y() * middle.z() - w.z() * middle.y());
      piece.velocity.y() = v.y() + (w.z() * middle.x() - w.x() * middle.z());
      piece.velocity.z() = v.z() + (w.x() * middle.y() - w.y() * middle.x());
      piece.turning = spin * piece.radius;
      piece.speed = piece.velocity.norm() + piece.turning;
    }
  }
}

bool LooseContacts::near(const Piece& a, const Piece& b, double h) const noexcept {
  const double speed = (a.velocity - b.velocity).norm() + a.turning + b.turning;
  const double apart = a.radius + b.radius + reach_of(speed, h);
  return (a.center - b.center).squaredNorm() < apart * apart;
}

// reach: how far each of its pieces comes from its middle.
template <class Reach>
Eigen::AlignedBox3d LooseContacts::box_of(const Outline& robot, const Reach& reach) const noexcept {
  Eigen::AlignedBox3d box;
  for (std::size_t i = robot.first; i < robot.end; ++i) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach(pieces_[i]));
    box.extend(pieces_[i].center - half);
    box.extend(pieces_[i].center + half);
  }
  return box;
}

void LooseContacts::place_all(const std::vector<ArticulatedBody*>& systems) noexcept {
  for (std::size_t i = 0; i < loose_; ++i) {
    if (!asleep(pieces_[i].system)) place(i, i + 1, systems);
  }
  for (Outline& robot : robots_) {
    if (robot.first == robot.end) continue;
    Piece& base = pieces_[robot.first];
    const Eigen::Vector3d center = base.center;
    const Eigen::Matrix3d rotation = base.rotation;
    place(robot.first, robot.first + 1, systems);
    if (robot.placed && base.center == center && base.rotation == rotation) continue;
    place(robot.first + 1, robot.end, systems);
    robot.placed = robot.fixed;
    if (robot.fixed) robot.bare = box_of(robot, [](const Piece& piece) { return piece.radius; });
  }
}

double LooseContacts::extent(int link) const noexcept {
  double most = 0.0;
  for (const Piece& piece : pieces_) {
    if (piece.system == 0 && piece.link == link) most = std::max(most, piece.in_link.translation().norm() + piece.radius);
  }
  return most;
}

bool LooseContacts::away_from(const Eigen::AlignedBox3d& box, const std::vector<ArticulatedBody*>& systems, double h) noexcept {
  for (std::size_t i = 0; i < loose_; ++i) {
    const Piece& piece = pieces_[i];
    place(i, i + 1, systems);
    if (!(box.exteriorDistance(piece.center) > piece.radius + reach_of(piece.speed, h))) return false;
  }
  placed_ = true;
  return true;
}

bool LooseContacts::away_from_robot(const std::vector<ArticulatedBody*>& systems, double h) noexcept {
  place_all(systems);
  find_alone(h);
  return alone_[0] != 0;
}

// Seen from the first robot: what flies along with it does not come nearer.
void LooseContacts::find_alone(double h) noexcept {
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  if (!robots_.empty() && robots_.front().first < robots_.front().end) along = pieces_[robots_.front().first].velocity;
  const auto reach = [&](const Piece& piece) {
    return piece.radius + reach_of((piece.velocity - along).norm() + piece.turning, h);
  };
  for (Outline& robot : robots_) {
    if (robot.placed) {
      const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach_of(along.norm(), h));
      robot.box = Eigen::AlignedBox3d(robot.bare.min() - half, robot.bare.max() + half);
      continue;
    }
    robot.box = box_of(robot, reach);
  }
  for (const Outline& robot : robots_) {
    bool alone = !self_contact_;
    for (const Outline& other : robots_) {
      if (&other != &robot && other.box.intersects(robot.box)) alone = false;
    }
    for (std::size_t i = 0; alone && i < loose_; ++i) {
      alone = robot.box.exteriorDistance(pieces_[i].center) > reach(pieces_[i]);
    }
    alone_[at(robot.system)] = alone ? 1 : 0;
  }
}

void LooseContacts::find_once(Search& search, bool away) noexcept {
  const double h = search.h;
  if (continuous_) faces_.begin_search();
  for (std::size_t i = 0; i < loose_; ++i) {
    const Piece& own = pieces_[i];
    if (own.center.z() < own.radius + reach_of(own.speed, h) && !asleep(own.system)) meet_ground(own, search);
  }
  if (away) alone_[0] = 1;
  else find_alone(h);
  sort_spans(h);
  near_.clear();
  for (const Span& span : spans_) {
    const int system = pieces_[at(span.piece)].system;
    if (system < 0 || alone_[at(system)] == 0) near_.push_back(span);
  }
  for (std::size_t a = 0; a < near_.size(); ++a) {
    for (std::size_t b = a + 1; b < near_.size() && near_[b].from <= near_[a].to; ++b) {
      const std::size_t i = at(std::min(near_[a].piece, near_[b].piece));
      const std::size_t j = at(std::max(near_[a].piece, near_[b].piece));
      if (!may_meet(i, j) || !near(pieces_[i], pieces_[j], h)) continue;
      if (pieces_[i].only_mesh || pieces_[j].only_mesh) {
        meet_mesh(i, static_cast<int>(j), search);
        continue;
      }
      meet_probes(i, j, search);
    }
  }
}

// By insertion: little changes from step to step.  What begins at the same place is in the order of
// the pieces, so that the order depends on nothing but where they are.
void LooseContacts::sort_spans(double h) noexcept {
  for (Span& span : spans_) {
    const Piece& piece = pieces_[at(span.piece)];
    const double half = piece.radius + reach_of(piece.speed, h);
    span.from = piece.center.x() - half;
    span.to = piece.center.x() + half;
  }
  for (std::size_t k = 1; k < spans_.size(); ++k) {
    const Span span = spans_[k];
    std::size_t to = k;
    for (; to > 0; --to) {
      const Span& before = spans_[to - 1];
      if (before.from < span.from || (before.from == span.from && before.piece < span.piece)) break;
      spans_[to] = before;
    }
    spans_[to] = span;
  }
}

void LooseContacts::meet(const Piece& from, std::size_t into, bool turned, Search& search) noexcept {
  const Piece& solid = pieces_[into];
  const auto targets = static_cast<int>(pieces_.size()) + 1;
  Contact found;
  found.params = together(from.params, solid.params);
  found.sole = from.sole;
  found.system = turned ? solid.system : from.system;
  found.link = turned ? solid.link : from.link;
  found.other_system = turned ? -1 : solid.system;
  found.other = turned ? -1 : solid.link;
  const int together_by = face_between(from, solid);
  const bool keeps = continuous_ && solid.solid.shape == SolidShape::kBox && !solid.tile;
  for (std::size_t i = 0; i < from.probes.size(); ++i) {
    const Probe& probe = from.probes[i];
    const Eigen::Vector3d center = from.center + from.rotation * probe.center;
    const Eigen::Vector3d inside = solid.rotation.transpose() * (center - solid.center);
    found.key =
        kFirstKey + (from.first_key + static_cast<int>(i)) * targets + static_cast<int>(into) + 1;
    int face = together_by;
    if (keeps) {
      const int kept = faces_.of(found.key);
      if (kept >= 0 && beside(inside, solid.solid.size, kept) < kMargin) face = kept;
    }
    Distance d;
    if (solid.tile) {
      const bool over = std::abs(inside.x()) <= 0.5 * solid.solid.size.x() &&
                        std::abs(inside.y()) <= 0.5 * solid.solid.size.y();
      d = {over ? inside.z() - 0.5 * solid.solid.size.z() : 1.0, Eigen::Vector3d::UnitZ()};
    } else if (face >= 0) {
      const int axis = face / 2;
      const double sign = face % 2 == 0 ? 1.0 : -1.0;
      if (!(beside(inside, solid.solid.size, face) < kMargin)) continue;
      d = {sign * inside[axis] - 0.5 * solid.solid.size[axis], sign * Eigen::Vector3d::Unit(axis)};
    } else {
      d = distance_to(solid.solid, inside);
    }
    const Eigen::Vector3d out = solid.rotation * d.normal;
    found.normal = turned ? Eigen::Vector3d(-out) : out;
    found.depth = probe.radius - d.value;
    found.material = !turned && !(probe.radius > 0.0);
    found.point = center - probe.radius * out;
    if (consider(found, search) && keeps && (face >= 0 || (face = face_along(d.normal)) >= 0)) {
      faces_.found(found.key, face);
    }
  }
}

bool LooseContacts::consider(Contact& c, Search& search) noexcept {
  const ArticulatedBody& body = *search.systems[at(c.system)];
  if (c.link < 0) c.link = 0;
  c.r = c.point - body.origin();
  c.v0 = at_point(body.velocity(c.link), c.r);
  c.w0 = angular(body.velocity(c.link));
  const ArticulatedBody* other = c.other_system >= 0 ? search.systems[at(c.other_system)] : nullptr;
  if (other != nullptr) {
    c.other_r = c.point - other->origin();
    c.v0 -= at_point(other->velocity(c.other), c.other_r);
    c.w0 -= angular(other->velocity(c.other));
  }
  if (!(c.depth > -reach_of(c.v0.norm(), search.h)) ||
      search.contacts.size() >= search.contacts.capacity()) {
    return false;
  }
  search.contacts.push_back(c);
  Contact& added = search.contacts.back();
  // Contacts are found in the same order at each step: the one sought is mostly the next.
  const auto known = [&] { return !memory_.empty() && memory_[search.cursor % memory_.size()].key == c.key; };
  if (const int place = known() ? -1 : remembered_.find(c.key); place >= 0) search.cursor = at(place);
  if (!known()) {
    added.guess.setZero();
    added.stretch = planted(added, search.h);
    return true;
  }
  const Memory& memory = memory_[search.cursor++ % memory_.size()];
  Eigen::Vector3d bristle = memory.bristle;
  added.turned = memory.turned;
  if (other != nullptr) {
    const LinkNow link = other->link(c.other);
    bristle = link.rotation * bristle;
    added.turned = link.rotation * added.turned;
    if (c.material) bristle += other->origin() + link.origin;
  }
  added.stretch = c.material ? Eigen::Vector3d(c.point - bristle) : bristle;
  added.stretch -= c.normal * c.normal.dot(added.stretch);
  added.guess = memory.force;
  return true;
}

void LooseContacts::remember(const std::vector<ArticulatedBody*>& systems,
                             const std::vector<Contact>& contacts, double h) noexcept {
  memory_.clear();
  if (continuous_) faces_.remember();
  for (const Contact& c : contacts) {
    if (c.key < kFirstKey || c.now.mode == ContactMode::kOpen) continue;
    const Bristle bristle = bristle_after(c, h);
    Eigen::Vector3d kept = c.material ? bristle.anchor : bristle.stretch, turned = Eigen::Vector3d::Zero();
    if (turns(c)) turned = turned_after(c.params, c.turned, c.moment, h);
    if (c.other_system >= 0) {
      const ArticulatedBody& other = *systems[at(c.other_system)];
      const LinkNow link = other.link(c.other);
      if (c.material) kept -= other.origin() + link.origin;
      kept = link.rotation.transpose() * kept;
      turned = link.rotation.transpose() * turned;
    }
    memory_.push_back({c.key, kept, c.now.force, turned});
  }
  index_memory();
}

}  // namespace twinbus::sim
