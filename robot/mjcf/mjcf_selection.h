// Which bodies of an MJCF model are the robot.

#pragma once

#include <string>
#include <vector>

#include "robot/mjcf/mjcf_model.h"

namespace twinbus::inline robot {

struct MjcfSelection {
  std::vector<int> bodies;  // parents first
  bool floating = false;    // then bodies[0] is its base
};

// Throws, naming line and reason, when there is none, more than one, or one with a ball joint.  notes gets what is scenery.
MjcfSelection select_robot(const MjcfModel& model, const std::string& file, std::vector<std::string>& notes);

}  // namespace twinbus::robot
