#include "geometry/mesh_contact/manifold.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/math/index.h"

namespace twinbus::inline geometry {

namespace {

constexpr double kOneDirection = 0.9998;  // cosine between constraints that share their room
constexpr double kEqual = 1e-6;           // of the depth
constexpr double kApart = 1e-3;           // of the extent: nearer points are one

std::int64_t feature_of(const Penetration& p) noexcept {
  return static_cast<std::int64_t>(p.kind) | static_cast<std::int64_t>(p.id) << 2 |
         static_cast<std::int64_t>(p.face + 1) << 32;
}

// Turned by half about any axis of the frame, the pair of directions changes signs only: the same
// points are chosen from both sides.
void axes_across(const Eigen::Vector3d& n, Eigen::Vector3d& x, Eigen::Vector3d& y) noexcept {
  Eigen::Index least = 0;
  n.cwiseAbs().minCoeff(&least);
  x = n.cross(Eigen::Vector3d::Unit(least)).normalized();
  y = n.cross(x);
}

bool box_within(const ContactMesh& inner, const Eigen::Isometry3d& inner_in_outer,
                const ContactMesh& outer) noexcept {
  const Eigen::Vector3d middle = inner_in_outer * inner.box().center();
  const Eigen::Vector3d half = inner_in_outer.linear().cwiseAbs() * (0.5 * inner.box().sizes());
  return outer.box().contains(Eigen::Vector3d(middle - half)) &&
         outer.box().contains(Eigen::Vector3d(middle + half));
}

}  // namespace

ManifoldFinder::ManifoldFinder() {
  for (std::size_t sides = 1; sides < directions_.size(); ++sides) {
    for (std::size_t side = 0; side < sides; ++side) {
      const double angle =
          2.0 * std::numbers::pi * (static_cast<double>(side) + 0.5) / static_cast<double>(sides);
      directions_[sides][side] = {std::cos(angle), std::sin(angle)};
    }
  }
}

void ManifoldFinder::reserve(const ContactMesh& mesh) {
  intersection_.reserve(mesh);
  const std::size_t most =
      std::max(found_.capacity(), 2 * mesh.vertices().size() + Intersection::kMostEdges);
  constraints_.reserve(most);
  found_.reserve(most);
  levers_.reserve(most);
  groups_.reserve(kMostGroups);
}

bool ManifoldFinder::between(const ContactMesh& a, const Eigen::Isometry3d& pose_a,
                             const ContactMesh& b, const Eigen::Isometry3d& pose_b,
                             Manifold& manifold) noexcept {
  manifold.count = manifold.found = 0;
  found_.clear();
  const Eigen::Isometry3d a_in_b = pose_b.inverse(Eigen::Isometry) * pose_a;
  int next = 0;
  if (intersection_.find(a, b, a_in_b)) {
    for (int region = 0; region < intersection_.regions(); ++region) {
      next = constraints_.find(intersection_.points(), intersection_.regions(), region, next,
                               found_);
    }
  } else if (a_in_b.matrix().allFinite()) {
    const Eigen::Isometry3d b_in_a = a_in_b.inverse(Eigen::Isometry);
    if (box_within(a, a_in_b, b) && b.contains(a_in_b * a.vertices().front())) {
      push_out(a, a_in_b, b, Eigen::Isometry3d::Identity(), true);
    } else if (box_within(b, b_in_a, a) && a.contains(b_in_a * b.vertices().front())) {
      push_out(b, Eigen::Isometry3d::Identity(), a, a_in_b, false);
    }
  }
  manifold.truncated = intersection_.truncated();
  reduce(pose_b, manifold);
  return manifold.count > 0;
}

bool ManifoldFinder::with_ground(const ContactMesh& a, const Eigen::Isometry3d& pose_a,
                                 Manifold& manifold) noexcept {
  manifold.count = manifold.found = 0;
  manifold.truncated = false;
  found_.clear();
  const Eigen::Vector3d up = pose_a.linear().row(2);
  const double reach = 0.5 * up.cwiseAbs().dot(a.box().sizes());
  if (!((pose_a * a.box().center()).z() - reach < 0.0)) return false;
  for (std::size_t i = 0; i < a.vertices().size(); ++i) {
    const double depth = -(up.dot(a.vertices()[i]) + pose_a.translation().z());
    if (!(depth > 0.0)) continue;
    found_.push_back({CrossingPoint::kVertexA, static_cast<int>(i), -1, pose_a * a.vertices()[i],
                      Eigen::Vector3d::UnitZ(), depth, 0});
  }
  reduce(Eigen::Isometry3d::Identity(), manifold);
  return manifold.count > 0;
}

// Nothing crosses: out through the face that the whole of it is nearest to being out of.
void ManifoldFinder::push_out(const ContactMesh& inner, const Eigen::Isometry3d& inner_in_b,
                              const ContactMesh& outer, const Eigen::Isometry3d& outer_in_b,
                              bool inner_is_a) noexcept {
  const Eigen::Isometry3d inner_in_outer = outer_in_b.inverse(Eigen::Isometry) * inner_in_b;
  const Eigen::Vector3d middle = inner_in_outer * inner.box().center();
  double least = std::numeric_limits<double>::infinity();
  const ContactFace* best = nullptr;
  for (const ContactFace& face : outer.faces()) {
    const Eigen::Vector3d n = inner_in_outer.linear().transpose() * face.normal;
    const double depth =
        face.offset - face.normal.dot(middle) + 0.5 * n.cwiseAbs().dot(inner.box().sizes());
    if (!(depth < least)) continue;
    least = depth;
    best = &face;
  }
  if (best == nullptr) return;
  const Eigen::Vector3d out = outer_in_b.linear() * best->normal;
  for (std::size_t i = 0; i < inner.vertices().size(); ++i) {
    const Eigen::Vector3d point = inner_in_outer * inner.vertices()[i];
    const double depth = best->offset - best->normal.dot(point);
    if (!(depth > 0.0)) continue;
    found_.push_back({inner_is_a ? CrossingPoint::kVertexA : CrossingPoint::kVertexB,
                      static_cast<int>(i), -1, outer_in_b * point, inner_is_a ? out : -out, depth,
                      0});
  }
}

void ManifoldFinder::reduce(const Eigen::Isometry3d& to_frame, Manifold& manifold) noexcept {
  manifold.found = static_cast<int>(found_.size());
  groups_.clear();
  int constraint = -1;
  std::size_t group = 0;
  for (Penetration& p : found_) {
    // Points of one constraint come together, unless it is one of faces.
    if (p.constraint != constraint || groups_.empty()) {
      constraint = p.constraint;
      for (group = 0; group < groups_.size(); ++group) {
        if (groups_[group].normal.dot(p.normal) > kOneDirection) break;
      }
      if (group == groups_.size()) {
        if (groups_.size() >= kMostGroups) {
          group = kMostGroups - 1;
        } else {
          groups_.push_back({p.normal, 0.0, 0});
        }
      }
    }
    p.constraint = static_cast<int>(group);
    groups_[group].deepest = std::max(groups_[group].deepest, p.depth);
  }
  share_room();
  for (std::size_t i = 0; i < groups_.size(); ++i) choose(static_cast<int>(i), to_frame, manifold);
}

// An even share for each, for the deepest if there are more constraints than points.
void ManifoldFinder::share_room() noexcept {
  const auto groups = static_cast<int>(groups_.size());
  if (groups == 0) return;
  const int share = std::max(1, Manifold::kMost / groups);
  for (int given = 0; given + share <= Manifold::kMost; given += share) {
    Group* deepest = nullptr;
    for (Group& group : groups_) {
      if (group.room == 0 && (deepest == nullptr || group.deepest > deepest->deepest)) {
        deepest = &group;
      }
    }
    if (deepest == nullptr) return;
    deepest->room = share;
  }
}

void ManifoldFinder::choose(int index, const Eigen::Isometry3d& to_frame,
                            Manifold& manifold) noexcept {
  const Group& group = groups_[at(index)];
  if (group.room == 0) return;
  Eigen::Vector3d x, y;
  axes_across(to_frame.linear() * group.normal, x, y);
  x = to_frame.linear().transpose() * x;
  y = to_frame.linear().transpose() * y;
  levers_.clear();
  double weight = 0.0, at_x = 0.0, at_y = 0.0, extent = 0.0;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const Penetration& p = found_[i];
    if (p.constraint != index) continue;
    const Lever lever{x.dot(p.point), y.dot(p.point), p.depth, static_cast<int>(i)};
    weight += lever.depth;
    at_x += lever.depth * lever.x;
    at_y += lever.depth * lever.y;
    if (!levers_.empty() && lever.depth > levers_[deepest].depth * (1.0 + 1e-9)) {
      deepest = levers_.size();
    }
    levers_.push_back(lever);
  }
  at_x /= weight;
  at_y /= weight;
  for (Lever& lever : levers_) {
    lever.x -= at_x;
    lever.y -= at_y;
    extent = std::max(extent, lever.x * lever.x + lever.y * lever.y);
  }
  std::array<std::size_t, Manifold::kMost> chosen;
  int count = 0;
  const auto add = [&](std::size_t lever) {
    for (int k = 0; k < count; ++k) {
      const Lever& known = levers_[chosen[at(k)]];
      const double x_apart = known.x - levers_[lever].x, y_apart = known.y - levers_[lever].y;
      if (x_apart * x_apart + y_apart * y_apart <= kApart * kApart * extent) return;
    }
    if (count < group.room) chosen[at(count++)] = lever;
  };
  // One side after the other: an even number, and the deepest has a place when there are few.
  const int sides = group.room - group.room % 2;
  for (int side = 0; side < sides; ++side) {
    const Eigen::Vector2d& to = directions_[at(sides)][at(side)];
    double most = 0.0;
    std::size_t best = levers_.size();
    for (std::size_t i = 0; i < levers_.size(); ++i) {
      const double moment = levers_[i].depth * (to.x() * levers_[i].x + to.y() * levers_[i].y);
      if (!(moment > most * (1.0 + 1e-9))) continue;
      most = moment;
      best = i;
    }
    if (best < levers_.size()) add(best);
  }
  // The deepest is one of them: if there is no more room, in place of the one that carries least.
  bool is_in = false;
  int least = 0;
  for (int k = 0; k < count; ++k) {
    const Lever& known = levers_[chosen[at(k)]];
    is_in = is_in || known.depth >= levers_[deepest].depth * (1.0 - kEqual);
    if (known.depth < levers_[chosen[at(least)]].depth) least = k;
  }
  if (!is_in && count < group.room) {
    add(deepest);
  } else if (!is_in) {
    chosen[at(least)] = deepest;
  }
  for (int k = 0; k < count; ++k) {
    const Penetration& p = found_[at(levers_[chosen[at(k)]].point)];
    const bool of_a = p.kind == CrossingPoint::kVertexA || p.kind == CrossingPoint::kEdgeA;
    ManifoldPoint& point = manifold.point[at(manifold.count++)];
    point.position = to_frame * (p.point + (of_a ? 0.5 : -0.5) * p.depth * p.normal);
    point.normal = to_frame.linear() * p.normal;
    point.depth = p.depth;
    point.feature = feature_of(p);
  }
}

}  // namespace twinbus::geometry
