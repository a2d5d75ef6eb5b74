// What `check` says of joints that two motors turn over rods: range, torque at the standing posture, distance from singular.

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "robot/description/model.h"

namespace twinbus::inline launcher {

void print_parallel_joints(const Model& model);
// A list, one entry a pair: joints, motors, range, torque at the standing posture [N m], speed [rad/s].
nlohmann::json parallel_joints_json(const Model& model);

}  // namespace twinbus::launcher
