// What passes between a robot and whoever moves it: RobotState, which it can measure, and JointCommand, which it obeys.
//
// Arrays have the bus's fixed size; only the first joint_count entries mean anything, the rest is zero.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/messages.h"

namespace twinbus::inline lcmtypes {

// Rows of RobotState::wrench: the feet in the order of Estimate, then the hands.
enum Limb : int { kLeftFoot = 0, kRightFoot = 1, kLeftHand = kMaxFeet, kRightHand, kLimbs };

// Bits of RobotState::sensor_flags.
inline constexpr std::int32_t kEncodersValid = 1 << 0;
inline constexpr std::int32_t kImuValid = 1 << 1;
inline constexpr std::int32_t wrench_valid(Limb limb) {
  return 1 << (limb <= kRightFoot ? 2 + limb : limb < kLeftHand ? 4 + limb : 4 + limb - kLeftHand);
}

template <class T>
using PerJoint = std::array<T, kMaxJoints>;

// Bits of JointCommand::flags.
inline constexpr std::int16_t kCommandStopping = 1;
inline constexpr std::int16_t kCommandNoFade = 2;  // not faded in: begins where the set-point is

}  // namespace twinbus::lcmtypes
