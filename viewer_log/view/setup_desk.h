// What a page needs to set up a stack anew, and where its wish goes: files of the run folder that `up` owns.

#pragma once

#include <string>

#include "robot/description/model.h"

namespace twinbus::inline viewer_log {

// JSON: scenes with what they are about, poses, joints with their limits, links, frames, soles, hands and IMU, pairs that are not checked.
std::string setup_choices(const Model& model, const std::string& scenes_folder);

// Lays the wish where `up` looks.  A sentence when it cannot be; folder empty: nobody looks.
std::string lay_wish(const std::string& folder, const std::string& wish);

}  // namespace twinbus::viewer_log
