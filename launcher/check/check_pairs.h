// `twinbus check ROBOT --pairs`: which pairs of links need checking, with proof, and which of those
// that the SRDF leaves out can touch after all.

#pragma once

#include <string>

#include "robot/description/model.h"

namespace twinbus::inline launcher {

// Prints; file, when not empty, is the SRDF to write.  Exit status: 1 when the SRDF leaves out a
// pair that touches.
int check_pairs(const Model& model, const std::string& file);

}  // namespace twinbus::launcher
