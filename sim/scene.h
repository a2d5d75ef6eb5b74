// A scene: what stands where, what is asked of the robot and when, and when the run counts as passed.

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robot/collision.h"
#include "robot/requests.h"

namespace twinbus {

struct Push {  // constant force on a link for a while
  std::string link;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // in the link frame [m]
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // world [N s]
  double at = 0.0;        // [s]
  double duration = 0.1;  // [s]
};

struct TimedMode { double at = 0.0; ModeRequest request; };  // takes effect at tick at / period
struct TimedGoal { double at = 0.0; ArmGoal goal; };

// Pass criteria; NaN means not asked.
struct Criteria {
  double max_tilt_deg;
  double zmp_margin_min_mm;
  double slip_max_mm;
  double sole_tilt_max_deg;
  bool no_fall = true;
  bool no_self_collision = true;
  Criteria();
};

struct Scene {
  std::string name;
  std::string robot = "hrp1s";
  std::string engine = "ode";
  double duration = 10.0;            // [s] of `twinbus run`
  double step = 0.0;                 // physics step [s]; 0: the robot's period
  std::string start_pose = "half_sitting";
  bool fixed_base = false;
  double ground_friction = 0.8;
  std::vector<Obstacle> obstacles;   // in the ground frame, for planner, guard and the world
  std::vector<Push> pushes;
  std::vector<TimedMode> modes;
  std::vector<TimedGoal> goals;
  Criteria criteria;
  std::string text;                  // as read
  std::vector<std::pair<std::string, std::string>> settings;  // model.mass_scale=1.03 and the like
};

// name_or_file: a YAML file, or a name under config/scenes.  Throws std::runtime_error naming file, line and the
// nearest valid key.
Scene load_scene(const std::string& name_or_file);

}  // namespace twinbus
