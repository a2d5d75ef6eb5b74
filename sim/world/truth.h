// What only a simulator knows of its robot: the pose of the base, contacts, zero-moment point.

#pragma once

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "sim/world/felt_feet.h"
#include "sim/world/step_trust.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// standing_height: of the centre of mass when the run began [m]; half of it, or a tilt of 60 degrees, counts as fallen.
void fill_truth(const Model& model, const FeltFeet& feet, const World& world, double standing_height, SimTruth& truth) noexcept;

// What of its steps is not to be trusted.
void fill_doubts(const TrustCounts& counts, SimTruth& truth) noexcept;

}  // namespace twinbus::sim
