// Every number that tunes standing balance, with a default that suits a robot of 1 to 2 m: bandwidths and times, not torques.

#pragma once

#include "control/foot_compliance.h"
#include "control/stabilizer.h"
#include "control/trunk_yield.h"

namespace twinbus {

struct BalanceGains {
  StabilizerGains stabilizer;
  TrunkYieldGains trunk;
  FootComplianceGains foot;
  double sole_tilt = 0.0075;       // largest a soft sole may be tilted by an off-centre load [rad]
  double momentum = 1.0;               // share of the angular momentum that counts in the DCM
  double velocity_filter = 0.012;      // of the DCM's velocity [s]
  double acceleration_filter = 0.010;  // of the joint accelerations fed forward [s]
  double settle = 1.0;    // time in which tilts and heights found at the start are smoothed out [s]
  double way_home = 1.5;  // time to the home position of the centre of mass [s]
  double follow_feet =
      1.0;  // rate at which the soles' reference follows where they really are [1/s]
  // Servo gains of the legs while balancing, as shares of robot.yaml's: soft, because torque is fed
  // forward and a stiff ankle would decide where the ZMP is instead of the stabilizer.
  double leg_kp = 0.2, leg_kd = 0.3;
  double ankle_kp = 0.02, ankle_kd = 0.05;
  // Base orientation, by turning the whole body against the ground: frequency [rad/s] and damping.
  double upright = 6.0, upright_damping = 1.0;
  double turning_gyration = 0.30;  // radius of gyration that is turned [m]
  double home_forward = 0.0;  // home, ahead of the middle of the soles [m]
  int ik_rounds = 2;
  bool feedback = true;  // false: the bare plan held by the servos, for comparison
};

}  // namespace twinbus
