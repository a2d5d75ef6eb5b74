// `twinbus check ROBOT`: loads a robot's folder with all its checks and prints what came out.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int check_command(const std::vector<std::string>& words);

}  // namespace twinbus
