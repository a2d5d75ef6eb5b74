// Boxes that corners alone do not hold apart, and contacts so deep that they may come out behind.

#include <algorithm>
#include <limits>

#include "common/math/index.h"
#include "sim/objects/box_overlap.h"
#include "sim/objects/rigid_object_contacts.h"

namespace twinbus::inline sim {

namespace {
constexpr double kOverlap = 1e-6;  // of boxes, from which their corners are compared with it [m]
constexpr double kCorner = 2.0;    // a corner's depth and the overlap differ by less, or edges cross
constexpr double kFalse = 1e-4;  // so deep and deeper than the boxes overlap, a corner is pushed out the wrong way [m]
constexpr double kFacing = 0.5;   // of a face's normal along a sole's
constexpr double kPassed = 0.8;  // of the way to the middle: it may come through
}  // namespace

// Point by point a corner on the edge of a box could be pushed out sideways.
int LooseContacts::face_between(const Piece& points, const Piece& box) const noexcept {
  if (box.solid.shape != SolidShape::kBox || box.tile || points.probes.size() < 4) return -1;
  const Eigen::Matrix3d turn = box.rotation.transpose() * points.rotation;
  const Eigen::Vector3d middle = box.rotation.transpose() * (points.center - box.center);
  int best = -1;
  double most = -std::numeric_limits<double>::infinity();
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    // A sole is pushed up, however deep it has sunk into something thin.
    if (points.sole >= 0 && sign * turn(axis, 2) < -kFacing) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const Probe& probe : points.probes) {
      if (probe.radius > 0.0) return -1;
      least = std::min(least, sign * (middle[axis] + turn.row(axis).dot(probe.center)));
    }
    const double apart = least - 0.5 * box.solid.size[axis];
    if (!(apart > most)) continue;
    most = apart;
    best = face;
  }
  return best;
}

// A face chosen by all corners of a box at once may be a wrong one for those that are in the other box: a corner that has slid into
// the rim of a thin plate would be pushed out along the plate, through half of it.
void LooseContacts::drop_false(std::size_t before, double overlap, Search& search) noexcept {
  const double most = kFalse + kCorner * std::max(0.0, overlap);
  const auto is_false = [&](const Contact& c) { return c.depth - search.h * c.normal.dot(c.v0) > most; };
  const auto first = search.contacts.begin() + static_cast<std::ptrdiff_t>(before);
  search.contacts.erase(std::remove_if(first, search.contacts.end(), is_false), search.contacts.end());
}

// Corners alone do not see two edges that cross, nor the edge of one below a face of the other: a
// corner that comes in then may be far too deep at once.
void LooseContacts::meet_probes(std::size_t own, std::size_t other, Search& search) noexcept {
  const std::size_t before = search.contacts.size();
  if (pieces_[other].solid_too) meet(pieces_[own], other, false, search);
  if (!pieces_[other].probes.empty())
    meet(pieces_[other], own, pieces_[other].system < 0, search);
  const Piece& a = pieces_[own];
  const Piece& b = pieces_[other];
  if (!is_box(a) || !is_box(b)) return;
  const Eigen::Isometry3d end_a = end_of(a, search), end_b = end_of(b, search);
  const Eigen::Vector3d half_a = 0.5 * a.solid.size, half_b = 0.5 * b.solid.size;
  BoxOverlap overlap = box_overlap(end_a, half_a, end_b, half_b);
  if (!(overlap.depth > kOverlap)) return drop_false(before, overlap.depth, search);
  double deepest = 0.0;
  for (std::size_t i = before; i < search.contacts.size(); ++i) {
    const Contact& c = search.contacts[i];
    deepest = std::max(deepest, c.depth - search.h * c.normal.dot(c.v0));
  }
  if (deepest * kCorner > overlap.depth && deepest < kCorner * overlap.depth) return;
  box_contact(end_a, half_a, end_b, half_b, overlap);
  if (overlap.count == 0) return drop_false(before, overlap.depth, search);
  search.contacts.resize(before);
  meet_boxes(own, other, end_a, overlap, search);
}

bool LooseContacts::is_box(const Piece& piece) noexcept {
  return piece.solid_too && !piece.tile && !piece.of_foot &&
         piece.solid.shape == SolidShape::kBox;
}

// Found where the boxes will be, set back to where they are.  Many points are together no stiffer than four.
void LooseContacts::meet_boxes(std::size_t own, std::size_t other, const Eigen::Isometry3d& end_a,
                               const BoxOverlap& overlap, Search& search) noexcept {
  const Piece& a = pieces_[own];
  const Piece& b = pieces_[other];
  Eigen::Isometry3d pose_a;
  pose_a.linear() = a.rotation;
  pose_a.translation() = a.center;
  const Eigen::Isometry3d back = pose_a * end_a.inverse(Eigen::Isometry);
  Contact found;
  found.params = together(a.params, b.params);
  const double share = std::min(1.0, 4.0 / overlap.count);
  found.params.stiffness *= share;
  found.params.damping *= share;
  found.params.tangent_stiffness *= share;
  found.params.tangent_damping *= share;
  found.system = a.system;
  found.link = a.link;
  found.other_system = b.system;
  found.other = b.system >= 0 ? b.link : -1;
  found.normal = overlap.normal;
  const ArticulatedBody& body = *search.systems[at(a.system)];
  const int pair =
      static_cast<int>(own) * (static_cast<int>(pieces_.size()) + 1) + static_cast<int>(other) + 1;
  for (int i = 0; i < overlap.count; ++i) {
    found.point = back * overlap.point[at(i)];
    Eigen::Vector3d v = at_point(body.velocity(a.link), found.point - body.origin());
    if (b.system >= 0) {
      const ArticulatedBody& against = *search.systems[at(b.system)];
      v -= at_point(against.velocity(b.link), found.point - against.origin());
    }
    found.depth = overlap.deep[at(i)] + search.h * found.normal.dot(v);
    found.key = kFirstMeshKey + pair * kMeshKeysPerPair + BoxOverlap::kMost * overlap.axis + i;
    consider(found, search);
  }
}

bool LooseContacts::may_come_through(const Contact& c, double depth) const noexcept {
  if (!(depth > 0.5 * kPassed * thinnest_) || c.key < kFirstKey) return false;
  int one = -1, other = -1;
  if (c.key >= kFirstMeshKey) {
    const int pair = (c.key - kFirstMeshKey) / kMeshKeysPerPair;
    const int targets = static_cast<int>(pieces_.size()) + 1;
    one = pair / targets;
    other = pair % targets - 1;
  } else {
    const int targets = static_cast<int>(pieces_.size()) + 1;
    const int probe = (c.key - kFirstKey) / targets;
    other = (c.key - kFirstKey) % targets - 1;
    while (one + 1 < static_cast<int>(pieces_.size()) && pieces_[at(one + 1)].first_key <= probe)
      ++one;
  }
  if (one < 0 || other < 0) return false;
  if (continuous_ && c.key < kFirstMeshKey && pieces_[at(other)].solid.shape == SolidShape::kBox) return false;
  return depth > 0.5 * kPassed * (pieces_[at(one)].thickness + pieces_[at(other)].thickness);
}

}  // namespace twinbus::sim
