#include "bridge/source/source_events.h"

#include <gtest/gtest.h>

#include <string>

#include "robot/stop_plan/plan_assembler.h"
#include "test/bridge/small_robot.h"

namespace twinbus {
namespace {

std::string first_sentence(SourceStatus told, const SourceStatus& now, int* severity = nullptr) {
  Event event;
  if (!next_sentence(told, now, event)) return "";
  if (severity != nullptr) *severity = event.severity;
  return event.text.data();
}

TEST(SourceEvents, NothingIsSaidWhenNothingChanged) {
  SourceStatus status;
  status.role = Role::kActive;
  EXPECT_EQ(first_sentence(status, status), "");
}

TEST(SourceEvents, EveryChangeIsSaidOnceAndThenThereIsSilence) {
  SourceStatus told, now;
  now.role = Role::kActive;
  now.stop_kind = StopKind::kHold;
  now.stop_reason = StopReason::kCommandTimeout;
  now.refusal = Refusal::kPosture;
  now.refusal_sequence = 3;
  now.controller_id = 7;
  now.clamped = 5;
  now.terms_ignored = 1;
  now.adaptor_status = 1;
  Event event;
  int said = 0;
  while (next_sentence(told, now, event)) ASSERT_LT(++said, 20);
  EXPECT_GE(said, 7);
  EXPECT_FALSE(next_sentence(told, now, event));
}

TEST(SourceEvents, AStopIsAnAlarmAndNamesItsReason) {
  SourceStatus told, now;
  now.stop_kind = StopKind::kHold;
  now.stop_reason = StopReason::kCommandTimeout;
  int severity = 0;
  EXPECT_NE(first_sentence(told, now, &severity).find("controller"), std::string::npos);
  EXPECT_EQ(severity, 2);
}

TEST(SourceEvents, ARefusalSaysWhatTheRefusalTextSays) {
  SourceStatus told, now;
  now.refusal = Refusal::kPosture;
  now.refusal_sequence = 1;
  EXPECT_NE(first_sentence(told, now).find(refusal_text(Refusal::kPosture)), std::string::npos);
}

TEST(SourceEvents, ACutNamesJointLimitAndBothNumbers) {
  Model model = test::small_model();
  model.joints[1].name = "RLEG_KNEE";
  FirstCut cut;
  EXPECT_STREQ(cut_sentence(cut, model).data(), "");
  cut = {FirstCut::What::kPosition, 1, 2.75, 2.5};
  EXPECT_STREQ(cut_sentence(cut, model).data(), "RLEG_KNEE: position 2.75 rad asked, 2.5 given");
  cut = {FirstCut::What::kTorqueStep, 1, -80.0, -30.0};
  EXPECT_STREQ(cut_sentence(cut, model).data(), "RLEG_KNEE: change of torque in one tick -80 N m asked, -30 given");
  cut.joint = 2;
  EXPECT_STREQ(cut_sentence(cut, model).data(), "");
  SourceStatus told, now;
  now.clamped = 2;
  Event event;
  ASSERT_TRUE(next_sentence(told, now, event, "RLEG_KNEE: position 2.75 rad asked, 2.5 given"));
  EXPECT_STREQ(event.text.data(),
               "a command was beyond a limit: RLEG_KNEE: position 2.75 rad asked, 2.5 given; it is cut, and further ones are counted");
}

TEST(SourceEvents, StopPlansThatAreRefusedOneAfterTheOtherAreToldOnceUntilOneIsTaken) {
  SourceStatus told, now;
  const auto sentence = [&]() -> std::string {
    Event event;
    return next_sentence(told, now, event) ? event.text.data() : "";
  };
  now.plans_accepted = 3;
  now.plans_refused = 20;
  now.plan_refusal = static_cast<std::int8_t>(PlanRefusal::kBeyondLimits);
  EXPECT_EQ(sentence(), "") << "plans were taken between them";
  now.plans_refused = 45;
  EXPECT_EQ(sentence(),
            "stop plans are refused: a number of it is beyond the robot's limits; the robot is held where it is if commands fail");
  now.plans_refused = 450;
  EXPECT_EQ(sentence(), "");
  now.plans_accepted = 4;
  EXPECT_EQ(sentence(), "");
  now.plans_refused = 475;
  EXPECT_NE(sentence(), "");
}

}  // namespace
}  // namespace twinbus
