// CPU time of the thread that asks.

#pragma once

#include <time.h>

#include <algorithm>
#include <array>

namespace twinbus::inline common {

inline double thread_cpu_seconds() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What lies between two looks at that clock, one right after the other: a microsecond where it is a call of the system [s].
inline double cost_of_thread_clock() noexcept {
  std::array<double, 51> between{};
  for (double& each : between) {
    const double begun = thread_cpu_seconds();
    each = thread_cpu_seconds() - begun;
  }
  std::nth_element(between.begin(), between.begin() + 25, between.end());
  return between[25];
}

}  // namespace twinbus::common
