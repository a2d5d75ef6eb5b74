#include "sim/scene/scene_requests.h"

#include <algorithm>

namespace twinbus::inline sim {

SceneRequests requests_of(const Scene& scene) {
  SceneRequests all;
  all.modes.assign(scene.modes.begin(), scene.modes.end());
  all.goals.assign(scene.goals.begin(), scene.goals.end());
  all.walks = scene.walks;
  all.pads = scene.pads;
  all.steps = scene.steps;
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

}  // namespace twinbus::sim
