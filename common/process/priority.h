// What a process may claim of the CPUs, and what it leaves to others.

#pragma once

#include "common/process/process.h"

namespace twinbus::inline common {

// Whether this process may have the FIFO priority of a stack's loops, and so keep a hard clock; TWINBUS_FIFO=0 says no.
bool may_enter_real_time() noexcept;

// For who can wait: gets a small share of CPU time beside ordinary programs.
void give_way() noexcept;

// enter_real_time(), and what was not allowed is printed behind the program's name.
RealTime enter_real_time(int priority, const char* program);
const char* to_text(RealTime real_time) noexcept;

}  // namespace twinbus::common
