// How fast a robot walks, up how steep a slope and pushed how hard, by walking in the simulator with the guard on, and which
// gait suits its body.

#pragma once

#include <string>

#include "robot/description/model.h"

namespace twinbus::inline launcher {

// The most with which it walks, and what ends it above that, in words; empty: it walks with the most that is tried.
struct WalkBound {
  double most = 0.0;
  std::string why;
};

struct WalkTrial {
  std::string why_not;    // why it does not walk; empty: it does
  double leg = 0.0;       // hip to ground, straight [m]
  double fastest = 0.0;   // kShare of the largest that walked for 10 s [m/s]
  double step = 0.0;      // length of a step then [m]
  std::string limit;      // what ends it above that, in words
  // At half of `fastest`: how steep a slope it walks up [degrees]; pushed forward and to the left, through its base within 0.1 s, by
  // what change of its velocity [m/s] it does not fall.
  WalkBound slope_deg, push, push_aside;
  std::string walking;    // entries of the map `walking` of robot.yaml that the search found, and `fastest`
  bool trots = false;     // on four point feet; on two, it walks
  int runs = 0;
  double cpu_s = 0.0;     // that all walks took [s]
};

// Four-legged robots trot, with one gait.  Others:
// Walks forward at speeds found by bisection (5 s each), tries other gaits (step time, place of the zero-moment point, height),
// walks 10 s with the better of the two and takes 85 % of that.  The robot's robot.yaml must have no `walking` of its own.
// Tries nothing more after `patience` [s] of the processor's time; slopes and pushes take up to 4 s more.
WalkTrial find_walk(const Model& model, double patience);

}  // namespace twinbus::launcher
