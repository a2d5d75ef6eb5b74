// What an index of a pair is called, so that whoever reads it finds it again: a link's name; of what stands around and is held,
// as in OBSTACLES and HELD, "the floor", "what the left hand holds", or "obstacle N", counted from 1 without those.

#pragma once

#include <array>
#include <vector>

#include "robot/collision/collision.h"

namespace twinbus::inline robot {

using ThingName = std::array<char, 64>;  // zero-terminated

// A level slab with its top in the ground, of metres: the ground itself, for planner and guard.
bool is_floor(const Obstacle& obstacle) noexcept;

// index: as in CollisionPair.
ThingName thing_name(const Model& model, const std::vector<Obstacle>& obstacles, int index) noexcept;

}  // namespace twinbus::robot
