// The local time as part of a name of a file or folder, 2004-09-28-101500.

#pragma once

#include <ctime>
#include <string>

namespace twinbus::inline common {

inline std::string time_name() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  char name[32];
  std::strftime(name, sizeof name, "%Y-%m-%d-%H%M%S", &parts);
  return name;
}

}  // namespace twinbus::common
