// The file into which a command of `log` writes: never the log that it reads, and none that is there unless --force says so.

#pragma once

#include <string>

#include "common/process/arguments.h"

namespace twinbus::inline launcher {

// The second word of the command, where in is what it reads.  Throws UsageError when both are one file, std::runtime_error
// when a file of that name, or a part of a log of that name, is there and --force was not given.
std::string log_output(const Arguments& arguments, const std::string& in);

// Throws UsageError when out is the file in, by this name or another.
void refuse_same_file(const std::string& in, const std::string& out);

}  // namespace twinbus::launcher
