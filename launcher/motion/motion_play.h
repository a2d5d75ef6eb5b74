// Plays a motion on a running stack: says its pieces on MOTION a little ahead of their time, and waits for its end.

#pragma once

#include "launcher/bus/bus_link.h"
#include "robot/description/model.h"
#include "robot/motion/motion_clip.h"

namespace twinbus::inline launcher {

// Exit status.  Throws std::runtime_error when nothing runs, or another robot than model.
int play_motion(BusLink& bus, const Model& model, const MotionClip& clip);

}  // namespace twinbus::launcher
