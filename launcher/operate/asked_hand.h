// The arm that the words of a command name.

#pragma once

#include <string>

#include "robot/description/model.h"

namespace twinbus::inline launcher {

// where: the command, or its option, for the error.  Throws UsageError, with the names that there are, for one that the robot does not
// have, and std::runtime_error of a robot without arms.
const Hand& asked_hand(const std::string& where, const Model& model, const std::string& name);

}  // namespace twinbus::launcher
