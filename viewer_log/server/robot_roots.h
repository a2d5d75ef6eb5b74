// The folders of a robot that the page may read: what its URDF names.

#pragma once

#include <vector>

#include "robot/description/model.h"
#include "viewer_log/server/web_path.h"

namespace twinbus::inline viewer_log {

// "/robot/" is the robot's folder; "/robot/package/NAME/" is what package://NAME/ means: a folder that robot.yaml names, or that of
// the robot for its own name.  Throws std::runtime_error as load_robot for a robot.yaml that is none.
std::vector<WebRoot> robot_roots(const Model& model);

}  // namespace twinbus::viewer_log
