// What the vendor's motion service (motion_switcher) answers on a robot whose own motion control is off: released.
//
// Programs for low-level control ask CheckMode until the name is empty and call ReleaseMode before they write LowCmd.

#pragma once

#include <cstdint>
#include <string_view>

namespace twinbus::inline bridge {

struct ServiceAnswer {
  std::int32_t code = 0;  // 0 done
  const char* data = "";  // JSON
};

// parameter: JSON, from outside; only SelectMode would use it, and is refused: there is no motion control of the vendor here.
ServiceAnswer motion_service(std::int64_t api_id, std::string_view parameter) noexcept;

}  // namespace twinbus::bridge
