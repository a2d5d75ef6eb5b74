// A controller: answers each STATE with a COMMAND that swings the left arm out by 0.2 rad and back.
#include <cmath>
#include "lcmtypes/bus/bus.h"
#include "lcmtypes/bus/channels.h"
#include "robot/description/load.h"
using namespace twinbus;

int main() {
  const Model model = load_robot("hrp1s");
  JointCommand command{.controller_id = 20};
  for (int j = 0; j < model.joint_count(); ++j) command.kp[j] = model.joints[j].kp, command.kd[j] = model.joints[j].kd;
  Bus bus({});
  bus.listen(channel::kState, [&, joint = model.find_joint("LARM_SHOULDER_R"), begin = RobotState{}](const RobotState& state) mutable {
    if (begin.tick == 0) begin = state, command.q = state.q, command.tau = state.tau;
    command.tick = state.tick, command.run_id = state.run_id, command.term = state.term;
    command.model_hash = state.model_hash, command.joint_count = state.joint_count;
    command.q[joint] = begin.q[joint] + 0.1 * (1 - std::cos(1.6e-9 * (state.time_ns - begin.time_ns)));
    if (!bus.send(channel::kCommand, command)) std::abort();
  });
  while (bus.receive(1.0) >= 0) {}
}
