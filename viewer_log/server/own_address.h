// An address of this machine that others may reach.

#pragma once

#include <string>

namespace twinbus::inline viewer_log {

// As it is written in a URL; the loopback address if there is none.
std::string address_for_others(bool v6);

}  // namespace twinbus::viewer_log
