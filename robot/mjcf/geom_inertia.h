// Mass and inertia of an MJCF body from its geoms, as MuJoCo's compiler takes them.
//
// A mesh's own are MuJoCo's by its word `inertia`; the default, legacy, adds the volumes of all triangles with the same
// sign, which is more than the body has where it is hollow.

#pragma once

#include "robot/mjcf/mjcf_model.h"

namespace twinbus::inline robot {

// Of a geom in its body; nothing for planes and height fields.  Throws at the geom: a mesh that cannot be read, a kind whose
// inertia is not known here.
MjcfInertia geom_inertia(const MjcfGeom& geom, const MjcfModel& model);

// Two bodies as one.
MjcfInertia sum_of(const MjcfInertia& a, const MjcfInertia& b);

// Of a body as the compiler's settings say: its <inertial>, or its geoms.
MjcfInertia body_inertia(const MjcfBody& body, const MjcfModel& model);

}  // namespace twinbus::robot
