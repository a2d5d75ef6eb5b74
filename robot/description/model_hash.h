// doc/protocol.md section 7: a number that two processes compare to know that they mean the same robot.

#pragma once

#include <cstdint>

#include "robot/description/model.h"

namespace twinbus::inline robot {

// Of names, order, axes, limits, inertias, sensors and collision geometry (mesh files by content).
// 1 <= hash < 2^53.
std::int64_t model_hash(const Model& model);

}  // namespace twinbus::robot
