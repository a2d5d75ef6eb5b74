// `twinbus up`: starts and supervises a stack, gives the source its first activation, shows it, judges it, stops it.

#pragma once

#include <string>
#include <vector>

namespace twinbus {

int up_command(const std::vector<std::string>& words);

}  // namespace twinbus
