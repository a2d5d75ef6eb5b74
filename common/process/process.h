// What every main() needs: quit on a signal, real-time priority, random ids, the steady clock.

#pragma once

#include <cstdint>
#include <string>

namespace twinbus::inline common {

// Installs handlers for SIGINT and SIGTERM; a second signal ends the process at once.
void catch_quit_signals();
bool quit_requested() noexcept;

std::int64_t monotonic_ns() noexcept;

// [s] since an instant of monotonic_ns().
inline double seconds_since(std::int64_t start_ns) noexcept {
  return 1e-9 * static_cast<double>(monotonic_ns() - start_ns);
}
std::int64_t wall_us() noexcept;

// Sleeps until the steady clock shows due_ns (clock_nanosleep, absolute).
void sleep_until_ns(std::int64_t due_ns) noexcept;

// What main() returns: the result of run, or 1 after the error that ended it was printed behind the
// program's name.  What run finds about meshes is kept in the user's cache (disk_cache.h).
int run_process(const char* name, int (*run)(int, char**), int argc, char** argv) noexcept;

// Random id, 1 <= id < 2^53.
std::int64_t random_id();

enum class RealTime : std::int8_t { kNone = 0, kFifo = 1, kFifoLocked = 2 };

// FIFO priority, locked memory and CPUs that stay awake, where the system allows them; TWINBUS_FIFO=0 in the environment
// asks for none of it, TWINBUS_CPU_SLEEP=1 lets the CPUs sleep between ticks, which saves power and costs punctuality.
// Threads started later inherit it.  Never fails: the result says what was allowed and why says what
// was not, as one sentence.
RealTime enter_real_time(int priority, std::string* why = nullptr);

// For who only watches the loops but must not lose a message of theirs: behind all of them, ahead of
// programs without real-time priority.  Where that is not allowed, nothing happens.
void go_ahead_of_ordinary_programs() noexcept;

}  // namespace twinbus::common
