// The footsteps to come as shapes to be drawn, for FOOTSTEPS: soles as flat boxes, and small spheres along the way of the
// foot in the air; ground frame.

#pragma once

#include "control/walk/walk.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

// walk: null while the robot does not walk; then there are none.
void footstep_shapes(const Model& model, const Estimator& estimator, const Walk* walk,
                     ObstaclesPiece& out) noexcept;

}  // namespace twinbus::control
