// The folder of a robot written anew with what a page changed: soles, hands, IMU, pairs that are not checked, one more pose.
//
// Only robot.yaml and the SRDF differ from the robot it is made of.  The caller reads the folder back by load_robot(), which
// refuses what no robot can be.

#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace twinbus::inline launcher {

struct RobotChange {
  // JSON; every key may be left out, and every number of a limb, which then stays:
  //   {"soles": {"left": {"frame": "LFOOT", "at": [x, y, z], "rpy": [r, p, y], "front": f, "back": b, "left": l, "right": r}},
  //    "hands": {"right": {"frame": ..., "at": ..., "rpy": ...}}, "imu": {"frame": ..., "at": ..., "rpy": ...}}
  std::string limbs;
  std::vector<std::array<std::string, 2>> unchecked;   // links; all pairs that are not checked
  std::vector<std::pair<std::string, double>> joints;  // of the pose; none: no pose
};

[[noreturn]] void refuse_change(const std::string& why);  // throws std::runtime_error

constexpr char kPagePose[] = "set_on_page";

// Writes the folder `to`, which is removed first.  Throws std::runtime_error with one sentence that says what is wrong.
void copy_robot(const std::string& from, const std::string& to, const std::string& robot_name, const RobotChange& change);

// The text of robot.yaml with these limbs (as RobotChange has them) in the place of its own.  A sensor named beside a frame that is
// exchanged for another is left out: the limb's own frame is then that of the sensor.
std::string edited_robot_yaml(const std::string& yaml, const std::string& limbs);

// The SRDF text with these disabled pairs in the place of its own, and one more pose; no pose without joints.
std::string edited_srdf(const std::string& srdf, const std::string& robot,
                        const std::vector<std::array<std::string, 2>>& unchecked,
                        const std::string& pose,
                        const std::vector<std::pair<std::string, double>>& joints);

}  // namespace twinbus::launcher
