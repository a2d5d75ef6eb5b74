// How a source goes through time: SourceStatus::pace, and what a source is configured to.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// kPaused, kSlowed: a simulated world whose clock was asked for something (sim_request_t); kPatient: real time, but for the time
// that it waits for late commands.
enum class Pace : std::int8_t { kRealTime = 1, kLockStep = 2, kFreeRun = 3, kPaused = 4, kSlowed = 5, kPatient = 6 };

inline bool has_pace(const SourceStatus& status, Pace pace) noexcept { return status.pace == static_cast<std::int8_t>(pace); }

}  // namespace twinbus::lcmtypes
