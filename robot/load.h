// A robot's folder (URDF, SRDF, robot.yaml) -> Model.

#pragma once

#include <string>

#include "robot/model.h"

namespace twinbus {

// name_or_folder: a folder, or the name of one under config/robots of the installation
// ($TWINBUS_CONFIG or the source tree).  Throws std::runtime_error with one sentence naming file,
// line or element and the remedy.
Model load_robot(const std::string& name_or_folder);

// Folder of the installed configuration: robots/, scenes/, stacks/.  $TWINBUS_CONFIG wins.
std::string config_folder();

}  // namespace twinbus
