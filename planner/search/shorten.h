// Makes a path of straight lines shorter: greedy shortcuts, then corners cut, until nothing changes.

#pragma once

#include "planner/search/rrt_connect.h"

namespace twinbus {

struct ShortenOptions {
  int rounds = 5;
  float least_gain = 0.02F;  // a corner whose cut gains less is left [rad]
};

// The ends stay; every line stays free.
void shorten(LineTest& test, SearchPath& path, int joints, const ShortenOptions& options = {});

}  // namespace twinbus
