// A plan as the numbered pieces that travel on ARM_PATH.

#pragma once

#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "planner/arm_planner.h"

namespace twinbus::inline planner {

struct ArmPathIds {
  std::int64_t planner_id = 0;
  std::int64_t run_id = 0;
  std::int64_t goal_id = 0;
  std::int64_t path_id = 0;
};

// A failed plan is one message with pieces = 0 and the reason.  utime is left 0.
std::vector<ArmPathPiece> to_pieces(const ArmPlan& plan, const ArmPathIds& ids);

}  // namespace twinbus::planner
