// What several readers of scene files share.

#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string>
#include <vector>

#include "robot/config_node.h"

namespace twinbus {

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline Eigen::Vector3d vector3(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

// fallback null: the key must be there.
inline Eigen::Vector3d bounded(const ConfigNode& node, const std::string& key, double bound,
                               const Eigen::Vector3d* fallback) {
  if (fallback != nullptr && !node.has(key)) return *fallback;
  const Eigen::Vector3d v = vector3(node.numbers(key, 3));
  if (!(v.cwiseAbs().maxCoeff() <= bound)) {
    node.fail(key, "every number must be within +-" + std::to_string(static_cast<int>(bound)));
  }
  return v;
}

// rpy_deg: about x, then y, then z of the parent.
inline Eigen::Quaterniond rpy(const ConfigNode& node) {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  const Eigen::Vector3d angle = kDegree * bounded(node, "rpy_deg", 360.0, &zero);
  return Eigen::AngleAxisd(angle.z(), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angle.y(), Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angle.x(), Eigen::Vector3d::UnitX());
}

}  // namespace twinbus
