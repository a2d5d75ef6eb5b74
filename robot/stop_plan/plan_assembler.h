// Puts the pieces of stop plans together and judges each plan whole: nothing of a plan that fails is ever followed.
//
// Holds the newest whole plan and the one that is arriving.  A piece of a newer plan ends the one that is arriving; pieces may
// come late, twice and in any order.

#pragma once

#include <cstdint>

#include "robot/description/model.h"
#include "robot/stop_plan/stop_plan.h"

namespace twinbus {
struct ProtocolProbe;
}  // namespace twinbus

namespace twinbus::inline robot {

enum class PlanRefusal : std::int8_t {
  kNone = 0,
  kOtherSource,      // run, term or model of another source
  kOtherController,  // not the one that is obeyed
  kOldNumber,        // not newer than the last whole one
  kMixed,            // pieces that contradict each other
  kWrongSize,        // counts, spacing or length
  kWrongTime,        // begins in the future, or too long ago
  kBeyondLimits,     // a joint, a torque or a number of the balance
  kTooFast,          // from knot to knot
  kOutOfReach,       // does not begin at the present set-point
};
const char* to_text(PlanRefusal refusal) noexcept;

// Checks that a test may leave out, to see that they are missed.
enum PlanCheck : std::uint8_t {
  kCheckWhole = 1,
  kCheckUnmixed = 2,
  kCheckOrder = 4,
  kCheckSource = 8,
  kCheckController = 16,
  kCheckAge = 32,
};

// What a plan must fit.
struct PlanContext {
  std::int64_t run_id = 0;
  std::int64_t controller_id = 0;  // 0: nobody is obeyed yet
  std::int64_t tick = 0;           // the present one
  std::int32_t term = 0;
  const PerJoint<double>* from = nullptr;   // set-points written last, or where the joints are [rad or m]
  double reach = 0.15;                      // the first set-point followed is nearer to them [rad or m]
  std::uint8_t left_out = 0;                // PlanCheck bits, none outside of test/protocol
  bool checks(PlanCheck check) const noexcept { return (left_out & check) == 0; }
};

class PlanAssembler {
 public:
  static constexpr double kOldest = 0.2;   // [s] from knot 0 to the tick from which it is followed
  static constexpr double kLongest = 1.6;  // [s] from the first knot to the last
  static constexpr double kReach = 0.15;   // [rad or m] between the first set-point followed and the last one written

  // model must outlive this.
  explicit PlanAssembler(const Model& model) noexcept : model_(&model) {}

  // kNone also for what is only not new: a piece of the present plan again.
  PlanRefusal add(const StopPlanPiece& piece, const PlanContext& context) noexcept;
  void clear() noexcept;

  const StopPlan* whole() const noexcept { return have_whole_ ? &whole_ : nullptr; }
  // Whether the whole plan may be followed from context.tick on.
  bool fits(const PlanContext& context) const noexcept {
    return have_whole_ && judge_now(whole_, context) == PlanRefusal::kNone;
  }

 private:
  friend struct twinbus::ProtocolProbe;  // test/protocol looks inside to tell states apart
  PlanRefusal judge_head(const StopPlanHead& head, const PlanContext& context) const noexcept;
  PlanRefusal judge_whole(const StopPlan& plan) const noexcept;
  PlanRefusal judge_now(const StopPlan& plan, const PlanContext& context) const noexcept;

  const Model* model_;
  StopPlan whole_, coming_;
  bool have_whole_ = false;
  PlanRefusal verdict_ = PlanRefusal::kNone;  // on coming_
  std::uint32_t have_ = 0;                    // bit per piece of it
  std::int64_t controller_ = 0;               // whose numbers count
  std::int32_t newest_number_ = -1;           // of which a piece has been heard
  std::int32_t whole_number_ = -1;
};

}  // namespace twinbus::robot
