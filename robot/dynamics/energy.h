// Kinetic and potential energy of a robot, without what servos and contacts store.

#pragma once

#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

// kinematics: updated for the configuration.  Potential from z = 0 of the world, gravity kGravity;
// rotors turn with their joints.  A base that does not move counts with nothing but its height [J].
double mechanical_energy(const Kinematics& kinematics, const Configuration& configuration) noexcept;

}  // namespace twinbus::robot
