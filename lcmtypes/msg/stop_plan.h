// A stop plan in pieces, stop_plan_t: where the robot's motion leads if its controller falls silent.
//
// Numbers of a knot are rounded to 16 bits; robot/stop_plan turns them into set-points.

#pragma once

#include <array>
#include <cstdint>

#include "lcmtypes/msg/robot_io.h"

namespace twinbus {

inline constexpr int kPlanKnotsPerPiece = 5;
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

// The same in every piece of a plan.
struct StopPlanHead {
  std::int64_t run_id = 0;
  std::int64_t model_hash = 0;
  std::int64_t controller_id = 0;
  std::int64_t tick = 0;    // of knot 0
  std::int64_t joints = 0;  // bit per joint that the plan moves
  std::int32_t term = 0;
  std::int32_t number = 0;
  std::int16_t pieces = 0;
  std::int16_t knot_count = 0;
  std::int16_t spacing = 0;  // ticks from knot to knot
  std::int16_t joint_count = 0;
  bool walks = false;                                            // the rest counts
  float omega = 0.0F;                                            // [1/s]
  float mass = 0.0F;                                             // [kg]
  std::array<float, 2> sole_low{}, sole_high{}, sole_zmp{};      // [m]
  bool operator==(const StopPlanHead&) const = default;
};

using PlanRow = std::array<std::int16_t, kMaxJoints>;
using PlanBalanceRow = std::array<std::int16_t, kPlanColumns>;

struct StopPlanPiece {
  StopPlanHead head;
  std::int16_t piece = 0;
  std::array<std::int8_t, kPlanKnotsPerPiece> phase{};
  std::array<PlanRow, kPlanKnotsPerPiece> q{}, tau{};
  std::array<PlanBalanceRow, kPlanKnotsPerPiece> balance{};
};

}  // namespace twinbus
