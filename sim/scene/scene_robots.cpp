#include "sim/scene/scene_robots.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "robot/description/load.h"

namespace twinbus {

std::vector<OtherRobot> robots_of(const Scene& scene) {
  std::vector<OtherRobot> robots;
  for (const SceneRobot& asked : scene.robots) {
    auto model = std::make_shared<const Model>(load_robot(asked.robot));
    const int pose = model->find_pose(asked.pose);
    if (pose < 0 && asked.pose != "zero") {
      throw std::runtime_error("scene " + scene.name + ": robot '" + asked.name + "', a " +
                               model->name + ", has no pose '" + asked.pose +
                               "'; name one of its SRDF group_states");
    }
    Eigen::VectorXd q = Eigen::VectorXd::Zero(model->joint_count());
    for (int j = 0; pose >= 0 && j < model->joint_count(); ++j) {
      q[j] = model->poses[static_cast<std::size_t>(pose)].q[static_cast<std::size_t>(j)];
    }
    robots.push_back(standing_robot(asked.name, std::move(model), q, asked.place));
  }
  return robots;
}

}  // namespace twinbus
