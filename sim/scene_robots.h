// The further robots of a scene, as the world takes them.

#pragma once

#include <vector>

#include "sim/world/other_robot.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

// Throws std::runtime_error for a robot that cannot be loaded or a pose that it has not.
std::vector<OtherRobot> robots_of(const Scene& scene);

}  // namespace twinbus::sim
