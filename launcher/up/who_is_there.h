// Who is on a bus already and must not be joined by a stack: another source, or what this stack would start a second time.

#pragma once

#include <cstdint>
#include <string>

#include "launcher/bus/stack_monitor.h"
#include "launcher/stack/stack.h"

namespace twinbus::inline launcher {

// A few words for people; empty when the stack may start.  A client of one's own is started before its source, so a
// controller, guard or planner that the stack does not start itself is welcome.
std::string who_is_in_the_way(const StackMonitor& seen, const Stack& stack, std::int64_t now_ns);

}  // namespace twinbus::launcher
