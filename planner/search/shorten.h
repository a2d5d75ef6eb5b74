// Makes a path of straight lines shorter: greedy shortcuts, then corners cut, until nothing changes.

#pragma once

#include "planner/search/rrt_connect.h"

namespace twinbus::inline planner {

// The ends stay; every line stays free.
void shorten(LineTest& test, SearchPath& path, int joints);

}  // namespace twinbus::planner
