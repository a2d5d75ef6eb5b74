// Every number that tunes walking, with a default that suits a robot of 1 to 2 m: bandwidths and times, not torques.

#pragma once

#include "control/walk/swing_foot.h"

namespace twinbus::inline control {

struct WalkStabilizerGains {
  double dcm = 6.0;       // k [1/s]: the rate at which a DCM error decays
  double integral = 0.5;  // k_i [1/s]
  double leak = 3.0;      // of the integral [s]
  double margin = 0.010;  // kept from the sole edges by the commanded centres of pressure [m]
  double to_plan = 3.0;   // k_r [1/s]: of the reference pendulum to the plan
  double give_up = 8.0;   // lambda [1/s]: what the soles cannot do, the reference gives up
  double far = 0.05;      // a ZMP so far beyond the soles is given up at the full rate [m]
  double reach = 0.30;    // of the centre of mass from the feet that carry it [m]
};

struct WalkFeetGains {
  double filter = 0.015;    // of what a sole gives way under its load [s]
  double ankle = 50.0;      // admittance to the moment that is missed [1/s]
  double ankle_leak = 0.5;  // in which it becomes the slope that the ground is taken to have [s]
  double flat = 20.0;       // in which a standing sole forgets that slope [s]
  // What the admittances take a sole to give way at least, bearing the robot at its edge and in its middle [rad], [m]: on
  // stiffer soles they would turn too slowly to the ground, and the legs behind them give way so far.
  double least_bend = 0.014, least_sink = 0.0014;
  double most_turn = 0.2;   // of the admittance [rad]
  double force = 90.0;      // admittance to the difference of the feet's forces [1/s]
  double force_leak = 0.3;  // [s]
  double most_lift = 0.04;  // [m]
  double rattle_moment = 0.010, rattle_force = 0.005;  // filters of what both admittances are given, where it rattles [s]
  double upright = 0.8;     // share of the base's error that is taken out of the foot in the air
  double upright_filter = 0.03;  // [s]
  double landing = 0.25;         // in which a foot that landed elsewhere is taken into the plan [s]
};

struct WalkGains {
  WalkStabilizerGains stabilizer;
  WalkFeetGains feet;
  SwingGains swing;
  double velocity_filter = 0.010;      // of the velocity that tells whether the robot rests [s]
  double acceleration_filter = 0.010;  // of the joints' accelerations in the torques [s]
  double ground =
      5.0;  // rate at which the centre of mass follows the height of the footholds [1/s]
  double settle = 1.0;  // time in which height and attitude found at the start are put right [s]
  double turn = 0.05;   // lag of the base's heading behind the feet [s]
  double step_when = 0.03;  // ZMP wanted beyond the soles that starts a step from standing [m]
  int rounds = 1;           // of the whole-body inverse kinematics
};

}  // namespace twinbus::control
