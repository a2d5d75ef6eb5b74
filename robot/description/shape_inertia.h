// An inertia for links whose description has none: that of a solid box around their geometry.
//
// robot.yaml names such links under inertia_from_shape; nothing is replaced that is not named.

#pragma once

#include "robot/description/model.h"

namespace twinbus::inline robot {

// No mass, or a moment that is none: such a link cannot be simulated.
bool lacks_inertia(const Link& link);

// The link's mass stays, if it has one; without mass it weighs 10 g and its centre is that of its
// geometry.  Without geometry it is a ball of water.
void take_inertia_from_shape(Link& link);

}  // namespace twinbus::robot
