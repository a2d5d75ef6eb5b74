// What only a simulator knows of its robot: the pose of the base, contacts, zero-moment point.

#pragma once

#include "robot/model.h"
#include "robot/requests.h"
#include "sim/world.h"

namespace twinbus {

// standing_height: of the base when the run began [m]; half of it, or a tilt of 60 degrees, counts
// as fallen.
void fill_truth(const Model& model, const World& world, double standing_height,
                SimTruth& truth) noexcept;

// Distance [m] of a ground point to the edge of the convex hull of points, positive inside.  count
// <= 8.
double hull_margin(const Eigen::Vector2d* points, int count, const Eigen::Vector2d& point) noexcept;

}  // namespace twinbus
