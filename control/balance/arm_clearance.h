// While the trunk leans to a side, the arm on that side swings out from it, so that it does not meet the leg.
//
//     out* = share max(0, lean - free)        out'' = w^2 (out* - out) - 2 w out'
//
// Small leans move no arm: who reaches for something while balance sways is not disturbed.

#pragma once

#include <array>

#include "robot/description/model.h"

namespace twinbus::inline control {

struct ArmClearanceGains {
  double free = 0.15;   // lean that moves no arm [rad]
  double share = 0.6;   // of the lean beyond it
  double rate = 10.0;   // w [rad/s]
  double limit = 0.35;  // of out [rad]
};

class ArmClearance {
 public:
  ArmClearance(const Model& model, const ArmClearanceGains& gains);

  void start() noexcept;
  // lean: of the trunk against the legs, to the left [rad].
  void update(double lean, double dt) noexcept;

  // The joint that swings this arm (0 left) out, or -1; what is added to its set-point [rad], its rate and acceleration.
  int joint(int arm) const noexcept { return arm_[static_cast<std::size_t>(arm)].joint; }
  double angle(int arm) const noexcept { return of(arm).sign * of(arm).angle; }
  double rate(int arm) const noexcept { return of(arm).sign * of(arm).rate; }
  double acceleration(int arm) const noexcept { return of(arm).sign * of(arm).acceleration; }

 private:
  struct Arm {
    int joint = -1;
    double sign = 1.0;                                   // of the joint, outwards
    double angle = 0.0, rate = 0.0, acceleration = 0.0;  // outwards
  };
  const Arm& of(int arm) const noexcept { return arm_[static_cast<std::size_t>(arm)]; }

  ArmClearanceGains gains_;
  std::array<Arm, 2> arm_;
};

}  // namespace twinbus::control
