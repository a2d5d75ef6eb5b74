#include "sim/contact/ground_contacts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/math/index.h"
#include "sim/contact/bristle.h"
#include "sim/world/felt_feet.h"
#include "sim/world/link_hull.h"

namespace twinbus::inline sim {

namespace {

constexpr double kTangentRatio = 40.0;
constexpr double kTangentMass = 15.0;  // [kg]

constexpr double kHigh = 1.0;  // [m], more than the ground is ever uneven
constexpr double kSure = 1e-6;  // more than distances are rounded by [m]

// Whether a ball of a toe, at rest, is under the sole that it hangs on.
bool toe_under_sole(const Model& model, const Sole& sole, int link, Eigen::Vector3d point, double radius) {
  if (!is_toe_of(model, sole, link)) return false;
  for (; link != sole.link; link = model.links[at(link)].parent) {
    const Joint& joint = model.joints[at(link - 1)];
    const double q = std::clamp(0.0, joint.lower, joint.upper);
    if (joint.kind == JointKind::kPrismatic) point += q * joint.axis;
    else point = Eigen::AngleAxisd(q, joint.axis) * point;
    point = joint.placement * point;
  }
  return under_sole(sole, sole.frame.inverse() * point, radius);
}

}  // namespace

ContactParams rubber(double k, double c, double mu) {
  ContactParams params;
  params.stiffness = k;
  params.damping = c;
  params.tangent_stiffness = kTangentRatio * k;
  params.tangent_damping = std::sqrt(params.tangent_stiffness * kTangentMass);
  params.friction = mu;
  return params;
}

ContactParams shell(double stiffness, double friction) {
  return rubber(stiffness, kLinkDamping * std::sqrt(stiffness / kLinkStiffness), friction);
}

ContactParams as_asked(const WorldConfig& config, const ContactParams& params) {
  ContactParams asked = damps_by_depth(config.contact) ? hunt_crossley(params, config.dissipation) : params;
  asked.rolling = config.rolling_friction;
  asked.torsional = config.torsional_friction;
  return asked;
}

ContactParams times(const ContactParams& params, double share) noexcept {
  ContactParams scaled = params;
  scaled.stiffness *= share;
  scaled.damping *= share;
  scaled.tangent_stiffness *= share;
  scaled.tangent_damping *= share;
  return scaled;
}

Solid solid_of(const Obstacle& obstacle) noexcept {
  const SolidShape shape = obstacle.shape == ObstacleShape::kBox      ? SolidShape::kBox
                           : obstacle.shape == ObstacleShape::kSphere ? SolidShape::kSphere
                                                                      : SolidShape::kCylinder;
  return {shape, obstacle.size};
}

GroundContacts::GroundContacts(const Model& model, const WorldConfig& config)
    : fixed_base_(config.fixed_base), soles_(model.soles), ground_height_(config.ground_height) {
  for (std::size_t side = 0; side < 2; ++side) {
    const Sole& sole = soles_[side];
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      corner_[side][at(corner)] = sole.frame * sole_corner(sole, corner);
    }
    sole_params_[side] =
        as_asked(config, rubber(sole.stiffness / kSoleCorners * config.stiffness_scale,
                                sole.damping / kSoleCorners * config.damping_scale,
                                std::sqrt(sole.friction * config.ground_friction)));
  }
  shell_params_ = as_asked(
      config, shell(config.shell_stiffness, std::sqrt(kLinkFriction * config.ground_friction)));
  for (const Obstacle& obstacle : config.obstacles) {
    if (obstacle.shape == ObstacleShape::kNone) continue;
    obstacles_.push_back(obstacle);
    obstacle_radius_.push_back(bounding_radius(solid_of(obstacle)));
  }
  solid_ = obstacles_.size();
  for (const Obstacle& tile : config.tiles) {
    obstacles_.push_back(tile);
    obstacle_radius_.push_back(bounding_radius(solid_of(tile)));
  }
  tiled_ = !config.tiles.empty() && soles_[0].link < 0 && soles_[1].link < 0;
  for (std::size_t i = solid_; tiled_ && i < obstacles_.size(); ++i)
    rise_ = std::max(rise_, obstacles_[i].pose.translation().z() + obstacle_radius_[i]);
  // Of a side its four corners at each surface, or its patches and the corners.
  sole_keys_ = kSoleCorners * (static_cast<int>(obstacles_.size()) + 1);
  if (config.contact == ContactModel::kPatch) {
    patches_.emplace(model, config);
    sole_keys_ += patches_->keys();
    if (!tiled_) link_patches_.emplace(model, config);
  }
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    for (std::size_t s = 0; s < model.links[i].collision.size(); ++s) {
      const std::array<int, 2> which{static_cast<int>(i), static_cast<int>(s)};
      if (std::find(config.aloft.begin(), config.aloft.end(), which) != config.aloft.end()) continue;
      add_probes(which[0], which[1], model.links[i].collision[s], model);
    }
  }
  // The longest way from link 0's origin to anything that can touch.
  std::vector<double> far(model.links.size(), 0.0);
  for (std::size_t i = 1; i < far.size(); ++i) {
    const Joint& joint = model.joints[i - 1];
    far[i] = far[at(joint.parent)] + joint.placement.translation().norm();
    if (joint.kind == JointKind::kPrismatic) {
      far[i] += std::max(std::abs(joint.lower), std::abs(joint.upper));
    }
  }
  for (const ShapeProbes& shape : shapes_) {
    reach_ = std::max(reach_, far[at(shape.link)] + shape.center.norm() + shape.radius);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    if (soles_[side].link < 0) continue;
    for (const Eigen::Vector3d& local : corner_[side]) {
      reach_ = std::max(reach_, far[at(soles_[side].link)] + local.norm());
    }
  }
  memory_.reserve(kMostContacts);
  saved_.reserve(kMostContacts);
}

