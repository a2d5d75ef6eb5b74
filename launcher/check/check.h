// `twinbus check ROBOT`: a robot's folder, or a URDF alone, with every check; what is suspicious in
// it, what it lacks, and a proposed robot.yaml.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int check_command(const std::vector<std::string>& words);

}  // namespace twinbus
