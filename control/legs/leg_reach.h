// What one leg can reach, found from its joints: which one is the knee, how long the leg is when it is straight, and how
// hard its hip throws it.

#pragma once

#include <Eigen/Core>

#include "robot/description/model.h"

namespace twinbus::inline control {

struct LegReach {
  int knee = -1;              // joint that changes the distance from hip to ankle
  double straight = 0.0;      // its angle at which that distance is longest [rad]
  double bends = 1.0;         // sign of its bending
  double longest = 0.0;       // hip to ankle [m]
  double ankle_height = 0.0;  // of the ankle above the sole [m]
  double hip_width = 0.0;     // between the hips [m]
  Eigen::Vector2d swing{1e3, 1e3};  // of the sole of a straight leg at the efforts of its hip: forward, to the side [m/s^2]
  double turn = 0.5;          // range of the hip about the vertical, the smaller side [rad]
};

// Throws std::runtime_error when the leg has no knee.  The leg must have five to seven joints.
LegReach leg_reach(const Model& model, int foot);

}  // namespace twinbus::control
