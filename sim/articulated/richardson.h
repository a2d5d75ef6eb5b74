// Richardson extrapolation of steps of order 1 to order 2 or 3.
//
// With y1, y2, y3 after one step, two halves and three thirds of it from the same start:
//
//     order 2    2 y2 - y1
//     order 3    (3 (3 y3 - 2 y2) - (2 y2 - y1)) / 2

#pragma once

#include <array>
#include <vector>

#include "robot/kinematics/kinematics.h"

namespace twinbus::inline sim {

class JointLaw;

// Order 3 makes an oscillation that nothing damps grow, by up to 0.16 % a step where it turns by less than
// 0.8 rad in one (so do all sequences of parts); order 2 does not.  What lies still takes order 2
// from the finest two, 3 y3 - 2 y2, at order 3.
void extrapolate_at_rest(const std::array<Configuration, 2>& coarse, Configuration& y) noexcept;

// coarse: y1 and, at order 3, y2, which is spoilt.  y: the finest; becomes the result.  Returns how much the last
// correction changes a speed, turns looked at 0.1 m away [m/s]; that of order 3 is a third of what order 2 with the same
// halves is off.
double extrapolate(int order, std::array<Configuration, 2>& coarse, Configuration& y) noexcept;

// What is extrapolated may leap over a stop that no step of order 1 passes: whether a joint of y is further beyond one than in
// fine, the finest of those steps, or is not a number.
bool passes_stops(const std::vector<JointLaw>& joints, const Configuration& fine, const Configuration& y) noexcept;

}  // namespace twinbus::sim
