// `twinbus doctor`: is this machine ready; what is missing, and the command that mends it.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int doctor_command(const std::vector<std::string>& words);

}  // namespace twinbus
