#include "planner/plan_start.h"

#include <cmath>

namespace twinbus::inline planner {

Configuration plan_start(const Model& model, const Configuration& measured, const RobotState& state,
                         const JointCommand& command) {
  Configuration start = measured;
  if (command.run_id != state.run_id) return start;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    if (std::abs(command.q[k] - state.q[k]) < kServoError) start.q[model.bus_joints[k]] = command.q[k];
  }
  return start;
}

}  // namespace twinbus::planner
