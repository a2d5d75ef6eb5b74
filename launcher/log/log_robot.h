// Which robot a log is of, so that tables and pictures have the names of its joints.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robot/description/model.h"

namespace twinbus::inline launcher {

// Of the first STATE on this channel; 0: there is none near its beginning.  Throws std::runtime_error naming the log.
std::int64_t model_hash_of_log(const std::string& file, const std::string& channel);

// The robot of this hash: the one that was asked for, or one of config/robots.  Nothing when it is none of them; throws
// only when the one asked for cannot be loaded.
std::optional<Model> robot_of_hash(std::int64_t hash, const std::string& asked);

// "q[3]" -> "q.LLEG_KNEE" for q, qd, tau, kp and kd; others stay.
std::string field_with_joint(const std::string& field, const Model& model);

}  // namespace twinbus::launcher
