// How much of a scene is modelled.
//
//   fidelity: full     everything (the default)
//   fidelity: auto     no more than the accuracy asked for needs: `run` finds out what (launcher/run/less.h); elsewhere full
//   fidelity: legs     the joints of the legs move, all others are held in the posture of the start
//   fidelity: rigid    no joint moves: the robot is one rigid body
//   held: [JOINT, ...]   these joints are held too, whatever the word says; `base` holds the base, the name of a further robot all of it
//   asleep: true         loose bodies that lie still are not modelled until something touches them (sim/objects/rigid_object_sleep.cpp)
//   untouched: [LINK, ...]  these links of the robot meet nothing loose and no further robot
//   aloft: [LINK, ...]   of these links nothing but their soles touches the ground or an obstacle
//   rigid: [ROBOT, ...]  these further robots are one rigid body each
//
// `asleep`, `aloft` and `untouched` are of engine articulated.
// A held joint is at rest where it began, whatever is commanded; what follows it or leads it is held with it.  A held base stays
// where it began, the soles feeling what they felt then: with all joints held nothing can move the robot, and what touches it meets something fixed.

#pragma once

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline sim {

inline constexpr const char* kFidelityNames[] = {"full", "auto", "legs", "rigid"};

// Fills config.held, the joints or joints, base and further robots, config.aloft, config.untouched and config.rigid_robots; config.robots are those of the
// scene.  Throws std::runtime_error for a joint or robot that is not there, naming the nearest, for a name in `held` that
// fits two things, and for `legs` of a robot that has none.
void apply_fidelity(const Scene& scene, const Model& model, WorldConfig& config);

}  // namespace twinbus::sim
