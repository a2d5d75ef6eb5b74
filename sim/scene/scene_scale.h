// Scenes are written for a robot of a certain size; another one that was proposed by `check` gets them in its own measure.
//
//     speeds    sqrt(l / l0), and at most kOfFastest of what its robot.yaml says it walks (walking.fastest); those to the side and of
//               turning times w / w0 too, for the edges of narrow soles are near
//     steps     l / l0
//     heights   l / l0
//     impulses  m / m0 times the smaller of sqrt(l / l0) and a / a0 sqrt(l0 / l)
//               to the side that, or with b for a, if that is less
//     motions   a sway by as much as impulses to the side, a squat l / l0
//     masses    m / m0, in a hand that is held farther before the robot as much less as its moment is more;
//               what a hand grips from the start lies in this robot's hand
//
// l: hip to ground, m: mass, a: length of a sole, w: its width, b: from between the feet to an outer edge in half_sitting, index 0: of the robot
// that the scene names.  Nothing grows.

#pragma once

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

// From the first joint of a leg to the ground in the zero posture [m]; 0 without two soles.
double leg_length_of(const Model& model);

// Of robots whose robot.yaml has walking.fastest; others, and the scene's own, keep it as it is.  Says what it did in
// Scene::scaled.
void scale_to(Scene& scene, const Model& model);

// The same for a scene that was written for `own`.
void scale_between(Scene& scene, const Model& own, const Model& model);

}  // namespace twinbus::sim
