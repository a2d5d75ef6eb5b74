// Going through a log, with progress on a terminal and the damage told at the end.

#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "viewer_log/log/log_reader.h"

namespace twinbus::inline launcher {

// Every event from first_s to last_s, in seconds from the first event of the log; visit says false to end early.
// Ctrl-C ends it with a std::runtime_error.  Damage is told on stderr and given back.
LogDamage scan_log(const std::string& file, double first_s, double last_s,
                   const std::function<bool(const LogEvent&)>& visit);

// Of the first event [us]; throws std::runtime_error when there is none.
std::int64_t first_time(LogReader& reader, const std::string& file);

// "3 places of damage, 120 bytes", or empty.
std::string damage_text(const LogDamage& damage);

inline constexpr double kWholeLog = 1e12;  // [s] the last second of a log that is read to its end

}  // namespace twinbus::launcher
