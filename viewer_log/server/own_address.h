// An address of this machine that others may reach.

#pragma once

#include <string>

namespace twinbus {

// As it is written in a URL; the loopback address if there is none.
std::string address_for_others(bool v6);

}  // namespace twinbus
