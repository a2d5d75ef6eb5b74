// The scenes that physics engines are measured on: a model, a start, servos, a duration.
//
// Every engine runs the same robot; mjcf() writes it for MuJoCo with the same numbers.

#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus {

struct PhysicsScene {
  std::string name;
  Model model;
  bool fixed_base = false;
  bool ground = true;     // false: nothing to touch
  double duration = 1.0;  // [s]
  Configuration start;
  std::vector<ServoTarget> servos;  // one for each joint
  Eigen::VectorXd tau;              // of the servos at the start
};

// flight: hrp1s thrown, without servos and stops; arm: its right arm of 7 joints on a wall, swinging;
// stand: on its servos in half_sitting, shoved; push: dropped 10 mm at 0.2 m/s forward;
// push_soft: with the gains of the figures it is compared to, 5000, 1500 and 150 N m/rad for legs and torso, arms,
// wrists; landing: dropped 50 mm; slide: a brick of
// 1 m/s on the ground; throw: dropped turned and turning, all shells can touch; chainN: N
// joints on a floating base, in the air.
// gain: of all servos.  Throws std::runtime_error for another name.
PhysicsScene physics_scene(const std::string& name, double gain = 1.0);

// The scene for MuJoCo, its start as keyframe 0.  Bodies are named link0, link1, ...
std::string mjcf(const PhysicsScene& scene);
// Of one of its attributes, to the last bit.
std::string mjcf_numbers(std::initializer_list<double> values);

}  // namespace twinbus
