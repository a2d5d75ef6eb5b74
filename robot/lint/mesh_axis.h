// Meshes of a robot whose file was written beside a program that turns COLLADA files with Y up to Z up.  URDF takes the numbers
// of a mesh as they are written; some robots' origins were made for the turned mesh, and then feet lie crosswise.

#pragma once

#include <string>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// Files of the meshes that say Y_UP, if the links' centres of mass lie within these meshes clearly better once they are turned
// about x by 90 degrees; empty otherwise.
std::vector<std::string> meshes_to_turn(const Model& model);

// The URDF with that turn in the <origin> of every <visual> and <collision> of these files.
std::string with_turned_meshes(const std::string& urdf_text, const std::vector<std::string>& files);

}  // namespace twinbus::robot
