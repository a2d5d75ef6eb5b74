// A piece of a motion, motion_t: some frames of all joints, of the centre of mass and of the trunk.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

inline constexpr int kFramesPerPiece = 6;

struct MotionPiece {
  std::int64_t utime = 0;
  std::int64_t sender_id = 0;
  std::int64_t run_id = 0;
  std::int64_t motion_id = 0;
  std::int64_t joint_mask = 0;
  std::int32_t sequence = 0;
  std::int32_t frames = 1;
  std::int32_t first = 0;
  std::int16_t joint_count = 0;
  std::int16_t count = 0;
  float period = 0.02F;
  float depth = 0;
  std::array<std::array<float, 3>, kFramesPerPiece> com{};
  std::array<std::array<float, 2>, kFramesPerPiece> tilt{};
  std::array<std::array<float, kMaxJoints>, kFramesPerPiece> q{};
};

}  // namespace twinbus
