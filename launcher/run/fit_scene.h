// A scene for this robot: whether it applies, what is asked of the robot and what of the run.

#pragma once

#include <string>

#include "robot/description/model.h"
#include "sim/scene/scene.h"

namespace twinbus::inline launcher {

// Criteria as they are asked of this robot: of the ZMP's margin no more than half of what its soles
// can give; of a robot that walks, and so stands on one foot, in proportion to soles narrower than 130 mm or shorter than 220;
// a sole that is narrower may tilt more, until its edge is as deep.
Criteria for_robot(Criteria criteria, const Model& model, bool walks = false);

// What the scene needs and this robot does not have, as one sentence; empty when the scene is for it.  The names in the
// scene must have been resolved (resolve_poses).
std::string why_not_for(const Scene& scene, const Model& model);

// The same of a scene as it was read.  Throws std::runtime_error where a pose, a motion or a place of it cannot be resolved.
std::string why_scene_is_not_for(Scene scene, const Model& model);

// Throws std::runtime_error when a motion of the scene is not fit to be played (control/motion/motion_check.h): the first fault.
void check_motions(const Scene& scene, const Model& model);

// Names resolved, motions checked, velocities cut to what a proposed robot can, and criteria as this robot's soles make them.
// Throws std::runtime_error with that sentence.
void fit_scene(Scene& scene, const Model& model);

}  // namespace twinbus::launcher
