// Joint cells kept on disk by the robot that they are of (disk_cache.h): found once, in seconds, then
// read in milliseconds.
//
// The name of the file stands for all that they depend on: every mesh, joint, limit and pair, and the
// code that finds them.  Whether a free cell is rightly free cannot be proved again in milliseconds:
// the file must be whole, fit the robot in every number, and agree with the triangles at random
// postures.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robot/collision/exact/self_collision.h"

namespace twinbus::inline robot {

// Lets `check`, of this robot, use what is kept; false when nothing is.
bool use_kept_cells(const Model& model, const RobotGeometry& geometry, SelfCollision& check);

// The same, finding and keeping them.  progress: called before each pair.
void find_and_keep_cells(const Model& model, const RobotGeometry& geometry, SelfCollision& check,
                         const std::function<void(int done)>& progress = {});

// The bytes that are kept, and back; nothing, and why, when they do not fit.
std::string packed_cells(const std::vector<JointCells>& cells);
std::optional<std::vector<JointCells>> unpack_cells(const std::string& bytes, const Model& model,
                                                    const RobotGeometry& geometry,
                                                    const std::vector<CollisionPair>& pairs,
                                                    std::string& why);

}  // namespace twinbus::robot
