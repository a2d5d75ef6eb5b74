// robot.yaml and SRDF for a robot that has none: a beginning that stands, to be corrected by people.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/anatomy.h"
#include "robot/model.h"

namespace twinbus {

struct Proposal {
  std::string yaml, srdf;
  std::vector<std::string> doubts;  // what people must look at
};

// model: as load_urdf made it.  urdf_name: file name beside robot.yaml.  packages: name and folder.
Proposal propose(const Model& model, const std::string& urdf_name,
                 const std::vector<std::pair<std::string, std::string>>& packages);

// Folders of the package:// names that a URDF mentions, looked for above the file: the nearest
// folder of that name, or one that has it.
std::vector<std::pair<std::string, std::string>> find_packages(const std::string& urdf_file);

}  // namespace twinbus
