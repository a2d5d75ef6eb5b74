// Coulomb friction of a joint: its own and what a world adds to every one.

#pragma once

#include <algorithm>

#include "robot/description/model.h"
#include "sim/world/world.h"

namespace twinbus::inline sim {

// [N m or N].  What is added is at most a share of the effort limit: a wrist has no ankle's friction.
inline double coulomb_friction(const Joint& joint, const WorldConfig& config) noexcept {
  double added = config.joint_friction;
  if (joint.effort > 0.0) added = std::min(added, config.joint_friction_share * joint.effort);
  return joint.friction * config.friction_scale + added;
}

}  // namespace twinbus::sim
