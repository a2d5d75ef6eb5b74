// Rotation of a body on which no torque acts, for as long as one likes.
//
// With P the angular momentum and w = I^-1 P in the body's axes, one step of the midpoint rule,
// P1 = P + h (P + P1)/2 x (w + w1)/2, is P1 = cay(-h wm) P exactly; turning the body by the same
// Cayley matrix keeps the momentum in the world, and the midpoint rule keeps the energy.  Both hold
// to rounding at any step.  Three such steps in the ratio 1 : -1.70 : 1 (Yoshida 1990) are of
// order 4.

// Four bodies turn in the lanes of a vector, each as it would by itself, to the bit.

#pragma once

#include <Eigen/Geometry>

namespace twinbus::inline sim {

inline constexpr int kFreeLanes = 4;

struct FreeRotation {
  const Eigen::Vector3d* inertia = nullptr;  // principal, along the body's axes [kg m^2]
  Eigen::Isometry3d* pose = nullptr;         // body in world; only its rotation changes
  Eigen::Vector3d* spin = nullptr;           // in world [rad/s]
};

// count: up to kFreeLanes; h [s].
void turn_freely(const FreeRotation* bodies, int count, double h) noexcept;

inline void turn_freely(const Eigen::Vector3d& inertia, double h, Eigen::Isometry3d& pose, Eigen::Vector3d& spin) noexcept {
  const FreeRotation body{&inertia, &pose, &spin};
  turn_freely(&body, 1, h);
}

}  // namespace twinbus::sim
