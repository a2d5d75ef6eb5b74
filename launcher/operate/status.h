// `twinbus status`: who is there, at what rate, in which role and term, and how their loops are.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int status_command(const std::vector<std::string>& words);

}  // namespace twinbus
