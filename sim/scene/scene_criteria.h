// When a run of a scene counts as passed.

#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "common/text/strict_yaml.h"

namespace twinbus::inline sim {

inline constexpr double kNotAsked = std::numeric_limits<double>::quiet_NaN();

// Where a loose body is to be at the end of a run, at rest.
struct LooseEnd {
  std::string name;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // of its middle, world [m]
  double within = 0.01;                                // [m]
  double speed = 0.02;                                 // at most [m/s]
};

// How a further robot is to end: about where it began and upright.
struct RobotEnd {
  std::string name;
  double within = 0.01;     // of its base, level [m]
  double max_tilt_deg = 5;  // of its base
};

// A joint's torque, after the scene's one push, is to swing as the linear model of the standing robot
// does: launcher/figures/swing.h.
struct SwingAsked {
  std::string joint;            // empty: not asked
  double period_percent = 3.0;  // within this of the model's
  double decay_percent = 10.0;
};

// Where a joint of the robot is to be at the end of a run, and how fast it then turns.
struct JointEnd {
  std::string name;
  double position = 0.0;      // [rad or m]
  double within = 0.0;        // [rad or m]
  double speed = kNotAsked;   // [rad/s or m/s]
  double speed_within = 0.0;  // [rad/s or m/s]
};

// A loose body on which no torque acts turns on as it did.
struct SpinAsked {
  std::string name;
  double energy_drift = 1e-9;    // of turning, at most, relative
  double momentum_drift = 1e-9;  // angular, in world, at most, relative
  int flips = -1;                // how often its middle axis points the other way; < 0: not asked
};

// At so many points the robot is touched, everywhere by the same force.
struct TouchAsked {
  int points = 0;       // 0: not asked
  double force = 0.0;   // upward, at each [N]
  double within = 0.0;  // relative
  double from = 0.0;    // in every tick from here on [s]
};

// Pass criteria.
struct Criteria {
  double max_tilt_deg = kNotAsked;
  double zmp_margin_min_mm = kNotAsked;
  double slip_max_mm = kNotAsked;
  double sole_tilt_max_deg = kNotAsked;
  double zmp_margin_p5_mm = kNotAsked;        // 5th percentile
  double step_slip_max_mm = kNotAsked;        // of a sole while it stands, in any step
  double force_rms_percent = kNotAsked;       // normal force of a foot against what was wanted, of the weight
  double velocity_error_percent = kNotAsked;  // of what was commanded, over each walk
  double travel_min_m = kNotAsked;            // of the base from where it was at the start, at the end
  double drift_max_m = kNotAsked;             // the same, at most
  double energy_drift_j = kNotAsked;          // of the robot while no servo works on it
  double loose_energy_drift_j = kNotAsked;    // of all loose bodies together, without what springs store
  double loose_energy_gain_j = kNotAsked;     // the same, upward only
  double goals_reached_min = kNotAsked;       // of the arm goals, at least
  double max_doubted_steps = kNotAsked;       // physics steps that the engine itself does not trust
  bool no_fall = true;
  bool no_self_collision = true;
  TouchAsked touch;
  std::vector<LooseEnd> loose;
  std::vector<RobotEnd> robots;
  std::vector<JointEnd> joints;
  SwingAsked swing;  // of one of them
  std::vector<SpinAsked> spins;
};

// The map `criteria` of a scene with loose bodies and further robots of these names.  Keys:
// {max_tilt_deg, zmp_margin_min_mm, slip_max_mm, sole_tilt_max_deg, zmp_margin_p5_mm,
// step_slip_max_mm, force_rms_percent, velocity_error_percent, travel_min_m, drift_max_m,
// energy_drift_j, loose_energy_drift_j, loose_energy_gain_j, goals_reached_min, max_doubted_steps, no_fall, no_self_collision, loose:
// [name, position, within_m, speed_m_s], robots: [name, within_m, max_tilt_deg], joints: [name,
// position, within, speed, speed_within], spins: [name, energy_drift, momentum_drift, flips], touch:
// {points, force_n, within, from}, swing: {joint, period_percent, decay_percent}}
// Throws std::runtime_error naming file, line and key.
Criteria read_criteria(const ConfigNode& node, const std::vector<std::string>& loose,
                       const std::vector<std::string>& robots);

}  // namespace twinbus::sim
