// Whether a robot on which nobody works keeps its energy, for scenes that ask.

#pragma once

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace twinbus {

class EnergyWatch {
 public:
  // Does nothing for a scene that does not ask.
  EnergyWatch(const Model& model, const Scene& scene);

  // Each tick.  From the first on in which no servo has a torque and nothing pushes.
  void add(bool pushed, const RobotState& state, const World& world);

  bool on() const { return on_; }
  bool begun() const { return begun_; }
  double first() const { return first_; }  // [J]
  double drift() const { return drift_; }  // the most that it was off the first [J]

 private:
  bool on_;
  bool begun_ = false;
  double first_ = 0.0, drift_ = 0.0;
  Kinematics kinematics_;
};

}  // namespace twinbus
