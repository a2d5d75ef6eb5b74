// --url, --prefix and --allow of tools and test programs, without the help and the checks of Options.

#pragma once

#include <stdexcept>
#include <string>

#include "lcmtypes/bus/bus.h"

namespace twinbus {

// Takes the option at argv[i] and moves i past its value.  False if argv[i] is something else; throws std::invalid_argument
// when the value is missing.
inline bool take_bus_option(int argc, char** argv, int& i, BusOptions& options) {
  const std::string name = argv[i];
  if (name != "--url" && name != "--prefix" && name != "--allow") return false;
  if (i + 1 >= argc) throw std::invalid_argument(name + ": needs a value");
  const std::string value = argv[++i];
  if (name == "--allow") options.allow.push_back(value);
  else (name == "--url" ? options.url : options.prefix) = value;
  return true;
}

}  // namespace twinbus
