// Whether a robot on which nobody works keeps its energy, for scenes that ask.

#pragma once

#include <algorithm>
#include <cmath>

#include "robot/dynamics/energy.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/scene/scene.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

class EnergyWatch {
 public:
  // Does nothing for a scene that does not ask.
  EnergyWatch(const Model& model, const Scene& scene)
      : on_(!std::isnan(scene.criteria.energy_drift_j)), kinematics_(model) {}

  // Each tick.  From the first on in which no servo has a torque and nothing pushes.
  void add(bool pushed, const RobotState& state, const World& world) {
    if (!on_) return;
    const bool worked = std::any_of(state.tau.begin(), state.tau.begin() + state.joint_count,
                                    [](float tau) { return tau != 0.0F; });
    if (!begun_ && (pushed || worked)) return;
    kinematics_.update(world.configuration());
    const double now = mechanical_energy(kinematics_, world.configuration());
    if (!begun_) first_ = now;
    begun_ = true;
    drift_ = std::max(drift_, std::abs(now - first_));
  }

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

}  // namespace twinbus::launcher
