// What a plan says to people.

#include <string>

#include "common/text/formatted.h"
#include "planner/arm_planner.h"

namespace twinbus {

std::string describe(const ArmPlan& plan) {
  const auto name = [&](std::size_t i) { return std::string(plan.touching[i].data()); };
  switch (plan.status) {
    case ArmPathStatus::kOk:
      if (!(plan.clearance > 0.0)) {
        return formatted("arm path of %.2f s, %zu knots, that begins by taking what is held off what it stands on",
                         plan.duration(), plan.path.size());
      }
      return formatted("arm path of %.2f s, %zu knots, %.0f mm clear of itself, %.0f mm of obstacles%s", plan.duration(),
                       plan.path.size(), 1e3 * plan.clearance, 1e3 * (plan.clearance + plan.padding),
                       plan.rounds == 0 ? ", straight" : ", around an obstacle");
    case ArmPathStatus::kUnreachable:
      return formatted("out of reach by %.3f m: move the goal nearer%s", plan.miss,
                       plan.oriented ? " or give up its orientation" : "");
    case ArmPathStatus::kStartInCollision:
      return name(0) + " touches " + name(1) +
             " already: move the arm away with `pose` first";
    case ArmPathStatus::kGoalInCollision:
      return "at the goal " + name(0) + " would touch " + name(1) +
             ": move the goal";
    case ArmPathStatus::kTimeLimit:
      return "no way found to the goal: try a goal on the near side of the obstacle, or two goals "
             "one after the other";
    case ArmPathStatus::kCancelled:
      return "cancelled";
    case ArmPathStatus::kBadGoal:
      break;
  }
  if (plan.heavy != ArmPlan::Heavy::kNo) return plan.complaint + ": try a goal with the arm less stretched, or a pose between";
  return "the goal makes no sense: " + plan.complaint;
}

}  // namespace twinbus