void GroundContacts::add_probes(int link, int number, const Shape& shape, const Model& model) {
  if (link == 0 && fixed_base_) return;
  ShapeProbes added{link, shape.pose.translation(), 0.0, probes_.size(), 0, 0, 0.0, -1};
  if (link_patches_) added.area = link_patches_->of(link, number);
  const auto probe = [&](const Eigen::Vector3d& at, double radius) {
    LinkProbe p{shape.pose * at, radius, false};
    for (const Sole& sole : model.soles) {
      p.skin = p.skin || (sole.link == link && (sole.frame.inverse() * p.center).z() - radius < kSoleSkin) ||
               toe_under_sole(model, sole, link, p.center, radius);
    }
    added.radius = std::max(added.radius, at.norm() + radius);
    probes_.push_back(p);
    ++added.count;
  };
  for (const TouchPoint& point : touch_points(shape)) probe(point.at, point.radius);
  const auto first = probes_.begin() + static_cast<std::ptrdiff_t>(added.first);
  const auto skin =
      std::stable_partition(first, probes_.end(), [](const LinkProbe& p) { return !p.skin; });
  added.bare = static_cast<std::size_t>(skin - first);
  added.extent = added.center.norm() + added.radius;
  if (added.count > 0) shapes_.push_back(added);
}

// Surface 0 is the ground, others are obstacles.  Signed, negative inside.
Distance GroundContacts::distance(std::size_t surface,
                                  const Eigen::Vector3d& point) const noexcept {
  if (surface == 0) return {point.z(), Eigen::Vector3d::UnitZ()};
  const Obstacle& obstacle = obstacles_[surface - 1];
  const Eigen::Matrix3d turn = obstacle.pose.linear();
  const Distance d =
      distance_to(solid_of(obstacle), turn.transpose() * (point - obstacle.pose.translation()));
  return {d.value, turn * d.normal};
}

Distance under_tile(const Obstacle& box, const Eigen::Vector3d& point) noexcept {
  const Eigen::Vector3d p = box.pose.linear().transpose() * (point - box.pose.translation());
  const bool over = std::abs(p.x()) <= 0.5 * box.size.x() && std::abs(p.y()) <= 0.5 * box.size.y();
  return {over ? p.z() - 0.5 * box.size.z() : 1.0, box.pose.linear().col(2)};
}

