#include "lcmtypes/msg/labels.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "lcmtypes/bus/field_copier.h"
#include "lcmtypes/msg/plan_refusal.h"
#include "lcmtypes/msg/refusal_text.h"

namespace twinbus {
namespace {

// Every value that a message may carry has a name of its own, and the one behind the last has none.
template <class E>
void expect_names(E first) {
  std::set<std::string> names;
  const int last = last_of(E{});
  for (int i = static_cast<int>(first); i <= last; ++i) names.insert(label(static_cast<E>(i)));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last - static_cast<int>(first) + 1));
  EXPECT_STREQ(label(static_cast<E>(last + 1)), "unknown");
  EXPECT_STREQ(label(static_cast<E>(-1)), "unknown");
}

TEST(Labels, EveryValueHasAName) {
  expect_names(SourceKind::kNone);
  expect_names(Role::kNone);
  expect_names(StopKind::kNone);
  expect_names(StopReason::kNone);
  expect_names(Mode::kNone);
  expect_names(Motion::kNone);
  expect_names(ProcessKind::kNone);
  expect_names(GuardVerdict::kClear);
}

TEST(Labels, NamesStandAtTheirValue) {
  EXPECT_STREQ(label(StopReason::kCommandTimeout), "missing commands");
  EXPECT_STREQ(label(ProcessKind::kLauncher), "launcher");
  EXPECT_STREQ(label(Role::kStandbyShadow), "shadow");
  EXPECT_STREQ(label(Mode::kWalk), "walk");
}

TEST(Labels, EveryRefusalHasASentence) {
  std::set<std::string> sentences;
  for (int i = 0; i <= static_cast<int>(Refusal::kDevice); ++i)
    sentences.insert(refusal_text(static_cast<Refusal>(i)));
  EXPECT_EQ(sentences.size(), static_cast<std::size_t>(Refusal::kDevice) + 1);
  EXPECT_STREQ(refusal_text(Refusal::kDevice), "the device of the target reports an error; look at its status");
  EXPECT_STREQ(refusal_text(static_cast<Refusal>(100)), "refused for a reason that this version does not know");
}

TEST(Labels, EveryPlanThatWasRefusedSaysWhyAndWhatToDo) {
  std::set<std::string> sentences;
  for (int i = 0; i <= static_cast<int>(ArmPathStatus::kBadGoal); ++i)
    sentences.insert(plan_refusal(static_cast<ArmPathStatus>(i), "the hand", "obstacle 2", 0.12, false));
  EXPECT_EQ(sentences.size(), static_cast<std::size_t>(ArmPathStatus::kBadGoal) + 1);
  EXPECT_EQ(plan_refusal(ArmPathStatus::kOk, "", "", 0.0, false), "");
  EXPECT_EQ(plan_refusal(ArmPathStatus::kGoalInCollision, "the hand", "obstacle 2", 0.0, false),
            "at the goal the hand would touch obstacle 2: move the goal");
  EXPECT_EQ(plan_refusal(ArmPathStatus::kUnreachable, "", "", 0.12, true),
            "out of reach by 0.120 m: move the goal nearer or give up its orientation");
}

}  // namespace
}  // namespace twinbus
