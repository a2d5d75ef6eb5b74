// Writes a URDF as people read it: one element a line, indented.

#pragma once

#include <Eigen/Geometry>
#include <string>

namespace twinbus::inline robot {

// All digits, so that reading gives the same number.
std::string exact_number(double value);
std::string exact_numbers(const Eigen::Vector3d& v);
// <origin xyz= rpy=/>
std::string urdf_origin(const Eigen::Isometry3d& place);

}  // namespace twinbus::robot
