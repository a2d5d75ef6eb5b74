// What the two guards leave between parts of a robot when everything has come to rest: the one in the controller, the guard
// process, and the page, which says which pairs are nearer.

#pragma once

namespace twinbus::inline lcmtypes {

struct GuardDefaults {
  static constexpr double kInController = 0.010;  // [m]
  static constexpr double kAtGoal = 0.012;  // what planners leave at the goal of an arm, so that the guard does not hold it there [m]
  static constexpr double kSecondOpinion = 0.006;  // of the guard process, silent while the other does its work [m]
};

}  // namespace twinbus::lcmtypes
