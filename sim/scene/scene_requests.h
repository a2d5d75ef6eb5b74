// What a scene asks of the robot, as whoever speaks for it says it on the bus (bridge/source/scene_script.h).

#pragma once

#include "bridge/source/scene_script.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

SceneRequests requests_of(const Scene& scene);

}  // namespace twinbus::sim
