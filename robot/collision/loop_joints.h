// What the closed loops of robot.yaml do to the tree of the URDF: links that are pinned to one another, and joints that
// can no longer move one without the other.
//
// Planner, guard and controllers reckon with the tree alone.  They ask here what they must refuse, leave out or say
// before anything moves.  Springs (loops with a length) pin nothing.

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

struct PinnedLinks {
  int a = 0;
  int b = 0;  // -1: the world
};

// Both throw std::runtime_error when a loop names what is neither a link of the robot nor the world.
std::vector<PinnedLinks> pinned_links(const Model& model);
// Those on the way from one end of a pin to the other through the tree; from the base, when it ends at the world.  In
// the model's order.
std::vector<int> joints_in_loops(const Model& model);

// For people: "" without such joints, else their names and what goes on as if they were free.
std::string loops_sentence(const Model& model);
// Prints it, if there is one, behind the program's name on the standard error.
void print_loops(const Model& model, const char* program);

}  // namespace twinbus::robot
