// The options of a command that speaks on the bus.

#pragma once

#include <utility>
#include <vector>

#include "common/process/arguments.h"

namespace twinbus {

// Its own, then --prefix, --url and --allow.
inline std::vector<OptionSpec> on_bus(std::vector<OptionSpec> own = {}) {
  for (OptionSpec option : {prefix_option(), url_option(), allow_option()}) own.push_back(std::move(option));
  return own;
}

}  // namespace twinbus
