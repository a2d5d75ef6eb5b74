#include "robot/stop_plan/plan_assembler.h"

#include <cmath>

#include "common/math/index.h"
#include "common/text/name_of.h"

namespace twinbus::inline robot {

namespace {

constexpr double kLimitSlack = 2e-3;  // [rad or m] of a position, for rounding and the cubics
constexpr double kSpeedSlack = 1.1;   // of a velocity limit, from knot to knot
constexpr double kLightest = 0.5, kHeaviest = 2.0;  // of the robot's own mass
constexpr float kSlowest = 1.0F, kQuickest = 12.0F;  // pendulum [1/s]
constexpr float kLargestSole = 0.5F;                 // [m]

bool ordered(const std::array<float, 2>& low, const std::array<float, 2>& high) noexcept {
  bool good = true;
  for (std::size_t k = 0; k < 2; ++k) {
    good = good && low[k] >= -kLargestSole && high[k] <= kLargestSole && low[k] <= high[k];
  }
  return good;
}

}  // namespace

const char* to_text(PlanRefusal refusal) noexcept {
  static constexpr const char* kTexts[] = {"none",
                                           "it is for another run, term or robot",
                                           "it is of a controller that is not obeyed",
                                           "a newer one has come before it",
                                           "its pieces contradict each other",
                                           "its counts, spacing or length are none that a plan may have",
                                           "it begins in the future or too long ago",
                                           "a number of it is beyond the robot's limits",
                                           "a joint would be too fast from knot to knot",
                                           "it does not begin at the present set-point"};
  return name_of(refusal, kTexts);
}

void PlanAssembler::clear() noexcept {
  have_whole_ = false;
  have_ = 0;
  controller_ = 0;
  newest_number_ = whole_number_ = -1;
  verdict_ = PlanRefusal::kNone;
}

PlanRefusal PlanAssembler::judge_head(const StopPlanHead& head, const PlanContext& context) const noexcept {
  const bool for_us = head.run_id == context.run_id && head.term == context.term;
  if ((!for_us && context.checks(kCheckSource)) || head.model_hash != model_->hash) return PlanRefusal::kOtherSource;
  const bool obeyed = context.controller_id != 0 && head.controller_id == context.controller_id;
  if (!obeyed && context.checks(kCheckController)) return PlanRefusal::kOtherController;
  const int pieces = (head.knot_count + kPlanKnotsPerPiece - 1) / kPlanKnotsPerPiece;
  const double length = model_->period() * head.spacing * (head.knot_count - 1);
  if (head.joint_count != model_->bus_count() || head.knot_count < 2 || head.knot_count > kMostPlanKnots ||
      head.pieces != pieces || head.spacing < 1 || !(length <= kLongest)) {
    return PlanRefusal::kWrongSize;
  }
  const bool old = static_cast<double>(context.tick - head.tick) * model_->period() > kOldest;
  if (head.tick > context.tick || (old && context.checks(kCheckAge))) {
    return PlanRefusal::kWrongTime;
  }
  if (!head.walks) return PlanRefusal::kNone;
  const double mass = static_cast<double>(head.mass) / model_->total_mass();
  const bool good = model_->soles[0].link >= 0 && model_->soles[1].link >= 0 && head.omega >= kSlowest &&
                    head.omega <= kQuickest && mass >= kLightest && mass <= kHeaviest &&
                    ordered(head.sole_low, head.sole_high) && ordered(head.sole_zmp, head.sole_zmp);
  return good ? PlanRefusal::kNone : PlanRefusal::kBeyondLimits;
}

// What does not depend on the instant.
PlanRefusal PlanAssembler::judge_whole(const StopPlan& plan) const noexcept {
  const double spacing = model_->period() * plan.head.spacing;
  for (int j = 0; j < plan.head.joint_count; ++j) {
    if ((plan.head.joints & bit(j)) == 0) continue;
    const Joint& joint = model_->joints[at(model_->bus_joints[at(j)])];
    const bool turns = joint.kind == JointKind::kContinuous;
    const double most = kSpeedSlack * joint.velocity * spacing + kPlanPosition;
    for (int k = 0; k < plan.head.knot_count; ++k) {
      const double q = kPlanPosition * plan.q[at(k)][at(j)];
      const double tau = kPlanTorque * plan.tau[at(k)][at(j)];
      if (!turns && !(q >= joint.lower - kLimitSlack && q <= joint.upper + kLimitSlack)) return PlanRefusal::kBeyondLimits;
      if (!(std::abs(tau) <= joint.effort + kPlanTorque)) return PlanRefusal::kBeyondLimits;
      if (k == 0) continue;
      const double way = kPlanPosition * (plan.q[at(k)][at(j)] - plan.q[at(k - 1)][at(j)]);
      if (!(std::abs(way) <= most)) return PlanRefusal::kTooFast;
    }
  }
  for (int k = 0; plan.head.walks && k < plan.head.knot_count; ++k) {
    const double left = kPlanBalance * plan.balance[at(k)][kPlanLeft];
    if (!(left >= 0.0 && left <= 1.0) || (plan.phase[at(k)] & ~(kPlanSingle | kPlanOnRight)) != 0) {
      return PlanRefusal::kBeyondLimits;
    }
  }
  return PlanRefusal::kNone;
}

PlanRefusal PlanAssembler::judge_now(const StopPlan& plan, const PlanContext& context) const noexcept {
  const PlanRefusal head = judge_head(plan.head, context);
  if (head != PlanRefusal::kNone || context.from == nullptr) return head;
  PlanJoints joints;
  joints_at(plan, context.tick, model_->period(), joints);
  for (int j = 0; j < plan.head.joint_count; ++j) {
    if ((plan.head.joints & bit(j)) == 0) continue;
    if (!(std::abs(joints.q[at(j)] - (*context.from)[at(j)]) <= context.reach)) return PlanRefusal::kOutOfReach;
  }
  return PlanRefusal::kNone;
}

PlanRefusal PlanAssembler::add(const StopPlanPiece& piece, const PlanContext& context) noexcept {
  const PlanRefusal head = judge_head(piece.head, context);
  if (head != PlanRefusal::kNone) return head;
  if (piece.piece < 0 || piece.piece >= piece.head.pieces) return PlanRefusal::kWrongSize;
  if (piece.head.controller_id != controller_) {
    clear();
    controller_ = piece.head.controller_id;
  }
  const std::int32_t number = piece.head.number;
  if (have_whole_ && number == whole_number_) return PlanRefusal::kNone;  // heard again
  const bool older = number < newest_number_ || number < whole_number_;
  if (older && context.checks(kCheckOrder)) return PlanRefusal::kOldNumber;
  if (number != newest_number_) {
    newest_number_ = number;
    coming_.head = piece.head;
    if (context.checks(kCheckUnmixed)) have_ = 0;
    verdict_ = PlanRefusal::kNone;
  }
  if (verdict_ == PlanRefusal::kNone && !(piece.head == coming_.head)) verdict_ = PlanRefusal::kMixed;
  if (verdict_ != PlanRefusal::kNone) return verdict_;
  coming_.copy_from(piece);
  have_ |= 1U << piece.piece;
  if (have_ != (1U << piece.head.pieces) - 1U && context.checks(kCheckWhole)) return PlanRefusal::kNone;
  verdict_ = judge_whole(coming_);
  if (verdict_ == PlanRefusal::kNone) verdict_ = judge_now(coming_, context);
  if (verdict_ != PlanRefusal::kNone) return verdict_;
  whole_ = coming_;
  have_whole_ = true;
  whole_number_ = number;
  return PlanRefusal::kNone;
}

}  // namespace twinbus::robot
