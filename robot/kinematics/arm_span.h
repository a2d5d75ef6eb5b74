// An arm from its shoulder to its hand.

#pragma once

#include <Eigen/Core>

#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

struct ArmSpan {
  Eigen::Vector3d shoulder;  // where the first joint is that turns, behind lifts and rails, world [m]
  double length = 0.0;       // of the stretched arm [m]
};

// In the posture of k.  The hand must have joints.
ArmSpan arm_span(const Kinematics& k, const Hand& hand) noexcept;

// Axes of the hand, in its frame, by what it looks like: z points away from the wrist, along the last joint's axis, or to the hand
// where the last joint does not roll it but bends the wrist; a description's own axes may lie otherwise.
Eigen::Matrix3d pointing(const Kinematics& k, const Hand& hand) noexcept;

// Is the arm's first joint upright?  Its first link then turns in place, as a turntable on the ground does.
bool turns_in_place(const Kinematics& k, const Hand& hand) noexcept;

}  // namespace twinbus::robot
