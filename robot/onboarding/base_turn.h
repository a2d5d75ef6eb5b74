// Robots whose base does not have z up and x forward, found by their legs and what these are called; and robots on a fixed base
// that reach below it.

#pragma once

#include <Eigen/Geometry>
#include <string>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// From the base of the file to one that is upright and looks along x.  The identity unless legs of five
// joints or more are found, named left and right as they lie, only with the base turned.
Eigen::Matrix3d find_base_turn(const Model& model);

// 1: left, -1: right, 0: the name says neither.
int side_of_name(const std::string& name);

// How far a robot on a fixed base is to stand above the ground, which lies at the origin of its file [m]: as far as its trunk reaches
// below it, or, a little above the ground, two arms that hang, or one that no lift of its joints raises; a hand alone so that no
// finger can reach the ground.  0: it is not.
double height_of_stand(const Model& model);

// `wanted`, or it with a number, for with_root_above: no link or joint of the URDF has that name or that of its joint.
std::string free_root_name(const std::string& urdf_text, const std::string& file, const std::string& wanted);

// The URDF with a new link above its root, which a fixed joint NEW_ROOT_joint puts at `pose` in it; `why` is a comment.
std::string with_root_above(const std::string& urdf_text, const std::string& root_link, const std::string& new_root,
                            const Eigen::Isometry3d& pose, const std::string& why);

// A joint of type floating below a root link that is nothing else (no mass, no geometry, nothing else hangs on it) says in a URDF what
// robot.yaml says with `base: floating`: the text without both, and their names in `left_out`; else the text as it is.
std::string without_floating_root(const std::string& urdf_text, const std::string& file, std::string& left_out);

}  // namespace twinbus::robot
