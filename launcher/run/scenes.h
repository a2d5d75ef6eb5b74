// `./twinbus scenes`: the scenes that there are and what happens in each.

#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.h"

namespace twinbus {

// What a scene is about, as `scenes` groups them.
const char* scene_group(const Scene& scene);

int scenes_command(const std::vector<std::string>& words);

}  // namespace twinbus
