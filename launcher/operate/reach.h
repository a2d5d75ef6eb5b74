// `./twinbus reach left|right X Y Z [R P Y]`: asks for a hand position and watches the arm go
// there.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int reach_command(const std::vector<std::string>& words);

}  // namespace twinbus
