// What CONTROLLER_STATUS tells of a tick: mode, estimate, margins, all in the ground frame.

#pragma once

#include "control/loop/modes.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

// Leaves alone what belongs to the inputs (sequences, guard_tick) and to the caller (controller_id,
// compute_ns).
void report_tick(const Modes& modes, const Moment& now, ControllerStatus& status) noexcept;

}  // namespace twinbus::control
