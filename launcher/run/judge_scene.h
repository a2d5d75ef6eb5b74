// Judges a run in one process by its scene's own criteria.

#pragma once

#include <cstdint>
#include <string>

#include "common/process/arguments.h"
#include "launcher/run/fit_scene.h"
#include "launcher/run/local_stack.h"
#include "launcher/run/verdict.h"
#include "sim/scene/scene.h"

namespace twinbus::inline launcher {

// What `command` is asked for on this scene: its name, --robot, --engine and --seed.  Throws UsageError for an engine that
// there is not.
RunRequest request_of(const std::string& command, const Arguments& arguments, const Scene& scene);

// part: only the beginning of the scene was run.  What is asked of its end, or was not measured by then, is left out and named
// in left_out.
RunVerdict judge_scene(const OneProcess& run, const Criteria& asked, std::int64_t ticks, bool part = false);

// Lines for people: how it stood and, if it did, how it walked.
std::string scene_figures(const OneProcess& run, const Criteria& asked);

}  // namespace twinbus::launcher
