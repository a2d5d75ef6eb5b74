// From one stream of set-points to another without a jump in position, velocity, torque or gain.
//
// At the change the difference old - new is remembered and fades: position with the quintic that
// starts with the difference in position d and velocity v and ends with neither,
//
//     offset(s) = d (1 - 10 s^3 + 15 s^4 - 6 s^5) + v T (s - 6 s^3 + 8 s^4 - 3 s^5),     s = t / T
//
// torque and gains linearly in the same smooth step.  A change in mid-fade starts from what was
// last put out.  Where set-points are what is measured, before or after the change, v is the noise
// of a sensor: carried on for T it would be an offset of milliradians, and there is none.  Their torques answer
// the same noise, and what is kept of it for T tilts the robot: the difference fades in kTorque.

#pragma once

#include <cstdint>

#include "control/joint/set_point.h"

namespace twinbus::inline control {

class Blend {
 public:
  // joint_count: on the bus.
  explicit Blend(int joint_count) noexcept : count_(joint_count) {}

  // last: what was put out before; fresh: what the new mode wants at the same instant; measured: bit per joint of which
  // either follows what is measured.
  void start(const SetPoint& last, const SetPoint& fresh, std::int64_t measured,
             double duration) noexcept;
  // Adds what is left of the difference.
  void apply(SetPoint& set_point, double dt) noexcept;
  bool active() const noexcept { return time_ < duration_; }
  void cancel() noexcept { duration_ = time_ = 0.0; }

 private:
  bool follows(std::size_t joint) const noexcept { return ((measured_ >> joint) & 1) != 0; }

  int count_;
  double duration_ = 0.0, time_ = 0.0;
  SetPoint difference_;
  std::int64_t measured_ = 0;
};

}  // namespace twinbus::control
