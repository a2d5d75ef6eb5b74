// `twinbus check ROBOT --cells`: what links with few joints between them can touch with, found once and kept.

#pragma once

#include "robot/description/model.h"

namespace twinbus::inline launcher {

// Prints, with progress on a terminal.  Exit status: 1 when nothing can be kept.
int check_cells(const Model& model);

}  // namespace twinbus::launcher
