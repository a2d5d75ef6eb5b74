// What stands, lies and moves around the robot, as JSON for the page.

#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>

#include "viewer_log/view/frame_number.h"
#include "viewer_log/view/stack_view.h"

namespace twinbus::inline viewer_log {

// Obstacles, terrain and the shapes of loose bodies and of what hands hold.  place: from the world of the view to the one that is drawn.
std::string scene_frame(const StackView& view,
                        const Eigen::Isometry3d& place = Eigen::Isometry3d::Identity());

// To a live frame: where the loose bodies are, in the order of their shapes, and the footsteps to come.
void add_moving(const StackView& view, std::int64_t now_ns, const Eigen::Isometry3d& place,
                Json& frame);

}  // namespace twinbus::viewer_log