std::size_t GroundContacts::deepest_tile(const Eigen::Vector3d& point, Distance& d) const noexcept {
  std::size_t met = 0;
  for (std::size_t i = solid_; i < obstacles_.size(); ++i) {
    if ((obstacles_[i].pose.translation() - point).norm() > obstacle_radius_[i] + kHigh) continue;
    const Distance under = under_tile(obstacles_[i], point);
    if (!(under.value < d.value)) continue;
    d = under;
    met = i + 1;
  }
  return met;
}

void GroundContacts::find(const ArticulatedBody& body, double h,
                          std::vector<Contact>& contacts) const noexcept {
  contacts.clear();
  // High above everything.
  if (obstacles_.empty() && body.origin().z() > reach_ + kHigh + 2.0 * h * kMaxSpeed) return;
  find_corners(body, h, contacts);
  find_probes(body, h, contacts);
}

void GroundContacts::find_corners(const ArticulatedBody& body, double h,
                                  std::vector<Contact>& contacts) const noexcept {
  std::size_t cursor = 0;
  if (patches_) {
    find_patches(body, h, cursor, contacts);
    if (solid_ == 0) return;
  }
  const int surfaces = static_cast<int>(obstacles_.size()) + 1;
  for (int side = 0; side < 2; ++side) {
    const auto foot = static_cast<std::size_t>(side);
    const Sole& sole = soles_[foot];
    if (sole.link < 0 || (sole.link == 0 && fixed_base_)) continue;
    const LinkNow link = body.link(sole.link);
    Found found{.link = sole.link, .sole = side, .material = true, .params = &sole_params_[foot]};
    for (int corner = 0; corner < kSoleCorners; ++corner) {
      found.r = link.origin + link.rotation * corner_[foot][at(corner)];
      const Eigen::Vector3d point = body.origin() + found.r;
      const double offset = offset_[foot][at(corner)];
      int deepest = 0;
      found.depth = patches_ ? -kHigh : ground_height_[foot] - offset - point.z();
      found.normal = Eigen::Vector3d::UnitZ();
      for (std::size_t i = 0; i < obstacles_.size(); ++i) {
        const Eigen::Vector3d away = obstacles_[i].pose.translation() - point;
        const double apart = away.norm();
        if (!(apart < obstacle_radius_[i] + 1.0)) continue;
        // The ball around it is farther than what is deepest so far.
        if (i < solid_ && obstacle_radius_[i] - apart + kSure < found.depth + offset) continue;
        if (patches_ && (i >= solid_ || patches_->stands_on(i, point))) continue;
        const Distance d = i < solid_ ? distance(i + 1, point) : under_tile(obstacles_[i], point);
        if (!(-d.value - offset > found.depth)) continue;
        deepest = static_cast<int>(i) + 1;
        found.depth = -d.value - offset;
        found.normal = d.normal;
      }
      if (patches_ && deepest == 0) continue;
      found.key = (side * kSoleCorners + corner) * surfaces + deepest;
      add(body, link.velocity, found, h, cursor, contacts);
    }
  }
}

void GroundContacts::find_patches(const ArticulatedBody& body, double h, std::size_t& cursor,
                                  std::vector<Contact>& contacts) const noexcept {
  SolePatches::Points points;
  const int first_key = 2 * kSoleCorners * (static_cast<int>(obstacles_.size()) + 1);
  for (int side = 0; side < 2; ++side) {
    const auto foot = static_cast<std::size_t>(side);
    const Sole& sole = soles_[foot];
    if (sole.link < 0 || (sole.link == 0 && fixed_base_)) continue;
    const LinkNow link = body.link(sole.link);
    Eigen::Isometry3d frame;
    frame.linear() = link.rotation * sole.frame.linear();
    const Eigen::Vector3d at_frame = link.origin + link.rotation * sole.frame.translation();
    frame.translation() = body.origin() + at_frame;
    const int count =
        patches_->find(foot, frame, at_point(link.velocity, at_frame), angular(link.velocity), h,
                       ground_height_[foot], offset_[foot], points);
    for (int i = 0; i < count; ++i) {
      const SolePoint& point = points[at(i)];
      const ContactParams params = times(sole_params_[foot], point.weight);
      const Found found{.link = sole.link,
                        .sole = side,
                        .key = first_key + side * patches_->keys() + point.key,
                        .material = false,
                        .params = &params,
                        .r = point.position - body.origin(),
                        .normal = point.normal,
                        .depth = point.depth,
                        .foreseen = true};
      add(body, link.velocity, found, h, cursor, contacts);
    }
  }
}

