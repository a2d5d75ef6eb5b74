#include "launcher/stack/asked_robot.h"

#include <exception>

#include "launcher/stack/run_folder.h"

namespace twinbus::inline launcher {

std::string asked_robot(const std::string& asked) {
  if (!asked.empty()) return asked;
  try {
    const std::string running = first_line_of(running_folder() + "/setup/" + kRunningRobot);
    if (!running.empty()) return running;
  } catch (const std::exception&) {
    // No stack, several, or one that was started elsewhere.
  }
  return "hrp1s";
}

std::string asked_robot(const Arguments& arguments) { return asked_robot(arguments.text("--robot", "")); }

}  // namespace twinbus::launcher
