// A list of footsteps, step_list_t: each where the standing foot's sole frame is then; the feet take turns.
//
// As a file or in a scene: `steps: [{foot: left, x: 0.2, y: 0.2, yaw: 0}, {foot: right, x: 0.2, y: -0.2}]`.

#pragma once

#include "common/text/strict_yaml.h"
#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// The key `steps` of a map.  Throws std::runtime_error naming file, line and key.
StepList read_steps(const ConfigNode& node);

}  // namespace twinbus::lcmtypes
