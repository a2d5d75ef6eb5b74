// The point of a hand that reaches: the hand's own frame, or a tool that it carries.
//
//   tools:
//     pen: {frame: tool0, at: [0, 0, 0.12], rpy: [0, 0, 0]}   # in that link of the URDF [m, rad]

#pragma once

#include <Eigen/Geometry>
#include <string>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// Where the tool is in the frame of a hand.  text: "X,Y,Z" or "X,Y,Z,R,P,Y" [m, rad], a name under `tools:` of robot.yaml, or a
// link of the URDF that the hand carries.  Throws std::runtime_error with one sentence when it is none of these.
Eigen::Isometry3d tool_in_hand(const Model& model, const Hand& hand, const std::string& text);

}  // namespace twinbus::robot
