#include "planner/joint_turns.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline planner {

namespace {
constexpr double kTurn = 2.0 * M_PI;
}  // namespace

JointTurns::JointTurns(const Model& model, const std::vector<int>& joints, const JointPoint& start)
    : lower(start), upper(start), turns(joints.size(), 0) {
  for (int k = 0; k < start.size(); ++k) {
    const Joint& joint = model.joints[at(joints[at(k)])];
    lower[k] = joint.lower;
    upper[k] = joint.upper;
    if (joint.kind == JointKind::kPrismatic || !(joint.upper - joint.lower > kTurn + 2.0 * kInside)) continue;
    turns[at(k)] = 1;
    const double low = std::clamp(start[k] - 0.5 * kTurn, joint.lower + kInside, joint.upper - kInside - kTurn);
    lower[k] = std::min(low, start[k]);
    upper[k] = std::max(low + kTurn, start[k]);
  }
}

JointPoint JointTurns::within(JointPoint q) const {
  for (int k = 0; k < q.size(); ++k) {
    if (turns[at(k)] == 0) continue;
    q[k] -= kTurn * std::ceil((q[k] - upper[k]) / kTurn);
  }
  return q;
}

void JointTurns::take_in(int k, double q) {
  lower[k] = std::min(lower[k], q);
  upper[k] = std::max(upper[k], q);
}

SearchLimits JointTurns::limits() const {
  SearchLimits limits;
  for (int k = 0; k < lower.size(); ++k) {
    limits.lower.push_back(static_cast<float>(lower[k]));
    limits.upper.push_back(static_cast<float>(upper[k]));
  }
  return limits;
}

}  // namespace twinbus::planner
