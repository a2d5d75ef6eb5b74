// Points, vectors and turns as scenes write them.

#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <string>

#include "common/text/strict_yaml.h"

namespace twinbus::inline sim {

inline constexpr double kDegree = std::numbers::pi / 180.0;

// Every number within +-bound; fallback: where the key is missing, null: it must be there.  Throws
// std::runtime_error naming file, line and key.
Eigen::Vector3d bounded(const ConfigNode& node, const std::string& key, double bound,
                        const Eigen::Vector3d* fallback);

// Key rpy_deg: about x, then y, then z; none: no turn.
Eigen::Quaterniond rpy(const ConfigNode& node);

}  // namespace twinbus::sim
