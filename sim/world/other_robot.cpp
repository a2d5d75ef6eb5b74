#include "sim/world/other_robot.h"

#include <stdexcept>

#include "common/math/index.h"
#include "sim/world/static_equilibrium.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

OtherRobot standing_robot(const std::string& name, std::shared_ptr<const Model> model,
                          const Eigen::VectorXd& q, const Eigen::Isometry3d& place) {
  std::array<double, 2> corner{};
  for (std::size_t side = 0; side < 2; ++side) {
    corner[side] = model->soles[side].stiffness / kSoleCorners;
  }
  Standing standing = stand(*model, q, 1.0, corner, {0.0, 0.0}, !model->floating_base);
  OtherRobot robot;
  robot.name = name;
  for (int j = 0; j < model->joint_count(); ++j) {
    const Joint& joint = model->joints[at(j)];
    robot.servos.push_back(
        {.q = q[j], .qd = 0.0, .tau = standing.tau[j], .kp = joint.kp, .kd = joint.kd});
  }
  robot.model = std::move(model);
  robot.start = standing.configuration;
  robot.start.base = place * robot.start.base;
  return robot;
}

void check_robot(const OtherRobot& robot) {
  const std::string name = "robot '" + robot.name + "': ";
  if (!robot.model || robot.servos.size() != robot.model->joints.size() ||
      check_configuration(robot.model->joints.size(), robot.start) != Status::kOk) {
    throw std::runtime_error(name + "its start is not one of its model");
  }
  for (std::size_t j = 0; j < robot.servos.size(); ++j) {
    if (check_target(robot.servos[j]) == Status::kOk) continue;
    throw std::runtime_error(name + "joint '" + robot.model->joints[j].name +
                             "' cannot have such a servo");
  }
}

WorldConfig config_of(const OtherRobot& robot, const WorldConfig& world) {
  WorldConfig own;
  own.step = world.step;
  own.contact = world.contact;
  own.dissipation = world.dissipation;
  own.rolling_friction = world.rolling_friction;
  own.torsional_friction = world.torsional_friction;
  own.fixed_base = !robot.model->floating_base;
  own.ground_friction = world.ground_friction;
  own.shell_stiffness = world.shell_stiffness;
  own.obstacles = world.obstacles;
  own.tiles = world.tiles;
  return own;
}

}  // namespace twinbus::sim
