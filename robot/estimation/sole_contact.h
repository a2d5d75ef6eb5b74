// How deep a sole stands in the ground: a rectangle on four springs, one per corner.

#pragma once

#include <Eigen/Geometry>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// rotation: of the sole frame in a frame with z up.  force: total normal force [N].
// Returns the height of the sole frame's origin above the ground [m] (below zero: pressed in) at
// which springs of a quarter of sole.stiffness each at the corners carry that force; corners off
// the ground carry nothing.  Without force: the height at which the lowest corner touches.
double sole_height(const Sole& sole, const Eigen::Matrix3d& rotation, double force) noexcept;

}  // namespace twinbus::robot
