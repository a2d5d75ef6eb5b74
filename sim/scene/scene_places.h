// Places of a robot by what they are, for scenes that are for more than one robot: a push on the chest, a grasp of the
// left hand.
//
// A link or joint of that very name wins; then
//
//     base, chest (the last link common to both arms), head, left_hand, right_hand, left_foot, right_foot
//     left_ankle_pitch, right_ankle_pitch, left_knee, right_knee: joints of the legs

#pragma once

#include <string>

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

// Index in links; -1: the robot has no such place.
int find_place(const Model& model, const std::string& name);
// Index in joints; -1: the robot has no such joint.
int find_joint_place(const Model& model, const std::string& name);

// Gives pushes, bodies, grasps and criteria of a scene the names that the robot has for them; what it has no place for
// stays as it is.  A robot with one hand uses it for either; one whose base is fixed holds where others balance.
void name_places(Scene& scene, const Model& model);

}  // namespace twinbus::sim
