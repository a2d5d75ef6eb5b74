// Mechanisms with closed loops that multibody programs are compared on: trees of links whose loops
// are closed by ties.

#pragma once

#include <string>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus {

struct LoopScene {
  Model model;
  WorldConfig config;  // its ties
  Configuration start;
  Eigen::VectorXd tau;  // that the servos begin with; empty: there are no servos
  int driven = -1;      // a joint on which
  double torque = 0.0;  // acts [N m]
  double duration = 10.0;
  // A point of the mechanism to look at.
  int link = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
};

// four_bar: three rods of 1 m and 1 kg, the top at 1 m/s; n_four_barN: N such squares in a row,
// which lie flat in a line twice a turn; bricard: five such rods on six hinges, overconstrained;
// andrews: the seven bodies of Andrews' squeezing mechanism (Hairer and Wanner 1996, VII.7), torque
// and spring a hundredth of theirs: the same way at a tenth of the speed; tied: the robot standing
// with its hands tied together.  Throws std::runtime_error for another name.
LoopScene loop_scene(const std::string& name);


}  // namespace twinbus
