// The program as its user types it: ./twinbus in the source tree, twinbus where it is installed.
//
// Texts are written with ./twinbus; whoever shows them to a user sends them through here.

#pragma once

#include <cstdio>
#include <string>

namespace twinbus::inline common {

// The text with every ./twinbus as it is typed here, or where it is installed or not.
std::string as_typed(std::string text);
std::string as_typed(std::string text, bool installed);

// std::fprintf, as typed.
__attribute__((format(printf, 2, 3))) void print_typed(std::FILE* to, const char* format, ...);

}  // namespace twinbus::common
