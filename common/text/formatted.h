// A std::string written as std::printf writes, as long as it takes.
//
// Allocates: what runs in a loop fills an array with std::snprintf instead.

#pragma once

#include <cstdarg>
#include <string>

namespace twinbus::inline common {

__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...);
__attribute__((format(printf, 1, 0))) std::string formatted_list(const char* format, std::va_list arguments);

}  // namespace twinbus::common
