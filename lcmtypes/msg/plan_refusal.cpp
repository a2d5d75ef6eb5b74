#include "lcmtypes/msg/plan_refusal.h"

#include "common/text/formatted.h"

namespace twinbus::inline lcmtypes {

std::string plan_refusal(ArmPathStatus status, const std::string& a, const std::string& b, double miss, bool oriented) {
  switch (status) {
    case ArmPathStatus::kOk:
      return "";
    case ArmPathStatus::kUnreachable:
      return formatted("out of reach by %.3f m: move the goal nearer%s", miss, oriented ? " or give up its orientation" : "");
    case ArmPathStatus::kStartInCollision:
      return a + " touches " + b + " already: move the arm away with `pose` first";
    case ArmPathStatus::kGoalInCollision:
      return "at the goal " + a + " would touch " + b + ": move the goal";
    case ArmPathStatus::kTimeLimit:
      return "no way found to the goal, which does not say that there is none: try a goal on the near side of the obstacle, or two goals one after the other";
    case ArmPathStatus::kCancelled:
      return "cancelled";
    case ArmPathStatus::kBadGoal:
      break;
  }
  return "the goal makes no sense";
}

}  // namespace twinbus::lcmtypes
