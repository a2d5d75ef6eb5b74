// Joints that turn by more than once around show every posture more than once: which of them a plan looks at.

#pragma once

#include <vector>

#include "planner/search/rrt_connect.h"
#include "planner/timing/path_timing.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

constexpr double kInside = 0.01;  // goal postures stay this far inside the joint limits [rad]

struct JointTurns {
  JointTurns() = default;
  // From where each joint is, half a turn to either side as far as its limits allow; one that cannot turn once around: its limits.
  JointTurns(const Model& model, const std::vector<int>& joints, const JointPoint& start);

  // Of the turns of a posture the one in between.
  JointPoint within(JointPoint q) const;
  // What was asked for lies in between, too.
  void take_in(int k, double q);
  SearchLimits limits() const;

  JointPoint lower, upper;
  std::vector<char> turns;  // of each joint: can it turn once around?
};

}  // namespace twinbus::planner
