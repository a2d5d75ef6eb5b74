#include "sim/scene_robots.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include "robot/description/load.h"

namespace twinbus::inline sim {

std::vector<OtherRobot> robots_of(const Scene& scene) {
  std::vector<OtherRobot> robots;
  for (const SceneRobot& asked : scene.robots) {
    auto model = std::make_shared<const Model>(load_robot(asked.robot));
    if (model->find_pose(asked.pose) < 0 && asked.pose != "zero") {
      throw std::runtime_error("scene " + scene.name + ": robot '" + asked.name + "', a " +
                               model->name + ", has no pose '" + asked.pose +
                               "'; name one of its SRDF group_states");
    }
    const Eigen::VectorXd q = Configuration(*model, asked.pose).q;
    robots.push_back(standing_robot(asked.name, std::move(model), q, asked.place));
  }
  return robots;
}

}  // namespace twinbus::sim
