// Rotation of a body on which no torque acts, for as long as one likes.
//
// With P the angular momentum and w = I^-1 P in the body's axes, one step of the midpoint rule,
// P1 = P + h (P + P1)/2 x (w + w1)/2, is P1 = cay(-h wm) P exactly; turning the body by the same
// Cayley matrix keeps the momentum in the world, and the midpoint rule keeps the energy.  Both hold
// to rounding at any step.  Three such steps in the ratio 1 : -1.70 : 1 (Yoshida 1990) are of
// order 4.

#pragma once

#include <Eigen/Core>

namespace twinbus::inline sim {

// rotation: body in world; spin: in world [rad/s]; inertia: principal, along the body's axes.
void turn_freely(const Eigen::Vector3d& inertia, double h, Eigen::Matrix3d& rotation,
                 Eigen::Vector3d& spin) noexcept;

}  // namespace twinbus::sim
