// A scene: what stands where, what is asked of the robot and when, and when the run counts as
// passed.

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "robot/collision.h"
#include "robot/model.h"
#include "robot/requests.h"

namespace twinbus {

struct Push {  // constant force on a link for a while
  std::string link;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();    // in the link frame [m]
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();  // world [N s]
  double at = 0.0;                                    // [s] of scene time
  double duration = 0.1;                              // [s]
};

struct TimedMode {
  double at = 0.0;  // [s] of scene time; takes effect at tick at / period
  ModeRequest request;
  std::string pose;  // named pose of the robot that request.q is to take; see resolve_poses
};

struct TimedGoal {
  double at = 0.0;  // [s]
  ArmGoal goal;
  std::string pose;
};

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
  std::string engine = "articulated";  // or ode
  double duration = 10.0;              // [s] of `twinbus run`
  std::string about;                   // one sentence
  double step = 0.0;  // physics step [s], a whole part of the robot's period; 0: the period
  std::string start_pose = "half_sitting";
  bool fixed_base = false;
  double ground_friction = 0.8;
  std::vector<Obstacle> obstacles;  // in the ground frame, for planner, guard and the world
  std::vector<Push> pushes;
  std::vector<TimedMode> modes;
  std::vector<TimedGoal> goals;
  Criteria criteria;
  std::string text;                                           // as read
  std::vector<std::pair<std::string, std::string>> settings;  // model.mass_scale=1.03 and the like
};

// Fills q and joint_mask of the modes and goals that name a pose, in bus order.  Throws
// std::runtime_error if the robot has no such pose.
void resolve_poses(Scene& scene, const Model& model);

// name_or_file: a YAML file, or a name under config/scenes.  Throws std::runtime_error naming file,
// line and the nearest valid key.
//
// Keys: about, robot, engine (articulated or ode), duration, step, start_pose, base (floating or fixed), ground:
// {friction}, obstacles: [shape, size, position, rpy_deg], pushes: [link, point, impulse, at,
// duration], modes: [at, mode, motion, pose, duration, amplitude, frequency], goals: [at, hand,
// position, rpy_deg, pose, speed, cancel], criteria: {max_tilt_deg, zmp_margin_min_mm, slip_max_mm,
// sole_tilt_max_deg, no_fall, no_self_collision}, settings: {model.mass_scale: 1.03, ...} as in
// sim/settings.h.  Scene time starts with the first command.
Scene load_scene(const std::string& name_or_file);

}  // namespace twinbus
