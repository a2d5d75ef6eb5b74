// The footsteps to come as shapes to be drawn, for FOOTSTEPS: soles as flat boxes, and small spheres along the way of the
// foot in the air; ground frame.

#pragma once

#include "control/walk.h"
#include "robot/estimator.h"
#include "robot/model.h"
#include "robot/requests.h"

namespace twinbus {

// walk: null while the robot does not walk; then there are none.
void footstep_shapes(const Model& model, const Estimator& estimator, const Walk* walk,
                     ObstaclesPiece& out) noexcept;

}  // namespace twinbus
