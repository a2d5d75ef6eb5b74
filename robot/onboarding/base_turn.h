// Robots whose base does not have z up and x forward: found by their legs and what these are called.

#pragma once

#include <Eigen/Core>
#include <string>

#include "robot/description/model.h"

namespace twinbus {

// From the base of the file to one that is upright and looks along x.  The identity unless six-joint
// legs are found, named left and right as they lie, only with the base turned.
Eigen::Matrix3d find_base_turn(const Model& model);

// 1: left, -1: right, 0: the name says neither.
int side_of_name(const std::string& name);

// The URDF with a link `upright_base` above its root, which it turns by a fixed joint.
std::string with_upright_base(const std::string& urdf_text, const std::string& root_link,
                              const Eigen::Matrix3d& turn);

}  // namespace twinbus
