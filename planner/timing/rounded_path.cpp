#include "planner/timing/rounded_path.h"

#include <algorithm>
#include <cstddef>

namespace twinbus::inline planner {

namespace {

constexpr double kNarrowest = 1e-3;  // [rad]; rounder than this or not at all
constexpr int kChords = 8;

JointPoint bezier(const JointPoint& a, const JointPoint& b, const JointPoint& c, double t) {
  return (1.0 - t) * (1.0 - t) * a + 2.0 * t * (1.0 - t) * b + t * t * c;
}

bool curve_free(FreeSpace& space, const JointPoint& a, const JointPoint& b, const JointPoint& c) {
  JointPoint last = a;
  for (int i = 1; i <= kChords; ++i) {
    const JointPoint next = bezier(a, b, c, static_cast<double>(i) / kChords);
    if (!space.line_free(last, next)) return false;
    last = next;
  }
  return true;
}

}  // namespace

void RoundedPath::add(const JointPoint& from, const JointPoint& corner, const JointPoint& to,
                      double length) {
  if (!(length > 1e-9)) return;
  pieces_.push_back({from, corner, to});
  starts_.push_back(starts_.back() + length);
}

std::vector<RoundedPath> RoundedPath::parts(FreeSpace& space, const JointPath& corners,
                                            double widest) {
  std::vector<RoundedPath> parts;
  RoundedPath part;
  JointPoint from = corners.front();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const JointPoint& corner = corners[i];
    const JointPoint before = corner - corners[i - 1];
    const JointPoint after = corners[i + 1] - corner;
    if (!(before.norm() > 1e-9) || !(after.norm() > 1e-9)) continue;
    double width = std::min({widest, 0.5 * before.norm(), 0.5 * after.norm()});
    JointPoint begin = corner;
    JointPoint end = corner;
    bool rounded = false;
    for (; !rounded && width >= kNarrowest; width *= 0.5) {
      begin = corner - width / before.norm() * before;
      end = corner + width / after.norm() * after;
      rounded = curve_free(space, begin, corner, end);
      if (rounded) break;
    }
    if (rounded) {
      part.add(from, 0.5 * (from + begin), begin, (begin - from).norm());
      part.add(begin, corner, end, 2.0 * width);
      from = end;
    } else {
      part.add(from, 0.5 * (from + corner), corner, (corner - from).norm());
      parts.push_back(std::move(part));
      part = RoundedPath();
      from = corner;
    }
  }
  const JointPoint& last = corners.back();
  part.add(from, 0.5 * (from + last), last, (last - from).norm());
  if (!part.pieces_.empty()) parts.push_back(std::move(part));
  return parts;
}

void RoundedPath::at(double s, JointPoint& q, JointPoint& dq, JointPoint& ddq) const {
  const auto next = std::upper_bound(starts_.begin() + 1, starts_.end() - 1, s);
  const auto i = static_cast<std::size_t>(next - starts_.begin()) - 1;
  const Piece& piece = pieces_[i];
  const double length = starts_[i + 1] - starts_[i];
  const double t = std::clamp((s - starts_[i]) / length, 0.0, 1.0);
  q = bezier(piece.from, piece.corner, piece.to, t);
  dq = 2.0 / length * ((1.0 - t) * (piece.corner - piece.from) + t * (piece.to - piece.corner));
  ddq = 2.0 / (length * length) * (piece.from - 2.0 * piece.corner + piece.to);
}

}  // namespace twinbus::planner
