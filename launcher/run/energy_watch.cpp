#include "launcher/run/energy_watch.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/energy.h"

namespace twinbus {

EnergyWatch::EnergyWatch(const Model& model, const Scene& scene)
    : on_(!std::isnan(scene.criteria.energy_drift_j)), kinematics_(model) {}

void EnergyWatch::add(bool pushed, const RobotState& state, const World& world) {
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

}  // namespace twinbus
