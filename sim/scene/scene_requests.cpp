#include "sim/scene/scene_requests.h"

namespace twinbus {

SceneRequests requests_of(const Scene& scene) {
  SceneRequests all;
  for (const TimedMode& mode : scene.modes) all.modes.push_back({mode.at, 0.0, mode.request});
  for (const TimedGoal& goal : scene.goals) all.goals.push_back({goal.at, 0.0, goal.goal});
  for (const TimedWalk& walk : scene.walks) all.walks.push_back({walk.at, walk.duration, walk.command});
  for (const TimedPad& pad : scene.pads) all.pads.push_back({pad.at, pad.duration, pad.pad});
  for (const TimedSteps& timed : scene.steps) all.steps.push_back({timed.at, 0.0, timed.list});
  return all;
}

}  // namespace twinbus
