// A whole stop plan, and the set-points of any tick of it.
//
// Between knots joints and torques follow cubics whose rates at the knots are central differences; what belongs to balance is
// interpolated linearly.

#pragma once

#include <Eigen/Core>
#include <array>

#include "lcmtypes/msg/stop_plan.h"

namespace twinbus::inline robot {

struct StopPlan {
  StopPlanHead head;
  std::array<std::int8_t, kMostPlanKnots> phase{};
  std::array<PlanRow, kMostPlanKnots> q{}, tau{};
  std::array<PlanBalanceRow, kMostPlanKnots> balance{};

  std::int64_t last_tick() const noexcept {
    return head.tick + std::int64_t{head.spacing} * (head.knot_count - 1);
  }
  // A piece of it, as sent.
  void copy_to(int piece, StopPlanPiece& out) const noexcept;
  void copy_from(const StopPlanPiece& piece) noexcept;
};

struct PlanJoints {
  PerJoint<double> q{}, qd{}, tau{};
};

struct PlanSole {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // [m]
  double yaw = 0.0;                                    // [rad]
};

// In the plan's frame.
struct PlanBalance {
  Eigen::Vector2d dcm = Eigen::Vector2d::Zero(), com = dcm, zmp = dcm;  // [m]
  Eigen::Vector3d attitude = Eigen::Vector3d::Zero();                  // of the base, rotation vector [rad]
  double left = 0.5;                                                   // load share
  std::array<PlanSole, 2> sole;
  bool single = false;
  int support = 0;  // the foot that carries, while single
};

// At a tick; before the first knot as there, after the last one at rest there.  period [s].
void joints_at(const StopPlan& plan, std::int64_t tick, double period, PlanJoints& out) noexcept;
PlanBalance balance_at(const StopPlan& plan, std::int64_t tick) noexcept;

// Rounds to the units of a plan; false when a number does not fit.
bool to_plan(double value, double unit, std::int16_t& out) noexcept;

}  // namespace twinbus::robot
