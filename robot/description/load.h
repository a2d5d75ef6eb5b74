// A robot's folder (URDF, SRDF, robot.yaml) -> Model.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// name_or_folder: a folder, or the name of one under config/robots of the installation
// ($TWINBUS_CONFIG or the source tree).  Throws std::runtime_error with one sentence naming file,
// line or element and the remedy.
Model load_robot(const std::string& name_or_folder);

// The same of texts that are not files yet.  folder: what the names of meshes are relative to.
struct RobotTexts {
  std::string folder, yaml, urdf, srdf;
};
Model load_robot_texts(const RobotTexts& texts);

// A URDF file alone, without robot.yaml: no soles, hands, gains or poses; timing as by default.
// packages: name and folder of what package:// may name.  Throws as above.
Model load_urdf(const std::string& urdf_file,
                const std::vector<std::pair<std::string, std::string>>& packages,
                bool floating_base = true);

// What a URDF needs before a robot can be simulated, in the words of robot.yaml.
struct UrdfRepairs {
  std::vector<std::string> fixed_joints;        // nothing behind them has mass, or they are to be fixed
  std::vector<std::string> inertia_from_shape;  // links without mass or inertia
};

// As load_urdf, of a URDF that is already read, and for a robot.yaml that is still to be proposed:
// repairs are made and said instead of refusing the file, and there may be more joints than the bus
// carries.  repairs: fixed_joints that are there already are fixed too.  file: for messages and relative names.
Model load_repaired_urdf(const std::string& text, const std::string& file,
                         const std::vector<std::pair<std::string, std::string>>& packages,
                         UrdfRepairs& repairs);

// The folder that name_or_folder means; throws when there is none.
std::string robot_folder(const std::string& name_or_folder);

// Folder of the installed configuration: robots/, scenes/, stacks/.  $TWINBUS_CONFIG wins.
std::string config_folder();

}  // namespace twinbus::robot
