// Every number that tunes standing balance, with a default that suits a robot of 1 to 2 m: bandwidths and times, not torques.

#pragma once

#include "control/balance/arm_clearance.h"
#include "control/legs/foot_compliance.h"
#include "control/balance/stabilizer.h"
#include "control/balance/angular_momentum_lean.h"

namespace twinbus::inline control {

struct BalanceGains {
  StabilizerGains stabilizer;
  TrunkYieldGains trunk;
  ArmClearanceGains arms;
  FootComplianceGains foot;
  // Largest a soft sole may be tilted by an off-centre load [rad]: 0.44 degrees, so that 0.5 are kept.
  double sole_tilt = 0.0076;
  double velocity_filter = 0.006;  // of the velocity and momentum in the DCM, and of the turning [s]
  double rate_filter = 0.020;  // of the joints' rates in the set-points of the legs, at the start [s]
  double settle = 1.0;         // time in which what is not upright at the start is put right [s]
  double way_home = 1.5;       // time to the home position of the centre of mass [s]
  double follow_feet =
      1.0;  // rate at which the soles' reference follows where they really are [1/s]
  // Servo gains of the legs while balancing, as shares of robot.yaml's; set-points follow what is measured, so that the
  // torque is what is fed forward and the gains only hold a robot that shadows this one, or one without a controller.
  double leg_kp = 0.3, leg_kd = 0.3;
  double lead = 1.0;  // of the set-point before the measured position [ticks]
  double height = 15.0,
         height_damping = 0.8;  // of the centre of mass: frequency [rad/s] and damping
  double yaw = 8.0, yaw_damping = 0.8, yaw_gyration = 0.2;
  // Home, ahead of the middle of the soles [m]: where half_sitting stands by itself, so far behind it at most (or before it): a push
  // from behind has as much more room in front as it is asked to be stronger.
  double home_forward = -0.020;
};

}  // namespace twinbus::control
