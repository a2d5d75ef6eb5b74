// A stop plan in pieces, stop_plan_t: where the robot's motion leads if its controller falls silent.
//
// Numbers of a knot are rounded to 16 bits; robot/stop_plan turns them into set-points.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus::inline lcmtypes {

inline constexpr int kPlanKnotsPerPiece = std::tuple_size_v<decltype(StopPlanPiece::phase)>;
inline constexpr int kMostPlanPieces = 8;
inline constexpr int kMostPlanKnots = kPlanKnotsPerPiece * kMostPlanPieces;
inline constexpr double kPlanPosition = 2e-4;  // [rad or m] per unit of q
inline constexpr double kPlanTorque = 0.05;    // [N m or N] per unit of tau
inline constexpr double kPlanBalance = 1e-4;   // [m, rad, 1] per unit of balance

// Columns of a row of balance.
enum PlanColumn : int {
  kPlanDcm = 0,       // x, y
  kPlanCom = 2,       // x, y
  kPlanZmp = 4,       // x, y
  kPlanAttitude = 6,  // rotation vector of the base
  kPlanLeft = 9,      // load share of the left foot
  kPlanSoles = 10,    // left x, y, yaw, right x, y, yaw
  kPlanColumns = 16
};

// Bits of a phase.
inline constexpr std::int8_t kPlanSingle = 1, kPlanOnRight = 2;

using PlanRow = std::array<std::int16_t, kMaxJoints>;
using PlanBalanceRow = std::array<std::int16_t, kPlanColumns>;

}  // namespace twinbus::lcmtypes
