// The slope of the ground that a walking robot finds with its soles: height(p) = height(foot) + k . (p - foot).
//
//     k += g (s - k)        s: gradient under a sole that has carried the robot, at each step
//
// It is believed only while it foretells the next sole's clearly better than level ground does: on level ground and on
// tiles that tilt at random k is nought.

#pragma once

#include <Eigen/Core>

namespace twinbus::inline control {

class GroundSlope {
 public:
  void reset() noexcept { *this = {}; }
  // A sole carried the robot on ground of this gradient.
  void stood_on(const Eigen::Vector2d& gradient) noexcept;
  // k; nought while it is not believed.
  Eigen::Vector2d gradient() const noexcept {
    return believed_ ? found_ : Eigen::Vector2d(Eigen::Vector2d::Zero());
  }

 private:
  Eigen::Vector2d found_ = Eigen::Vector2d::Zero();
  double level_error_ = 0.0, slope_error_ = 0.0;  // squares of what both foretold wrong, smoothed
  bool believed_ = false;
};

}  // namespace twinbus::control
