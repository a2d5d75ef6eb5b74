// Boxes that corners alone do not hold apart, and contacts so deep that they may come out behind.

#include <algorithm>

#include "common/math/index.h"
#include "sim/contact/box_overlap.h"
#include "sim/contact/rigid_object_contacts.h"

namespace twinbus {

namespace {
constexpr double kOverlap = 1e-6;  // of boxes, from which their corners are compared with it [m]
constexpr double kCorner = 2.0;    // a corner's depth and the overlap differ by less, or edges cross
constexpr double kPassed = 0.8;  // of the way to the middle: it may come through
}  // namespace

// Corners alone do not see two edges that cross, nor the edge of one below a face of the other: a
// corner that comes in then may be far too deep at once.
void LooseContacts::meet_probes(std::size_t own, std::size_t other, Search& search) noexcept {
  const std::size_t before = search.contacts.size();
  if (pieces_[other].solid_too) meet(pieces_[own], other, false, search);
  if (!pieces_[other].probes.empty())
    meet(pieces_[other], own, pieces_[other].system < 0, search);
  const double deep = overlap(pieces_[own], pieces_[other], search);
  if (!(deep > kOverlap)) return;
  double deepest = 0.0;
  for (std::size_t i = before; i < search.contacts.size(); ++i) {
    const Contact& c = search.contacts[i];
    deepest = std::max(deepest, c.depth - search.h * c.normal.dot(c.v0));
  }
  if (deepest * kCorner > deep && deepest < kCorner * deep) return;
  search.contacts.resize(before);
  meet_mesh(own, static_cast<int>(other), search);
}

double LooseContacts::overlap(const Piece& a, const Piece& b,
                              const Search& search) const noexcept {
  const auto is_box = [](const Piece& piece) {
    return piece.solid_too && !piece.tile && !piece.of_foot &&
           piece.solid.shape == SolidShape::kBox && piece.mesh != nullptr;
  };
  if (!is_box(a) || !is_box(b)) return 0.0;
  return box_overlap(end_of(a, search), 0.5 * a.solid.size, end_of(b, search),
                     0.5 * b.solid.size);
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
  return depth > 0.5 * kPassed * (pieces_[at(one)].thickness + pieces_[at(other)].thickness);
}

}  // namespace twinbus
