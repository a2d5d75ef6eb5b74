// What an operator says to a robot that is to walk: a velocity, or footsteps from a file.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int walk_command(const std::vector<std::string>& words);

}  // namespace twinbus
