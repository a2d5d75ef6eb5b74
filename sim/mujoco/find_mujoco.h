// Where MuJoCo's library may be on this machine.

#pragma once

#include <string>
#include <vector>

namespace twinbus::inline sim {

// Files to try, best first; of several in one folder the newest first.  $TWINBUS_MUJOCO, where it is set, is the only place.
// Throws std::runtime_error if it names nothing.
std::vector<std::string> mujoco_files();

}  // namespace twinbus::sim
