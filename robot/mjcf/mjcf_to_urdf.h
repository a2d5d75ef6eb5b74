// A robot of an MJCF model: URDF, SRDF and what robot.yaml says beside them.
//
// Of several bodies in the world the one that floats and has joints is the robot, else all that hang on the world by joints;
// the rest is scenery.  A body with several joints becomes as many links in a row.  A link's frame is where its (last) joint
// is anchored; joint angles count from MuJoCo's `ref`.

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "robot/mjcf/mjcf_model.h"

namespace twinbus::inline robot {

struct MjcfServo {
  std::string joint;
  double kp = 0.0, kd = 0.0;  // [N m/rad], [N m s/rad] or N/m, N s/m; of all its actuators
};

struct MjcfRobot {
  std::string urdf, srdf;
  bool floating = false;
  std::string imu;                                       // a link of the URDF; empty: not said
  std::vector<MjcfServo> servos;                         // of joints that an actuator holds
  std::vector<std::pair<std::string, double>> friction;  // links and the largest sliding friction of their contact geoms
  MujocoConfig mujoco;  // solver and contacts with the ground
  std::vector<std::string> notes;                        // what is not modelled, or was chosen
};

// Throws std::runtime_error, one line with file and line, when no robot can be made of it.
MjcfRobot robot_of_mjcf(const MjcfModel& model, const std::string& file);
// Reads the file too.
MjcfRobot import_mjcf(const std::string& file);

inline constexpr double kMjcfVelocity = 30.0;     // of hinges, which MJCF does not limit [rad/s]
inline constexpr double kMjcfSlideVelocity = 5.0;  // [m/s]
inline constexpr double kMjcfEffort = 1000.0;     // where the model has no limit [N m or N]
inline constexpr double kMjcfTravel = 100.0;      // of slides without limits [m]

}  // namespace twinbus::robot
