// A standby source that runs the same commands as the active one: the shadow twin.

#pragma once

#include <string>

#include "launcher/bus/bus_link.h"
#include "launcher/stack/supervisor.h"

namespace twinbus::inline launcher {

// Asks the source that is this process of the stack for standby shadow until it says so.  True when it does; throws
// std::runtime_error when it does not within 10 s.
bool put_in_shadow(BusLink& bus, const Supervisor& supervisor, const std::string& name);

}  // namespace twinbus::launcher
