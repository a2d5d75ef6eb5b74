// What somebody else's program does with the installed libraries: one thing of each.

#include <cstdio>
#include <exception>

#include "lcmtypes/bus/channels.h"
#include "planner/arm_planner.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"
#include "twinbus/robot_state_t.hpp"

int main() try {
  const twinbus::Model model = twinbus::load_robot("hrp1s");
  twinbus::Kinematics kinematics(model);
  const twinbus::Scene scene = twinbus::load_scene("stand");
  const twinbus::ArmPlanner planner(model);
  const twinbus::robot_state_t message{};
  std::printf("%.1f kg, scene of %.0f s, %s has %d bytes\n%s\n", kinematics.mass(), scene.duration, twinbus::channel::kState.name,
              message.getEncodedSize(), twinbus::config_folder().c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "outside: %s\n", error.what());
  return 1;
}
