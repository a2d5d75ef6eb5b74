// A list of footsteps, step_list_t: each where the standing foot's sole frame is then; the feet take turns.
//
// As a file or in a scene: `steps: [{foot: left, x: 0.2, y: 0.2, yaw: 0}, {foot: right, x: 0.2, y: -0.2}]`.

#pragma once

#include <array>
#include <cstdint>

#include "common/text/strict_yaml.h"

namespace twinbus {

inline constexpr int kMostSteps = 32;

enum class FootSide : std::int8_t { kNone = 0, kLeft = 1, kRight = 2 };

struct StepList {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int32_t sequence = 0;
  std::int16_t count = 0;
  FootSide first_foot = FootSide::kNone;
  std::array<float, kMostSteps> x{};
  std::array<float, kMostSteps> y{};
  std::array<float, kMostSteps> yaw{};
};

// The key `steps` of a map.  Throws std::runtime_error naming file, line and key.
StepList read_steps(const ConfigNode& node);

}  // namespace twinbus
