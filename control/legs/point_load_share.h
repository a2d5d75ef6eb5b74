// Which part of the weight each standing point carries when the robot is at rest: the least forces that balance it.
//
//     min |f|^2   with   sum f_i = 1,   sum f_i d_i = 0,   f_i >= 0          d_i: from below the centre of mass, level
//
// By normal equations of 3 x 3; a point that would pull is left out and the rest is solved again.  Where the points do not
// surround the centre of mass no such forces are: the nearest are taken, scaled to the whole weight.

#pragma once

#include <Eigen/Core>
#include <array>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline control {

struct PointLoads {
  int count = 0;                               // of points in use
  std::array<Eigen::Vector2d, kMaxFeet> away;  // d_i [m]
  std::array<double, kMaxFeet> share{};        // f_i, 0..1
};

// Fills `share` from `away`; without points nothing is carried.
void share_load_on_points(PointLoads& loads) noexcept;

}  // namespace twinbus::control
