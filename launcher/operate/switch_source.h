// `twinbus switch`: another source takes the place of the active one, and the operator learns how it went.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int switch_command(const std::vector<std::string>& words);

}  // namespace twinbus
