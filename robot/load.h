// A robot's folder (URDF, SRDF, robot.yaml) -> Model.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/model.h"

namespace twinbus {

// name_or_folder: a folder, or the name of one under config/robots of the installation
// ($TWINBUS_CONFIG or the source tree).  Throws std::runtime_error with one sentence naming file,
// line or element and the remedy.
Model load_robot(const std::string& name_or_folder);

// A URDF file alone, without robot.yaml: no soles, hands, gains or poses; timing as by default.
// packages: name and folder of what package:// may name.  Throws as above.
Model load_urdf(const std::string& urdf_file,
                const std::vector<std::pair<std::string, std::string>>& packages,
                bool floating_base = true);

// The folder that name_or_folder means; throws when there is none.
std::string robot_folder(const std::string& name_or_folder);

// Folder of the installed configuration: robots/, scenes/, stacks/.  $TWINBUS_CONFIG wins.
std::string config_folder();

}  // namespace twinbus