void GroundContacts::find_probes(const ArticulatedBody& body, double h,
                                 std::vector<Contact>& contacts) const noexcept {
  if (shapes_.empty()) return;
  std::size_t cursor = 0;
  const std::size_t surfaces = obstacles_.size() + 1;
  Found found{.link = -1, .sole = -1, .params = &shell_params_};
  const double far = reach_of(body.fastest(reach_), h);
  for (const ShapeProbes& shape : shapes_) {
    if (solid_ == 0) {  // most are high above the ground, and their link's origin says so
      if (!(body.height(shape.link) < shape.extent + far + rise_)) continue;
      if (!(body.height(shape.link, shape.center) < shape.radius + far + rise_)) continue;
    }
    const LinkNow link = body.link(shape.link);
    const Eigen::Vector3d middle = link.origin + link.rotation * shape.center;
    const Eigen::Vector3d spin = angular(link.velocity);
    // Nothing of the shape moves faster than this (sums are bounds of norms, and cheaper).
    const double speed =
        at_point(link.velocity, middle).cwiseAbs().sum() + spin.cwiseAbs().sum() * shape.radius;
    const double reach = reach_of(speed, h);
    for (std::size_t surface = 0; surface <= solid_; ++surface) {
      const Eigen::Vector3d at = body.origin() + middle;
      if (surface == 0) {
        if (!(at.z() < shape.radius + reach + rise_)) continue;
      } else {
        const Obstacle& obstacle = obstacles_[surface - 1];
        const double apart = (obstacle.pose.translation() - at).norm();
        if (!(apart < shape.radius + obstacle_radius_[surface - 1] + reach)) continue;
        if (!(distance(surface, at).value < shape.radius + reach)) continue;
      }
      if (shape.area >= 0) {
        press(body, link, shape, surface, h, cursor, contacts);
        continue;
      }
      const std::size_t end = shape.first + (surface == 0 ? shape.bare : shape.count);
      const Eigen::Vector3d up = link.rotation.row(2);
      const double middle_height = body.origin().z() + link.origin.z();
      for (std::size_t i = shape.first; i < end; ++i) {
        const LinkProbe& probe = probes_[i];
        if (surface == 0) {  // of most, how high they are is enough
          const double height = middle_height + up.dot(probe.center);
          if (!(probe.radius + rise_ - height > -reach)) continue;
        }
        const Eigen::Vector3d center = link.origin + link.rotation * probe.center;
        Distance d = distance(surface, body.origin() + center);
        const std::size_t met = surface == 0 && tiled_ ? deepest_tile(body.origin() + center, d) : surface;
        if (!(probe.radius - d.value > -reach)) continue;
        found.link = shape.link;
        found.key = 2 * sole_keys_ + static_cast<int>(i * surfaces + met);
        found.material = !(probe.radius > 0.0);
        found.depth = probe.radius - d.value;
        found.normal = d.normal;
        found.r = center - probe.radius * d.normal;
        add(body, link.velocity, found, h, cursor, contacts);
      }
    }
  }
}

