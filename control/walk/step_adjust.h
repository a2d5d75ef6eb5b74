// Place and time of the next foothold, so that a robot that was pushed can still be caught.
//
// With the ZMP anywhere in the sole [l, h] (sole axes) until touchdown in T seconds, the DCM then lies in
//
//     [h + (xi - h) E, l + (xi - l) E],     E = e^(omega T)
//
// Less the offset that it has from the foothold when all goes as planned, that is an interval of footholds: the one
// nearest to the planned is taken, within reach, and no farther than the hips throw a foot in that time.  Of some durations the
// cheapest is kept.  Undisturbed, nothing moves.  Soles that no ankle rolls (Gait::leans) hold the ZMP at one edge: there an early
// step is as much shorter, so that the speed stays.

#pragma once

#include <Eigen/Core>

#include "control/walk/footsteps.h"

namespace twinbus::inline control {

struct StepNow {
  Foothold support;                               // the foot that stands
  int foot = 0;                                   // which one
  Foothold moves;                                 // the other one, where it is
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  // of it, world [m/s]
  Foothold planned;                               // where it goes when all goes as planned
  Eigen::Vector2d dcm = Eigen::Vector2d::Zero();  // measured, world [m]
  Eigen::Vector2d offset =
      Eigen::Vector2d::Zero();  // planned DCM less foothold at touchdown, world [m]
  double left_planned = 0.0;    // until touchdown as planned [s]
  double left_now = 0.0;        // as adjusted before [s]
  double shortest = 0.1;        // [s]
  double elapsed = 0.0;         // of the step, its double support included [s]
};

struct StepAdjusted {
  Foothold foothold;
  double left = 0.0;   // until touchdown [s]
  double moved = 0.0;  // from the foothold of an undisturbed step of this duration [m]
  double cost = 0.0;   // of this step; mostly what is beyond reach
};

StepAdjusted adjust_step(const Gait& gait, const StepNow& now, double omega) noexcept;

}  // namespace twinbus::control
