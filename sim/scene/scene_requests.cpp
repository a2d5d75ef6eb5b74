#include "sim/scene/scene_requests.h"

#include <algorithm>

namespace twinbus {

SceneRequests requests_of(const Scene& scene) {
  SceneRequests all;
  for (const TimedMode& mode : scene.modes) all.modes.push_back({mode.at, 0.0, mode.request});
  for (const TimedGoal& goal : scene.goals) all.goals.push_back({goal.at, 0.0, goal.goal});
  for (const TimedWalk& walk : scene.walks) all.walks.push_back({walk.at, walk.duration, walk.command});
  for (const TimedPad& pad : scene.pads) all.pads.push_back({pad.at, pad.duration, pad.pad});
  for (const TimedSteps& timed : scene.steps) all.steps.push_back({timed.at, 0.0, timed.list});
  constexpr double kLead = 0.5;  // before a frame is played, at the earliest [s]
  for (std::size_t m = 0; m < scene.motions.size(); ++m) {
    const TimedMotion& motion = scene.motions[m];
    for (MotionPiece piece : motion.pieces) {
      piece.motion_id = static_cast<std::int64_t>(m) + 1;
      all.motions.push_back({motion.at + std::max(0.0, piece.first * motion.period - kLead), 0.0, piece});
    }
  }
  return all;
}

}  // namespace twinbus
