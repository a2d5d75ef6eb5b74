// Rules of a message that tie fields to one another; those of a single field stand behind it in the .lcm file.
//
// Only convert.cpp includes it.

#pragma once

#include <cstddef>

#include "lcmtypes/bus/field_copier.h"
#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline lcmtypes {

template <class C, class S>
void cross_rules(C&, const S&) noexcept {}

template <class C>
void cross_rules(C& c, const RobotState& s) noexcept {
  if ((s.sensor_flags & kImuValid) != 0) c.require_rotation(s.attitude);
}

template <class C>
void cross_rules(C& c, const ArmGoal& s) noexcept {
  if (s.kind == ArmGoalKind::kPose) c.require_rotation(s.orientation);
}

// Columns in use have a joint, and time does not go back.
template <class C>
void cross_rules(C& c, const ArmPathPiece& s) noexcept {
  for (int i = 0; i < s.joint_count && i < kArmJoints; ++i) c.require(s.joint[static_cast<std::size_t>(i)] >= 0);
  double before = 0;
  for (int i = 0; i < s.knot_count && i < kKnotsPerPiece; ++i) {
    const double time = s.time[static_cast<std::size_t>(i)];
    c.require(time >= before);
    before = time;
  }
}

template <class C>
void cross_rules(C& c, const ObstaclesPiece& s) noexcept {
  for (std::size_t i = 0; i < kObstaclesPerPiece && static_cast<int>(i) < s.count; ++i) {
    c.require_rotation(s.attitude[i]);
    c.judge(s.size[i], 0.0f, static_cast<float>(kLargestNumber));
  }
}

}  // namespace twinbus::lcmtypes
