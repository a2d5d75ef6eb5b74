// Judges a run in one process by its scene's own criteria.

#pragma once

#include <cstdint>
#include <string>

#include "common/process/arguments.h"
#include "launcher/run/local_stack.h"
#include "launcher/run/verdict.h"
#include "sim/scene/scene.h"

namespace twinbus {

// What `command` is asked for on this scene: its name, --robot, --engine and --seed.  Throws UsageError for an engine that
// there is not.
RunRequest request_of(const std::string& command, const Arguments& arguments, const Scene& scene);

// Criteria as they are asked of this robot: of the ZMP's margin no more than half of what its soles
// can give; of a robot that walks, and so stands on one foot, in proportion to soles narrower than 130 mm or shorter than 220.
Criteria for_robot(Criteria criteria, const Model& model, bool walks = false);

// part: only the beginning of the scene was run.  What is asked of its end, or was not measured by then, is left out and named
// in left_out.
RunVerdict judge_scene(const OneProcess& run, const Criteria& asked, std::int64_t ticks, bool part = false);

// Lines for people: how it stood and, if it did, how it walked.
std::string scene_figures(const OneProcess& run, const Criteria& asked);

// What the scene needs and this robot does not have, as one sentence; empty when the scene is for it.  The names in the
// scene must have been resolved (resolve_poses).
std::string why_not_for(const Scene& scene, const Model& model);

// Throws std::runtime_error when a motion of the scene is not fit to be played (control/motion/motion_check.h): the first fault.
void check_motions(const Scene& scene, const Model& model);

// Names resolved, motions checked and criteria as this robot's soles make them.  Throws std::runtime_error with that sentence.
void fit_scene(Scene& scene, const Model& model);

}  // namespace twinbus
