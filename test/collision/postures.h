// Postures of hrp1s for tests: named ones, and random ones within the joint limits.

#pragma once

#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>

#include "robot/kinematics/kinematics.h"
#include "robot/description/load.h"
#include "robot/description/model.h"

namespace twinbus {

inline const Model& hrp1s() {
  static const Model model = load_robot("hrp1s");
  return model;
}

inline Configuration named_posture(const Model& model, const std::string& name) {
  Configuration configuration(model);
  const int pose = model.find_pose(name);
  if (pose < 0) throw std::runtime_error("no pose " + name);
  const auto& q = model.poses[static_cast<std::size_t>(pose)].q;
  for (int j = 0; j < model.joint_count(); ++j) configuration.q[j] = q[static_cast<std::size_t>(j)];
  return configuration;
}

// share: of the way from `center` to the limits.
inline Configuration random_posture(const Model& model, const Configuration& center, double share,
                                    std::mt19937_64& random) {
  Configuration configuration = center;
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    const double q = std::uniform_real_distribution<double>(joint.lower, joint.upper)(random);
    configuration.q[j] = center.q[j] + share * (q - center.q[j]);
  }
  return configuration;
}

}  // namespace twinbus
