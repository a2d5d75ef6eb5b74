// A further robot of a world: nothing commands it, its servos hold the posture that it begins in.

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/world/servo_target.h"

namespace twinbus::inline sim {

struct WorldConfig;

struct OtherRobot {
  std::string name;
  std::shared_ptr<const Model> model;
  Configuration start;
  std::vector<ServoTarget> servos;  // one for each joint
};

// One that stands in a pose on the springs of its soles, with the gains and torques that keep it
// there.  place: of the middle between its soles, on the ground.
OtherRobot standing_robot(const std::string& name, std::shared_ptr<const Model> model,
                          const Eigen::VectorXd& q, const Eigen::Isometry3d& place);

// Throws std::runtime_error, naming the robot, for a start or a servo that cannot be.
void check_robot(const OtherRobot& robot);

// Of this robot: ground, contact and step are the world's; what is changed of the commanded robot
// alone is not changed of this one.
WorldConfig config_of(const OtherRobot& robot, const WorldConfig& world);

}  // namespace twinbus::sim
