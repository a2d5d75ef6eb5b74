// The robot that a command speaks of.

#pragma once

#include <string>

#include "common/process/arguments.h"

namespace twinbus::inline launcher {

// Name or folder: what --robot says; else the one that the only running `up` was started with; else hrp1s.  Who loads it compares its hash
// with that of the robot on the bus.  Does not throw.
std::string asked_robot(const Arguments& arguments);

// The same without a command line; asked: empty where nobody was.
std::string asked_robot(const std::string& asked);

}  // namespace twinbus::launcher
