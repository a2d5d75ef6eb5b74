// The name of a joint that a message counts, for who is told of it.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace twinbus::inline launcher {

// robot: name or folder of it, empty: the one that the running `up` was started with, and if there is none hrp1s.  Where that is
// not the robot of this model hash: "joint 4 on the bus".  Does not throw.
std::string bus_joint_name(const std::string& robot, std::int64_t model_hash, std::size_t index);

}  // namespace twinbus::launcher
