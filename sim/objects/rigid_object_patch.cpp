// Loose bodies with contact patch: the areas that press, found where the bodies will be at the end of the step and set back
// to its start.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/math/index.h"
#include "geometry/bounds/convex_hull.h"
#include "sim/contact/ground_contacts.h"
#include "geometry/mesh_contact/hull_overlap.h"
#include "sim/objects/rigid_object_contacts.h"
#include "sim/objects/rigid_object_mesh.h"

namespace twinbus::inline sim {

namespace {

constexpr double kDeeper = 1.5;     // than the constraint says, at most, is what touches
constexpr double kSlack = 1e-4;     // [m]
constexpr double kAnyDepth = 10.0;  // all below the top of a tile is in it [m]

Eigen::Isometry3d placed_at(const Eigen::Matrix3d& rotation,
                            const Eigen::Vector3d& middle) noexcept {
  Eigen::Isometry3d pose;
  pose.linear() = rotation;
  pose.translation() = middle;
  return pose;
}

}  // namespace

double mean_face(const Solid& solid, const ContactMesh* mesh) {
  Eigen::Vector3d size = solid.size;
  if (mesh != nullptr) {
    size = mesh->box().sizes();
  } else if (solid.shape == SolidShape::kSphere) {
    size.setConstant(2.0 * solid.size.x());
  } else if (solid.shape != SolidShape::kBox) {
    const double caps = solid.shape == SolidShape::kCapsule ? 2.0 * solid.size.x() : 0.0;
    size = {2.0 * solid.size.x(), 2.0 * solid.size.x(), solid.size.y() + caps};
  }
  return (size.x() * size.y() + size.y() * size.z() + size.z() * size.x()) / 3.0;
}

// A slab as high as kSoleSkin, with the sole's own springs.
void LooseContacts::give_sole_mesh(const Sole& sole, Piece& piece) const {
  std::vector<Eigen::Vector3d> points;
  for (int corner = 0; corner < kSoleCorners; ++corner) {
    points.push_back(sole_corner(sole, corner));
    points.push_back(points.back() + kSoleSkin * Eigen::Vector3d::UnitZ());
  }
  const TriangleMesh slab = convex_hull(points);
  if (slab.triangles.empty()) return;
  piece.mesh = std::make_shared<const ContactMesh>(slab);
  piece.box_middle = piece.mesh->box().center();
  piece.box_half = 0.5 * piece.mesh->box().sizes();
  piece.per_area = kSoleCorners / ((sole.front + sole.back) * (sole.left + sole.right));
}

// What of a foot is above its sole.
void LooseContacts::give_foot_mesh(const Model& model, Piece& piece) const {
  std::vector<Eigen::Vector3d> points = mesh_of(piece.solid)->vertices();
  for (const Sole& sole : model.soles) {
    if (sole.link != piece.link) continue;
    const Eigen::Isometry3d in_sole = sole.frame.inverse() * piece.in_link;
    for (Eigen::Vector3d& point : points) {
      Eigen::Vector3d p = in_sole * point;
      p.z() = std::max(p.z(), kSoleSkin);
      point = in_sole.inverse() * p;
    }
  }
  const TriangleMesh hull = convex_hull(points);
  if (hull.triangles.empty()) return;
  piece.mesh = std::make_shared<const ContactMesh>(hull);
  piece.box_half.setZero();  // it may be none any more
}

// The axis of a box nearest to the sole's up.
Eigen::Vector3d LooseContacts::up_from(const Piece& box, const Eigen::Vector3d& up) noexcept {
  Eigen::Index axis = 0;
  const Eigen::Vector3d along = box.rotation.transpose() * up;
  along.cwiseAbs().maxCoeff(&axis);
  return along[axis] < 0.0 ? Eigen::Vector3d(-box.rotation.col(axis))
                           : Eigen::Vector3d(box.rotation.col(axis));
}

// Where it will be, or is.
Eigen::Isometry3d LooseContacts::pose_at(const Piece& piece, const Search& search,
                                         bool ahead) const noexcept {
  return ahead ? end_of(piece, search) : placed_at(piece.rotation, piece.center);
}

bool LooseContacts::box_constraint(const Piece& a, const Piece& b, const Search& search, bool ahead,
                                   Eigen::Vector3d& normal, double& depth) const noexcept {
  Eigen::Isometry3d end_a = pose_at(a, search, ahead), end_b = pose_at(b, search, ahead);
  end_a.translation() += end_a.linear() * a.box_middle;
  end_b.translation() += end_b.linear() * b.box_middle;
  if (a.sole >= 0 || b.sole >= 0) {
    normal = a.sole >= 0 ? up_from(b, a.rotation.col(2))
                         : Eigen::Vector3d(-up_from(a, b.rotation.col(2)));
    depth = normal.dot(end_b.translation() - end_a.translation()) +
            (end_a.linear().transpose() * normal).cwiseAbs().dot(a.box_half) +
            (end_b.linear().transpose() * normal).cwiseAbs().dot(b.box_half);
    if (depth <= kSoleSkin) return depth > 0.0;
  }
  const BoxOverlap overlap = box_overlap(end_a, a.box_half, end_b, b.box_half);
  normal = overlap.normal;
  depth = overlap.depth;
  return depth > 0.0;
}

bool LooseContacts::meet_patch(std::size_t own, int other, Search& search) noexcept {
  const Piece& a = pieces_[own];
  if (other >= 0 && pieces_[at(other)].ball && !a.ball)
    return meet_patch(at(other), static_cast<int>(own), search);
  bool round = a.ball;  // a cap in closed form
  if (other >= 0 && !pieces_[at(other)].tile && !pieces_[at(other)].ball) {
    const Piece& b = pieces_[at(other)];
    const bool closed_form = b.box_half.x() > 0.0 && (a.ball || a.box_half.x() > 0.0);
    if (!closed_form && !(a.hull && b.hull)) return false;
    round = round && closed_form;
  }
  // What presses will press at the end of the step; what only does now may still have to, if something holds it.
  for (const bool ahead : {true, false}) {
    Patch patch;
    if (!(round ? ball_presses(own, other, search, ahead, patch)
                 : presses(own, other, search, ahead, patch)))
      continue;
    press(patch, own, other, ahead, round, search);
    break;
  }
  return true;
}

bool LooseContacts::presses(std::size_t own, int other, const Search& search, bool ahead,
                            Patch& patch) noexcept {
  const Piece& a = pieces_[own];
  const Eigen::Isometry3d pose = pose_at(a, search, ahead);
  if (other < 0) return patch_finder_.with_ground(*a.mesh, pose, patch);
  const Piece& b = pieces_[at(other)];
  Eigen::Vector3d normal = b.rotation.col(2);
  double depth = kAnyDepth;
  if (!b.tile && a.box_half.x() > 0.0 && b.box_half.x() > 0.0) {
    if (!box_constraint(a, b, search, ahead, normal, depth)) return false;
  } else if (!b.tile) {
    const HullOverlap overlap = hull_overlap(*a.mesh, pose, *b.mesh, pose_at(b, search, ahead));
    if (!(overlap.depth > 0.0)) return false;
    normal = overlap.normal;
    depth = overlap.depth;
  }
  return patch_finder_.between(*a.mesh, pose, *b.mesh, pose_at(b, search, ahead), normal,
                               kDeeper * depth + kSlack, patch);
}

// Of a ball the area is round: a cap of volume pi d^2 (r - d / 3) over a plane, of two balls about pi d^2 / (1 / r + 1 / s).
// It rolls on one point that carries that.
bool LooseContacts::ball_presses(std::size_t own, int other, const Search& search, bool ahead,
                                 Patch& patch) const noexcept {
  const Piece& a = pieces_[own];
  const Piece* b = other >= 0 ? &pieces_[at(other)] : nullptr;
  const double radius = a.solid.size.x();
  const Eigen::Vector3d centre = pose_at(a, search, ahead).translation();
  Distance away{centre.z(), Eigen::Vector3d::UnitZ()};
  double other_radius = std::numeric_limits<double>::infinity();
  if (b != nullptr && b->tile) {
    const Eigen::Vector3d inside = b->rotation.transpose() * (centre - b->center);
    const bool over = std::abs(inside.x()) <= 0.5 * b->solid.size.x() &&
                      std::abs(inside.y()) <= 0.5 * b->solid.size.y();
    if (!over) return false;
    away = {inside.z() - 0.5 * b->solid.size.z(), b->rotation.col(2)};
  } else if (b != nullptr) {
    Solid solid = b->solid;
    Eigen::Isometry3d end = pose_at(*b, search, ahead);
    if (b->box_half.x() > 0.0) {
      solid = {SolidShape::kBox, 2.0 * b->box_half};
      end.translation() += end.linear() * b->box_middle;
    }
    away = distance_to(solid, end.linear().transpose() * (centre - end.translation()));
    away.normal = end.linear() * away.normal;
    if (solid.shape == SolidShape::kSphere) other_radius = solid.size.x();
  }
  const double depth = radius - away.value;
  if (!(depth > 0.0)) return false;
  patch = ball_patch(radius, other_radius, centre, depth, away.normal);
  return true;
}

void LooseContacts::press(const Patch& patch, std::size_t own, int other, bool ahead, bool round,
                          Search& search) noexcept {
  const Piece& a = pieces_[own];
  const Piece* b = other >= 0 ? &pieces_[at(other)] : nullptr;
  const double h = ahead ? search.h : 0.0;
  const Eigen::Isometry3d back =
      placed_at(a.rotation, a.center) * pose_at(a, search, ahead).inverse(Eigen::Isometry);
  const ContactParams by_area = times(a.params, a.per_area);
  const int points = round ? 1 : Patch::kPoints;
  Contact found;
  found.params = times(
      b != nullptr ? together(by_area, times(b->params, b->per_area)) : together(by_area, ground_),
      patch.area / points);
  found.stored = 0.5 * found.params.stiffness / patch.area * patch.rough;
  found.system = a.system;
  found.link = a.link;
  found.sole = b != nullptr ? std::max(a.sole, b->sole) : a.sole;
  found.other_system = b != nullptr ? b->system : -1;
  found.other = b != nullptr && b->system >= 0 ? b->link : -1;
  found.normal = patch.normal;
  const ArticulatedBody& body = *search.systems[at(a.system)];
  const int pair = static_cast<int>(own) * (static_cast<int>(pieces_.size()) + 1) + other + 1;
  for (int i = 0; i < points; ++i) {
    const PatchPoint& point = patch.point[at(i)];
    found.point = back * point.position;
    if (round)
      found.point =
          point.position - h * at_point(body.velocity(a.link), a.center - body.origin());
    Eigen::Vector3d v = at_point(body.velocity(a.link), found.point - body.origin());
    if (found.other_system >= 0) {
      const ArticulatedBody& against = *search.systems[at(found.other_system)];
      v -= at_point(against.velocity(found.other), found.point - against.origin());
    }
    found.depth = point.depth + h * found.normal.dot(v);
    found.key = kFirstMeshKey + pair * kMeshKeysPerPair + i;
    consider(found, search);
  }
}

}  // namespace twinbus::sim
