// Why the planner found no way, in words: `reach`, the gamepad and the planner's own report say the same.

#pragma once

#include <string>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// a, b: what touches, of kStartInCollision and kGoalInCollision; miss: of kUnreachable [m]; oriented: the goal says how the hand
// is turned.  Empty of a path that was found.
std::string plan_refusal(ArmPathStatus status, const std::string& a, const std::string& b, double miss, bool oriented);

}  // namespace twinbus::lcmtypes
