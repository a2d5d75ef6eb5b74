// Scenes for arms of any size: where what they are about is put, that the arm begins clear of it and reaches its goals.
//
// Places are given in lengths of the stretched arm from its shoulder.  Around a given arm they are turned about the shoulder, shifted up
// or down, made smaller, and hands turned otherwise, each no more than is needed, in this order:
//
//     the places turned about the upright; hands turned about where they point; higher or lower; smaller; hands pointing otherwise
//
// until the arm begins clear of all, and each goal is answered by a posture that is clear too and that its joints can hold.

#pragma once

#include <string>

#include "robot/description/model.h"
#include "robot/kinematics/arm_span.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

// The arm while the robot is as the scene starts it, in the ground frame.
ArmSpan arm_in_scene(const Scene& scene, const Model& model, const Hand& hand);

// Which joint of an arm on a fixed base cannot hold it where the scene begins, and what helps; empty when all can.
std::string begins_too_heavy(const Scene& scene, const Model& model);

// What is given in lengths of the right arm, or the only one, in metres from then on, and the reach of goals as the arm can do it.
// What was changed is said in Scene::scaled.  Throws std::runtime_error if the robot has no arm, or one that cannot do it.
void measure_by_arm(Scene& scene, const Model& model);

}  // namespace twinbus::sim
