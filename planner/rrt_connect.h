// Two trees that grow towards each other: RRT-Connect (Kuffner and LaValle 2000), with several
// goals.

#pragma once

#include "planner/free_space.h"
#include "planner/random.h"

namespace twinbus {

struct RrtLimits {
  JointPoint lower, upper;  // samples are drawn between them
  double step = 0.4;        // longest edge [rad]
  int max_rounds = 4000;    // each draws one sample
};

struct RrtResult {
  bool found = false;
  JointPath path;  // from start to one of the goals, corners only
  int rounds = 0;
};

// start and goals must be free.  The same random numbers give the same path.  keep_on: asked once
// per round; the search ends without a path when it says false.
RrtResult rrt_connect(FreeSpace& space, const JointPoint& start, const JointPath& goals,
                      const RrtLimits& limits, Random& random, bool (*keep_on)(void*) = nullptr,
                      void* user = nullptr);

}  // namespace twinbus
