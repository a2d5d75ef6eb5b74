// A tie: two points held together, or a distance apart, by a spring and damper that pulls as it
// pushes.  What closes a loop of links, and what a hand has gripped.

#pragma once

#include <Eigen/Core>

namespace twinbus::inline sim {

struct TieEnd {
  int link = -1;                                    // of a robot; -1: not on one
  int loose = -1;                                   // else this loose body; -1: fixed
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in its axes [m]
  int robot = -1;                                   // that has the link; -1: the commanded one
};

struct Tie {
  TieEnd a, b;
  double stiffness = 1e8;  // [N/m]
  double damping = 1e5;    // [N s/m]
  double length = -1.0;    // a spring of this length at rest between them [m]; < 0: no distance
  bool holds = true;       // from the start on
};

}  // namespace twinbus::sim
