// A path of straight lines with its corners rounded, so that it can be followed without stopping at
// them.
//
// A corner p is replaced by the quadratic Bezier curve from p - d u to p + d v (u, v: unit
// directions before and after), with the curve parameter running over a length of 2 d.  Then q(s)
// has a continuous derivative of length 1 on lines and at most 1 on curves.

#pragma once

#include <vector>

#include "planner/search/free_space.h"

namespace twinbus::inline planner {

class RoundedPath {
 public:
  // Rounds every corner as widely as free space allows, at most `widest` [rad] from the corner.  A
  // corner that cannot be rounded cuts the path: parts() returns pieces that meet at rest.
  static std::vector<RoundedPath> parts(FreeSpace& space, const JointPath& corners, double widest);

  double length() const { return starts_.back(); }
  const std::vector<double>& seams() const { return starts_; }  // s between pieces, both ends too
  // Position, and its first and second derivative by s, at 0 <= s <= length().
  void at(double s, JointPoint& q, JointPoint& dq, JointPoint& ddq) const;

 private:
  struct Piece {
    JointPoint from, corner, to;  // a line has its corner in the middle
  };
  void add(const JointPoint& from, const JointPoint& corner, const JointPoint& to, double length);

  std::vector<Piece> pieces_;
  std::vector<double> starts_{0.0};  // s where each piece starts, and the end
};

}  // namespace twinbus::planner
