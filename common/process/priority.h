// What a process may claim of the CPUs, and what it leaves to others.

#pragma once

namespace twinbus {

// Whether this process may have the FIFO priority of a stack's loops, and so keep a hard clock; TWINBUS_FIFO=0 says no.
bool may_enter_real_time() noexcept;

// For who can wait: gets a small share of CPU time beside ordinary programs.
void give_way() noexcept;

}  // namespace twinbus
