// What a plan says to people.

#include <string>

#include "common/text/formatted.h"
#include "lcmtypes/msg/plan_refusal.h"
#include "planner/arm_planner.h"

namespace twinbus::inline planner {

std::string describe(const ArmPlan& plan) {
  if (plan.status == ArmPathStatus::kOk) {
    if (!(plan.clearance > 0.0)) {
      return formatted("arm path of %.2f s, %zu knots, that begins by taking what is held off what it stands on",
                       plan.duration(), plan.path.size());
    }
    return formatted("arm path of %.2f s, %zu knots, %.0f mm clear of itself, %.0f mm of obstacles%s", plan.duration(),
                     plan.path.size(), 1e3 * plan.clearance, 1e3 * (plan.clearance + plan.padding),
                     plan.rounds == 0 ? ", straight" : ", around an obstacle");
  }
  if (plan.heavy != ArmPlan::Heavy::kNo) return plan.complaint + ": try a goal with the arm less stretched, or a pose between";
  const std::string why =
      plan_refusal(plan.status, plan.touching[0].data(), plan.touching[1].data(), plan.miss, plan.oriented);
  return plan.status == ArmPathStatus::kBadGoal ? why + ": " + plan.complaint : why;
}

}  // namespace twinbus::planner
