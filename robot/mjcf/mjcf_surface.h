// What geoms are to each other where they touch, as MuJoCo puts it together of both or a <pair> says it.

#pragma once

#include "robot/mjcf/mjcf_model.h"

namespace twinbus::inline robot {

// Of a geom, its defaults applied.
MjcfSurface read_mjcf_surface(const MjcfElement& element);

// That with the higher priority; of equal ones the larger friction and condim, and solref and solimp weighted by solmix.
MjcfSurface touching(const MjcfSurface& a, const MjcfSurface& b);

// Of a <pair>, its defaults applied; what it does not say is MuJoCo's default, whatever its geoms say.
MjcfSurface read_mjcf_pair(const MjcfElement& element);

}  // namespace twinbus::robot
