// The picture that `up` and `status` show: sources, streams and processes with their rates, ages and roles.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "launcher/stack/cpu_share.h"
#include "launcher/bus/stack_monitor.h"

namespace twinbus::inline launcher {

// What somebody has to act on, each with its remedy; nothing while all is well.
std::vector<std::string> acting_lines(const StackMonitor& seen, std::int64_t now_ns);
// At most about 20 lines, each shorter than 100 characters; what has to be acted on and the robot first.
// shares: of the processes of this machine.
std::vector<std::string> table_lines(const StackMonitor& seen, CpuShare& shares, std::int64_t now_ns);
// What has to be acted on, the robot, a line for each source and process.
std::vector<std::string> short_lines(const StackMonitor& seen, CpuShare& shares, std::int64_t now_ns);
// All of it in one line, for a log.
std::string summary_line(const StackMonitor& seen, std::int64_t now_ns);

}  // namespace twinbus::launcher
