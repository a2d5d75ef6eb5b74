// Where two links that pass each other closely are proved apart, once per robot: for proofs against meshes without clearance.

#pragma once

#include "planner/batch/robot.h"

namespace twinbus {

// Finds the clear cells of pairs, and drops those that are clear all over.  Tens of milliseconds a pair, seconds where hulls touch
// and thousands of pieces are asked: after sort_pairs.
void find_clear_cells(BlockRobot& robot);

}  // namespace twinbus
