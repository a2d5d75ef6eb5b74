// The reason of the stop that a source draws itself when its robot lies.

#pragma once

#include "lcmtypes/msg/requests.h"

namespace twinbus {

inline constexpr StopReason kStopFallen = static_cast<StopReason>(10);  // as stop_t has it

}  // namespace twinbus
