// The stop plan that a gate would follow, and the following of it: from its first tick to the second in which the robot is
// held where the plan has ended.

#pragma once

#include <cstdint>

#include "lcmtypes/msg/robot_io.h"
#include "robot/estimation/estimator.h"
#include "robot/stop_plan/plan_assembler.h"
#include "robot/stop_plan/plan_follower.h"

namespace twinbus {
struct ProtocolProbe;
}  // namespace twinbus

namespace twinbus::inline bridge {

class PlanRun {
 public:
  // model must outlive this.
  explicit PlanRun(const Model& model) noexcept;

  // Not while one is followed.
  PlanRefusal add(const StopPlanPiece& piece, const PlanContext& context) noexcept;
  void forget() noexcept;
  // A whole plan is here that may be followed from the tick of the context on.
  bool ready(const PlanContext& context) const noexcept { return assembler_.fits(context); }
  // A whole plan has come in the last second, or one is followed.
  bool known(std::int64_t tick) const noexcept;

  // robot: its estimate of this tick; null: the plan is followed without balance.
  void start(std::int64_t tick, const Estimator* robot) noexcept;
  void stop() noexcept { running_ = false; }
  // The set-points of this tick, for the joints of the plan.
  void set_points(std::int64_t tick, const Estimator* robot, JointCommand& command) noexcept;

  const StopPlan* whole() const noexcept { return assembler_.whole(); }
  bool running() const noexcept { return running_; }
  std::int32_t number() const noexcept { return running_ ? assembler_.whole()->head.number : 0; }
  std::int64_t since() const noexcept { return running_ ? since_ : 0; }
  // Whether the whole plan leads anywhere else than these set-points: if not, a hold does as well.
  bool leads_away(const JointCommand& from) const noexcept;
  std::int64_t joints() const noexcept { return assembler_.whole() != nullptr ? assembler_.whole()->head.joints : 0; }
  bool walks() const noexcept { return running_ && assembler_.whole()->head.walks; }
  // Of the plan that is followed: its last knot is past; and the time after it, too.
  bool ended(std::int64_t tick) const noexcept { return running_ && tick > assembler_.whole()->last_tick(); }
  bool over(std::int64_t tick) const noexcept { return ended(tick - hold_ticks_); }

 private:
  friend struct twinbus::ProtocolProbe;  // test/protocol looks inside to tell states apart
  const Model* model_;
  std::int64_t second_, hold_ticks_;  // [ticks]
  PlanAssembler assembler_;
  PlanFollower follower_;
  bool running_ = false;
  std::int64_t since_ = 0;
};

}  // namespace twinbus::bridge