void GroundContacts::press(const ArticulatedBody& body, const LinkNow& link, const ShapeProbes& shape,
                           std::size_t surface, double h, std::size_t& cursor,
                           std::vector<Contact>& contacts) const noexcept {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = link.rotation;
  pose.translation() = body.origin() + link.origin;
  LinkPress press;
  const Eigen::Vector3d velocity = at_point(link.velocity, link.origin);
  if (!link_patches_->find(shape.area, pose, velocity, angular(link.velocity), h, surface, press)) return;
  const ContactParams params = times(shell_params_, press.weight);
  const std::size_t surfaces = obstacles_.size() + 1;
  const std::size_t key = (probes_.size() + at(shape.area) * Patch::kPoints) * surfaces + surface * Patch::kPoints;
  Found found{.link = shape.link, .sole = -1, .params = &params, .normal = press.normal};
  found.stored = 0.5 * params.stiffness * press.rough;
  for (int i = 0; i < press.count; ++i) {
    found.key = 2 * sole_keys_ + static_cast<int>(key) + i;
    found.r = press.point[at(i)].position - body.origin();
    found.depth = press.point[at(i)].depth;
    add(body, link.velocity, found, h, cursor, contacts);
  }
}

void GroundContacts::clearance(const World& world, std::vector<double>& nearest) const {
  for (const ShapeProbes& shape : shapes_) {
    double& near = nearest[at(shape.link)];
    const Eigen::Isometry3d link = world.link_in_world(shape.link);
    for (std::size_t i = shape.first; i < shape.first + shape.count; ++i) {
      const Eigen::Vector3d center = link * probes_[i].center;
      for (std::size_t surface = i < shape.first + shape.bare ? 0 : 1; surface <= solid_; ++surface) {
        Distance d = distance(surface, center);
        if (surface == 0 && tiled_) (void)deepest_tile(center, d);
        near = std::min(near, d.value - probes_[i].radius);
      }
    }
  }
}

void GroundContacts::add(const ArticulatedBody& body, const Screw& velocity, const Found& found,
                         double h, std::size_t& cursor,
                         std::vector<Contact>& contacts) const noexcept {
  const Eigen::Vector3d v0 = at_point(velocity, found.r);
  const bool in_reach = found.depth > 0.0 || found.depth > -reach_of(v0.norm(), h);
  if (!in_reach || contacts.size() >= kMostContacts) return;
  Contact& c = contacts.emplace_back();
  c.link = found.link;
  c.sole = found.sole;
  c.key = found.key;
  c.material = found.material;
  c.params = *found.params;
  c.point = body.origin() + found.r;
  c.r = found.r;
  c.normal = found.normal;
  c.depth = found.depth;
  c.stored = found.stored;
  c.v0 = v0;
  c.w0 = angular(velocity);
  // Contacts are found in the same order at each step: the one sought is seldom far.
  for (std::size_t seen = 0; seen < memory_.size(); ++seen) {
    const Memory& memory = memory_[cursor];
    cursor = cursor + 1 < memory_.size() ? cursor + 1 : 0;
    if (memory.key != c.key) continue;
    c.stretch = c.material ? Eigen::Vector3d(c.point - memory.bristle) : memory.bristle;
    c.stretch -= c.normal * c.normal.dot(c.stretch);
    c.turned = memory.turned;
    c.foreseen = found.foreseen;
    if (c.foreseen) c.gain = memory.gain;
    return;
  }
  c.stretch = planted(c, h);
}

void GroundContacts::remember(const std::vector<Contact>& contacts, int system, double h) noexcept {
  memory_.clear();
  for (const Contact& c : contacts) {
    if (c.now.mode == ContactMode::kOpen || c.system != system || c.other_system >= 0 ||
        c.tie != TieKind::kNone) {
      continue;
    }
    const Bristle bristle = bristle_after(c, h);
    memory_.push_back({c.key, c.material ? bristle.anchor : bristle.stretch,
                       turns(c) ? turned_after(c.params, c.turned, c.moment, h) : Eigen::Vector3d(Eigen::Vector3d::Zero()),
                       (c.v - c.v0) / h});
  }
}

void GroundContacts::set_corner_offset(int sole, int corner, double offset) noexcept {
  offset_[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)] = offset;
}

double GroundContacts::corner_offset(int sole, int corner) const noexcept {
  return offset_[static_cast<std::size_t>(sole)][static_cast<std::size_t>(corner)];
}

}  // namespace twinbus::sim
