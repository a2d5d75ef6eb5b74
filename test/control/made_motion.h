// Motions of hrp1s that tests make: what a shape adds to half_sitting, 50 frames a second.

#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "robot/motion/motion_file.h"
#include "test/control/hrp1s.h"

namespace twinbus::test {

using JointAngles = std::vector<std::pair<std::string, double>>;
using MotionShape = std::function<void(double time, JointAngles& joints)>;

inline MotionFile made_motion(double seconds, const MotionShape& shape) {
  const Model& model = hrp1s();
  const std::vector<double>& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
  MotionFile file;
  file.file = "made";
  JointAngles joints;
  shape(0.0, joints);
  for (const auto& [name, angle] : joints) file.joints.push_back(name);
  for (int i = 0; 0.02 * i <= seconds + 1e-9; ++i) {
    joints.clear();
    shape(0.02 * i, joints);
    file.time.push_back(0.02 * i);
    for (const auto& [name, angle] : joints) file.q.push_back(pose[static_cast<std::size_t>(model.find_joint(name))] + angle);
  }
  return file;
}

// 0 to 1 and back in two seconds.
inline double wave(double time) { return 0.5 * (1.0 - std::cos(M_PI * time)); }

// Hip, knee and ankle so that sole and trunk stay level and the trunk over the sole, as in half_sitting.
inline void squat(double time, JointAngles& joints) {
  const double knee = 0.3 * wave(time);
  for (const char* side : {"L", "R"}) {
    joints.emplace_back(std::string(side) + "LEG_HIP_P", -0.46 * knee);
    joints.emplace_back(std::string(side) + "LEG_KNEE", knee);
    joints.emplace_back(std::string(side) + "LEG_ANKLE_P", -0.54 * knee);
  }
}

inline void wave_arm(double time, JointAngles& joints) {
  joints.emplace_back("RARM_SHOULDER_R", -0.8 * wave(time));
  joints.emplace_back("RARM_ELBOW", -0.5 * wave(time));
}

}  // namespace twinbus::test
