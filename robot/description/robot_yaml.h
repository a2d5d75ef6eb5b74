// robot.yaml: what URDF and SRDF cannot say.  Names of links and joints are still text here;
// load.cpp resolves them.

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/text/strict_yaml.h"
#include "robot/description/model.h"
#include "robot/description/parallel_joints.h"
#include "robot/description/urdf.h"

namespace twinbus::inline robot {

// Servo numbers of one or more joints; NaN where not said.
struct ServoEntry {
  std::vector<std::string> joints;
  double kp, kd, stop_kp, stop_kd, rate, rotor_inertia, friction, damping;
  ConfigNode node;
};

// Joints without a motor, as of toes: the list `passive_joints`.
//   - {joints: [toe_l, toe_r], stiffness: 20, damping: 0.5, rest: 0}   # [N m/rad, N m s/rad, rad]
// The simulator turns them by spring, damper, friction and stops alone.  Nobody measures or commands them: they are not on the bus, and
// whoever computes with the model takes them at rest, as joints that follow another one by 0 times its angle.
struct PassiveEntry {
  std::vector<std::string> joints;
  double stiffness = 0.0, damping = 0.0, rest = 0.0;
  std::string where;
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
  std::vector<std::string> joints, carried_by;
  std::string where;  // of carried_by: file, line and key
};

// Links that the robot's own shape keeps near each other: robot/collision/near_pairs.h.
struct NearPairEntry {
  std::array<std::string, 2> links;
  double margin = 0.0;  // [m]
  std::string where;    // file, line and key
};

// Of the map `grippers`, one group a hand, by its name under `hands`; joints that follow another (<mimic>) move with it and are not named:
//   right: {joints: [finger_joint1], open: [0.04], closed: [0]}   # [rad or m]
struct GripperEntry {
  std::size_t hand = 0;  // its number
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
  // `base: planar`, and of the map `planar`: {area: 3, speed: 0.5, turn_speed: 1, height: 0}
  std::optional<PlaneBase> plane;
  std::string imu_frame;
  Eigen::Isometry3d imu_offset = Eigen::Isometry3d::Identity();  // of the IMU in that link
  std::array<SoleEntry, 2> soles;
  std::array<HandEntry, 2> hands;
  std::vector<std::pair<std::string, HandEntry>> more_hands;  // by the names that robot.yaml gives them
  std::vector<std::string> leg_joints;
  std::vector<ServoEntry> servos;
  std::vector<PassiveEntry> passive_joints;
  Walking walking;
  std::vector<Loop> loops;
  std::vector<ParallelEntry> parallel_joints;
  std::vector<NearPairEntry> near_pairs;
  std::vector<Tool> tools;
  std::vector<GripperEntry> grippers;
  MujocoConfig mujoco;
  std::string mujoco_contacts;  // file, line and key
  Model timing;  // period, timeouts, blend and off action only
};

// Throws std::runtime_error naming file, line and the nearest valid key.
RobotYaml parse_robot_yaml(const std::string& text, const std::string& file);
// The map `walking`.  Throws std::runtime_error naming file, line and key.
Walking read_walking(const ConfigNode& node);
// Of a model whose joints and hands are known, by the number of the hand.  Throws std::runtime_error naming file, line and key.
std::array<Gripper, kMostHands> read_grippers(const RobotYaml& yaml, const Model& model);

}  // namespace twinbus::robot
