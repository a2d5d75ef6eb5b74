// Where a robot's links are tied to one another in loops: the list `loops` of robot.yaml; scenes
// have one too.
//
// A tie holds one point; two on its axis make a hinge, three that are not on a line weld.  The tree
// of the URDF leaves these joints out, and whoever computes with the tree alone does not know them:
// they are of the simulated world only and not part of the model's hash.

#pragma once

#include <Eigen/Core>
#include <string>

namespace twinbus::inline common {
class ConfigNode;
}  // namespace twinbus::common

namespace twinbus::inline robot {

struct Loop {
  std::string link;                                 // of the URDF
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  // in its frame [m]
  std::string to = "world";                         // another link, in scenes a loose body too
  Eigen::Vector3d at = Eigen::Vector3d::Zero();     // in its frame; of the world: where [m]
  double stiffness = 1e8;                           // [N/m]
  double damping = 1e5;                             // [N s/m]
  double length = -1.0;                             // of a spring between the points [m]; < 0: none
};

// Keys: link, point, to, at, stiffness, damping, length.  Throws std::runtime_error naming file,
// line and key.
Loop read_loop(const ConfigNode& node);

}  // namespace twinbus::robot
