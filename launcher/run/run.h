// `./twinbus run SCENE`: a scene in one process, without a bus, as fast as it goes; judged by the scene's own
// criteria.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int run_command(const std::vector<std::string>& words);

}  // namespace twinbus
