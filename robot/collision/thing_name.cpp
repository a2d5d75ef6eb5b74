#include "robot/collision/thing_name.h"

#include <cmath>
#include <cstdio>

#include "common/math/index.h"

namespace twinbus::inline robot {

bool is_floor(const Obstacle& obstacle) noexcept {
  constexpr double kWide = 2.0, kLevel = 1e-3;  // [m]; [m, rad]
  return obstacle.shape == ObstacleShape::kBox && obstacle.hand < 0 && obstacle.size.head<2>().maxCoeff() > kWide &&
         obstacle.pose.linear()(2, 2) > 1.0 - 0.5 * kLevel * kLevel &&
         std::abs(obstacle.pose.translation().z() + 0.5 * obstacle.size.z()) < kLevel;
}

ThingName thing_name(const Model& model, const std::vector<Obstacle>& obstacles, int index) noexcept {
  ThingName name{};
  const auto is = [&](const char* what) { std::snprintf(name.data(), name.size(), "%s", what); };
  if (index >= 0 && index < model.link_count()) {
    is(model.links[at(index)].name.c_str());
    return name;
  }
  int seen = model.link_count(), number = 0;
  for (const Obstacle& obstacle : obstacles) {
    if (!takes_part(obstacle, model)) continue;
    const bool floor = is_floor(obstacle);
    number += !floor && obstacle.hand < 0 ? 1 : 0;
    if (seen++ != index) continue;
    if (floor) is("the floor");
    else if (obstacle.hand == 0 || obstacle.hand == 1) is(obstacle.hand == 0 ? "what the left hand holds" : "what the right hand holds");
    else if (obstacle.hand >= 0) std::snprintf(name.data(), name.size(), "what %s holds", hand_of(model, obstacle.hand)->name.c_str());
    else std::snprintf(name.data(), name.size(), "obstacle %d", number);
    return name;
  }
  is(index < 0 ? "?" : "an obstacle");
  return name;
}

}  // namespace twinbus::robot
