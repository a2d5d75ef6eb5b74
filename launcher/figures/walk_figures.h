// How well a robot walked, from what only a simulator knows: margins of its zero-moment point, what its soles slid while
// they stood, its feet's forces against those that were asked of them, and its velocity against the command.

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline launcher {

class WalkFigures {
 public:
  WalkFigures(const Model& model, const Scene& scene);

  // Every tick.  asked: normal forces asked of the soles [N]; time: of the scene [s].
  void add(const SimTruth& truth, Mode mode, const std::array<double, 2>& asked, double time);

  std::int64_t steps() const { return steps_; }       // feet that landed in mode walk
  double margin_percentile(double share) const;       // of the ZMP in mode walk, 0.05: the 5th [m]
  double step_slip_max() const { return slip_max_; }  // of a sole from where it took up load [m]
  double force_error() const;  // root mean square in mode walk, share of the weight
  // Worst of the scene's walks, as a share of what was asked; NaN: there was none long enough.
  double velocity_error() const;
  double travel() const;  // of the base from its first place, now [m]

 private:
  struct Stretch {  // of one walk command, its first seconds left out
    double from = 0.0, until = 0.0;
    std::array<double, 3> asked{};
    std::array<double, 3> moved{};  // along, to the left [m], turned [rad]
    double time = 0.0;
    // From one landing of the left foot to another: how the body sways in a step is no error of its velocity.
    std::array<double, 3> whole{};
    double whole_time = 0.0;
    bool begun = false;
  };
  struct Stance {
    bool loaded = false;
    double x = 0.0, y = 0.0;
  };

  double weight_ = 1.0;
  std::size_t soles_ = 0;  // rows of TRUTH that are soles
  std::array<Stance, 2> stance_;
  std::vector<Stretch> stretches_;
  std::vector<std::int64_t> margins_;  // how often, by millimetre
  std::int64_t counted_ = 0, steps_ = 0;
  double slip_max_ = 0.0, force_square_ = 0.0;
  std::array<double, 3> last_{};   // x, y, yaw
  std::array<double, 2> first_{};  // x, y
  double last_time_ = -1.0;
};

}  // namespace twinbus::launcher
