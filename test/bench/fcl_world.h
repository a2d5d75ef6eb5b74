// The exact meshes of a robot, or its balls, among obstacles, by FCL alone: the oracle of
// `bench planner`.

#pragma once

#include <memory>
#include <string>

#include "robot/description/model.h"
#include "test/bench/planner_problems.h"

namespace twinbus {

class FclWorld {
 public:
  // The balls of a group that has some, else its meshes; model must outlive this.
  FclWorld(const Model& model, const RobotParts& parts, const std::vector<int>& planned);
  ~FclWorld();
  void set_obstacles(const std::vector<Obstacle>& obstacles);
  // q: of all joints.  touching, when given: who.
  bool free(const float* q, std::string* touching = nullptr);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace twinbus
