#include "bridge/gate/plan_run.h"

#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline bridge {

namespace {
constexpr double kHolds = 1.0;   // the end of a plan, on its feet and with balance [s]
constexpr double kStays = 0.01;  // of a joint, from where it is to the end of a plan that leads nowhere [rad or m]
}

PlanRun::PlanRun(const Model& model) noexcept
    : model_(&model),
      second_(std::llround(1.0 / model.period())),
      hold_ticks_(std::llround(kHolds / model.period())),
      assembler_(model),
      follower_(model) {}

PlanRefusal PlanRun::add(const StopPlanPiece& piece, const PlanContext& context) noexcept {
  return assembler_.add(piece, context);
}

void PlanRun::forget() noexcept {
  running_ = false;
  assembler_.clear();
}

bool PlanRun::known(std::int64_t tick) const noexcept {
  return running_ || (assembler_.whole() != nullptr && tick - assembler_.whole()->head.tick <= second_);
}

bool PlanRun::leads_away(const JointCommand& from) const noexcept {
  const StopPlan& plan = *assembler_.whole();
  if (plan.head.walks) return true;
  const auto& last = plan.q[at(plan.head.knot_count - 1)];
  for (int j = 0; j < plan.head.joint_count; ++j) {
    if ((plan.head.joints & bit(j)) != 0 && !(std::abs(kPlanPosition * last[at(j)] - from.q[at(j)]) <= kStays)) return true;
  }
  return false;
}

void PlanRun::start(std::int64_t tick, const Estimator* robot) noexcept {
  running_ = true;
  since_ = tick;
  if (robot != nullptr) follower_.start(*assembler_.whole(), tick, *robot);
}

void PlanRun::set_points(std::int64_t tick, const Estimator* robot, JointCommand& command) noexcept {
  const StopPlan& plan = *assembler_.whole();
  PlanJoints joints;
  joints_at(plan, tick, model_->period(), joints);
  if (robot != nullptr) follower_.balance(plan, tick, *robot, joints);
  for (int j = 0; j < plan.head.joint_count; ++j) {
    const auto i = at(j);
    if ((plan.head.joints & bit(j)) == 0) continue;
    command.q[i] = joints.q[i];
    command.qd[i] = static_cast<float>(joints.qd[i]);
    command.tau[i] = static_cast<float>(joints.tau[i]);
  }
}

}  // namespace twinbus::bridge
