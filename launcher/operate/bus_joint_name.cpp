#include "launcher/operate/bus_joint_name.h"

#include <exception>

#include "common/math/index.h"
#include "launcher/stack/asked_robot.h"
#include "robot/description/load.h"

namespace twinbus::inline launcher {

std::string bus_joint_name(const std::string& robot, std::int64_t model_hash, std::size_t index) {
  try {
    const Model model = load_robot(asked_robot(robot));
    if (model.hash == model_hash && index < model.bus_joints.size()) return model.joints[at(model.bus_joints[index])].name;
  } catch (const std::exception&) {
    // The number is still true.
  }
  return "joint " + std::to_string(index) + " on the bus (--robot names it)";
}

}  // namespace twinbus::launcher
