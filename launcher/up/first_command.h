// Waits until somebody commands the source that `up` has activated.

#pragma once

#include <functional>
#include <string>

#include "launcher/bus/bus_link.h"
#include "launcher/stack/supervisor.h"

namespace twinbus::inline launcher {

struct FirstCommand {
  std::string log;  // of the stack's own controller; empty: the user starts one
  std::function<void(const std::string& line)> say;
};

// Returns when a COMMAND has come or the user ends `up`.  Of the user's own controller, which may come later than the command timeout,
// the stop that its absence had caused is cleared.  Throws std::runtime_error with one sentence when nobody commands (a stack's own
// controller has 10 s, the user 60 s), or a required process ends.
void wait_for_command(BusLink& bus, Supervisor& supervisor, const FirstCommand& first);

}  // namespace twinbus::launcher
