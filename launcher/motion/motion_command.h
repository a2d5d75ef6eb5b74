// The command `motion`: a recorded or designed motion, checked before it plays, and played.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int motion_file_command(const std::vector<std::string>& words);

}  // namespace twinbus
