// The ties of a scene: the loops of the robot and of the scene, and what is to be gripped and let go
// as it runs.

#pragma once

#include <vector>

#include "sim/scene/scene.h"
#include "sim/world/constraint.h"

namespace twinbus {

class SceneTies {
 public:
  SceneTies() = default;
  // robots: the further ones of the scene.  Throws std::runtime_error for a name that neither
  // robot nor scene has.
  SceneTies(const Model& model, const std::vector<OtherRobot>& robots, const Scene& scene);

  const std::vector<Tie>& ties() const noexcept { return ties_; }
  // At the start of a step at a time of the scene [s]: what is due is gripped or let go.
  void update(double time, World& world) noexcept;

 private:
  struct Timed {
    int first;  // of its ties
    double at, until;
    bool holds = false;
  };

  std::vector<Tie> ties_;
  std::vector<Timed> grasps_;
};

}  // namespace twinbus
