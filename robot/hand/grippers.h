// Fingers that open and close together: the map `grippers` of robot.yaml, one group a hand.
//
//   grippers:
//     right: {joints: [finger_joint1], open: [0.04], closed: [0]}   # [rad or m]
//
// Joints that follow another (<mimic>) move with it and are not named.

#pragma once

#include <vector>

#include "robot/description/robot_yaml.h"

namespace twinbus {

// Where its joints are at a share of its opening: 0 closed, 1 open.
std::vector<double> opened(const Gripper& gripper, double share);

}  // namespace twinbus
