#include "lcmtypes/msg/step_list.h"

#include <string>

namespace twinbus::inline lcmtypes {

StepList read_steps(const ConfigNode& node) {
  StepList list;
  int moved = -1;
  for (const ConfigNode& step : node.list("steps")) {
    if (list.count == kMostSteps)
      node.fail("steps", "at most " + std::to_string(kMostSteps) + " of them");
    const int foot = step.choice("foot", {"left", "right"}, -1);
    if (foot < 0) step.fail("foot", "is missing: left or right");
    if (foot == moved) step.fail("foot", "the feet take turns, and this one has just moved");
    if (moved < 0) list.first_foot = foot == 0 ? FootSide::kLeft : FootSide::kRight;
    moved = foot;
    const auto i = static_cast<std::size_t>(list.count++);
    list.x[i] = static_cast<float>(step.number("x", -2.0, 2.0));
    list.y[i] = static_cast<float>(step.number("y", -2.0, 2.0));
    list.yaw[i] = static_cast<float>(step.number("yaw", -3.2, 3.2, 0.0));
    step.finish();
  }
  if (list.count == 0) node.fail("steps", "there is none");
  return list;
}

}  // namespace twinbus::lcmtypes
