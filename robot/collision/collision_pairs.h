// Which pairs of links are worth checking: all that bear geometry, but neighbours and the SRDF's
// disabled pairs.

#pragma once

#include <vector>

#include "robot/collision/collision.h"
#include "robot/description/model.h"

namespace twinbus::inline robot {

// Neighbours: the nearest ancestor of one that bears any geometry is the other, or a loop of
// robot.yaml pins one to the other.
std::vector<CollisionPair> pairs_to_check(const Model& model);

// Does joint j move link a with respect to link b (b < 0: with respect to the base, which obstacles
// stand still with)?
bool joint_moves_pair(const Model& model, int joint, int link_a, int link_b);

// Is the link that one, or does it hang on it, as fingers do on a hand?
bool hangs_on(const Model& model, int link, int on);

// Of a base that moves on the plane: a link of no arm is always as high above the ground, on which the base stands, so the two are no
// pair.  The ground: a wide level slab whose middle is below z = 0, also one that is taken for a little thicker.
bool stays_above_ground(const Model& model, int link);
bool is_ground(const Obstacle& obstacle) noexcept;

}  // namespace twinbus::robot
