// Makes a path of straight lines shorter by cutting corners that are not needed.

#pragma once

#include "planner/free_space.h"
#include "planner/random.h"

namespace twinbus {

double length_of(const JointPath& path);  // [rad]

// Tries `rounds` random cuts and then every corner once; the ends stay, and every line stays free.
void shortcut(FreeSpace& space, JointPath& path, int rounds, Random& random);

}  // namespace twinbus
