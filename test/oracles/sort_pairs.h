// Pairs of links in order of how often they touch in random postures.

#pragma once

#include "planner/batch/robot.h"

namespace twinbus {

// Brings the pairs that touch most often to the front, by random postures.  Drops pairs that have balls alone when these touch
// in all of them.
void sort_pairs(BlockRobot& robot);

}  // namespace twinbus
