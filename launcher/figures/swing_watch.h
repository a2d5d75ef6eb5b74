// Watches a joint after the scene's push is over, for scenes that ask for the swing of Fig. 12.

#pragma once

#include <optional>
#include <vector>

#include "robot/description/model.h"
#include "sim/scene/scene.h"
#include "launcher/figures/swing.h"
#include "sim/world/world.h"

namespace twinbus::inline launcher {

class SwingWatch {
 public:
  // Does nothing for a scene that asks for none.  Throws std::runtime_error when the robot has no such
  // joint or its linear model does not swing.
  SwingWatch(const Model& model, const Scene& scene, const WorldConfig& world);

  bool on() const { return joint_ >= 0; }
  // Each tick.  pushed: a push acts; values before the last one's end do not count.
  void add(bool pushed, const RobotState& state);

  const Swing& expected() const { return expected_; }
  std::optional<Swing> seen() const { return swing_seen(values_, period_); }

 private:
  int joint_ = -1;  // on the bus
  double period_ = 0.0;
  Swing expected_;
  bool released_ = false;
  std::vector<double> values_;  // torque [N m]
};

}  // namespace twinbus::launcher
