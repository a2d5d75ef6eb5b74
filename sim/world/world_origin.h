// A world that begins far from its origin: everything in it is moved.
//
// Positions are doubles and the engines compute with differences of them: at d metres a spring of k [N/m] is off by about
// 1e-16 d k [N], no more.  Messages whose positions are floats are rounded to 6e-8 d: a millimetre at 10 km.

#pragma once

#include <Eigen/Core>

#include "sim/world/world.h"

namespace twinbus::inline sim {

inline constexpr double kMostOrigin = 1e5;  // of a scene, along x and y [m]; a tenth of kMaxDistance

// Obstacles, tiles, loose bodies, further robots and fixed ends of ties; the commanded robot goes where World::set() puts it.
void move_everything(const Eigen::Vector3d& by, WorldConfig& config);

}  // namespace twinbus::sim
