// robot.yaml: what URDF and SRDF cannot say.  Names of links and joints are still text here;
// load.cpp resolves them.

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/text/strict_yaml.h"
#include "robot/description/loops.h"
#include "robot/description/model.h"
#include "robot/description/walking_config.h"

namespace twinbus {

// Servo numbers of one or more joints; NaN where not said.
struct ServoEntry {
  std::vector<std::string> joints;
  double kp, kd, stop_kp, stop_kd, rate, rotor_inertia, friction, damping;
  ConfigNode node;
};

// What soles and hands have.
struct LimbEntry {
  bool present = false;
  std::string frame, sensor;
  Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();  // of the sole's or hand's frame in that link
};

struct SoleEntry : LimbEntry {
  Sole sole;  // sizes and spring only
};

struct HandEntry : LimbEntry {
  std::vector<std::string> joints;
};

// Links that the robot's own shape keeps near each other: robot/collision/near_pairs.h.
struct NearPairEntry {
  std::array<std::string, 2> links;
  double margin = 0.0;  // [m]
  std::string where;    // file, line and key
};

// What a hand carries: robot/hand/tools.h.
struct ToolEntry {
  std::string name, frame;
  Eigen::Isometry3d offset = Eigen::Isometry3d::Identity();  // in that link
  std::string where;
};

// Of the map `grippers`, one group a hand; joints that follow another (<mimic>) move with it and are not named:
//   right: {joints: [finger_joint1], open: [0.04], closed: [0]}   # [rad or m]
struct GripperEntry {
  std::size_t side = 0;
  std::vector<std::string> joints;
  std::vector<double> open, closed;  // [rad or m]
  ConfigNode node;
};

struct RobotYaml {
  std::string urdf, srdf;  // file names in the robot's folder; srdf may be empty
  std::vector<std::pair<std::string, std::string>> packages;
  std::vector<std::string> fixed_joints;
  std::vector<std::string> inertia_from_shape;  // links; see shape_inertia.h
  bool floating_base = true;
  std::string imu_frame;
  Eigen::Isometry3d imu_offset = Eigen::Isometry3d::Identity();  // of the IMU in that link
  std::array<SoleEntry, 2> soles;
  std::array<HandEntry, 2> hands;
  std::vector<std::string> leg_joints;
  std::vector<ServoEntry> servos;
  Walking walking;
  std::vector<Loop> loops;
  std::vector<NearPairEntry> near_pairs;
  std::vector<ToolEntry> tools;
  std::vector<GripperEntry> grippers;
  std::optional<ConfigNode> mujoco;  // read by robot/mjcf/mujoco_config.h
  Model timing;  // period, timeouts, blend and off action only
};

// Throws std::runtime_error naming file, line and the nearest valid key.
RobotYaml parse_robot_yaml(const std::string& text, const std::string& file);
// Of a loaded robot; of one without that file everything is as it is when nothing is said.
RobotYaml robot_yaml_of(const Model& model);

// Fingers of a hand that open and close together.
struct Gripper {
  std::vector<int> joints;           // of the model, each on the bus; none: no gripper
  std::vector<double> open, closed;  // [rad or m]
};

// Left, right; of a model whose hands are known.  load_robot has asked for both.  Throws std::runtime_error naming file, line and key.
std::array<Gripper, 2> grippers_of(const RobotYaml& yaml, const Model& model);
std::array<Gripper, 2> grippers_of(const Model& model);

// `at` and `rpy` of a node: a place in the link that its `frame` names.
Eigen::Isometry3d read_offset(const ConfigNode& node);

// The link of the URDF called so, in the link it was merged into.  Throws std::runtime_error that begins with `where`, with the
// nearest name.
const Frame& frame_called(const Model& model, const std::string& name, const std::string& where);

}  // namespace twinbus
