// `./twinbus scenes`: the scenes that there are and what happens in each.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int scenes_command(const std::vector<std::string>& words);

}  // namespace twinbus
