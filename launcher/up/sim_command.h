// What only a simulated world can do, asked from the command line: a push, pause, single steps, slow motion, reset.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int push_command(const std::vector<std::string>& words);
int sim_command(const std::vector<std::string>& words);

}  // namespace twinbus
