// What an EVENT says, for programs: its `code`, 0 where only people are told.

#pragma once

#include <cstdint>

namespace twinbus::inline lcmtypes {

inline constexpr std::int16_t kArmPathRefused = 1;  // by the controller: an ARM_PATH is not followed, and why
inline constexpr std::int16_t kArmGoalRefused = 2;  // by the planner: there is no path to an ARM_GOAL, and why

}  // namespace twinbus::lcmtypes
