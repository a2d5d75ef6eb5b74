#include "bridge/source/source_events.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "bridge/source/device_teller.h"
#include "bridge/source/refusal_teller.h"
#include "lcmtypes/msg/refusal_text.h"
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
  now.terms_ignored = 1;
  Event event;
  int said = 0;
  while (next_sentence(told, now, event)) ASSERT_LT(++said, 20);
  EXPECT_GE(said, 5);
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
  cut = {FirstCut::What::kTorqueStep, 1, 0.4504, 0.45};
  EXPECT_STREQ(cut_sentence(cut, model).data(), "RLEG_KNEE: change of torque in one tick 0.4504 N m asked, 0.45 given");
  cut = {FirstCut::What::kTorqueStep, 1, 0.45000401, 0.45};
  EXPECT_STREQ(cut_sentence(cut, model).data(), "RLEG_KNEE: change of torque in one tick 0.450004 N m asked, 0.45 given")
      << "as many digits as tell the two apart";
}

TEST(SourceEvents, ACutIsAnAlarmOnceAndWhatMakesUpForMissingCommandsIsNone) {
  Model model = test::small_model();
  model.joints[1].name = "RLEG_KNEE";
  const FirstCut cut = {FirstCut::What::kPosition, 1, 2.75, 2.5};
  const FirstCut catch_up = {FirstCut::What::kPositionStep, 1, 0.02023, 0.016, 2};
  CutTeller teller;
  Event event;
  EXPECT_FALSE(teller.next({}, {}, model, event));
  ASSERT_TRUE(teller.next({}, catch_up, model, event));
  EXPECT_EQ(event.severity, 0);
  EXPECT_STREQ(event.text.data(),
               "after 2 ticks without a command the joints catch up within their limits (RLEG_KNEE: change of position in one tick "
               "0.02023 rad asked, 0.016 given); later ones are counted");
  ASSERT_TRUE(teller.next(cut, catch_up, model, event));
  EXPECT_EQ(event.severity, 1);
  EXPECT_STREQ(event.text.data(),
               "a command was beyond a limit: RLEG_KNEE: position 2.75 rad asked, 2.5 given; it is cut, and further ones are counted");
  EXPECT_FALSE(teller.next(cut, catch_up, model, event));
}

// What DeviceTeller says of a device whose status is bad for `bad` ms of every `period` ms, in `seconds`; 1 kHz.
std::vector<std::string> said_of(int bad, int period, int seconds) {
  DeviceTeller teller;
  std::vector<std::string> said;
  for (int ms = 0; ms < 1000 * seconds; ++ms) {
    const Status status = ms % period >= period - bad ? Status::kTimeout : Status::kOk;
    Event event;
    if (!teller.next(status, 1'000'000'000 + ms * test::kMs, event)) continue;
    EXPECT_EQ(event.severity, std::string(event.text.data()) == "device: timeout" ? 1 : 0);
    said.emplace_back(event.text.data());
  }
  return said;
}

TEST(SourceEvents, ADeviceThatDoesNotAnswerIsToldWhenItLastsAndCountedWhenItIsRiddenOut) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(said_of(0, 100, 10), Lines{});
  EXPECT_EQ(said_of(2, 100, 2), Lines{}) << "a few of 2 ms each";
  const Lines many = said_of(3, 100, 150);
  ASSERT_EQ(many.size(), 3u) << "not by the dozen: 10 a second for 150 s";
  EXPECT_EQ(many[0], "device: 25 short failures, the longest 3 ms, in the last 2 s; they were ridden out");
  EXPECT_EQ(many[1].substr(0, 20), "device: 600 short fa");
  EXPECT_EQ(said_of(100, 1000, 3), (Lines{"device: timeout", "device: ok", "device: timeout", "device: ok", "device: timeout"}));
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

// What a writer of a controller meets first.
TEST(RefusalTeller, SaysWhichFieldIsWrongAndWhatItIsOnceItIsNoChance) {
  const Model model = test::small_model();
  JointCommand command;
  command.run_id = 5;
  command.term = 2;
  command.controller_id = 9;
  command.tick = 100;
  command.joint_count = static_cast<std::int16_t>(model.bus_count());
  command.model_hash = 77;
  const WantedCommand want{.run_id = 5, .term = 3, .controller = 9, .last_tick = 99, .tick = 100, .joint_count = model.bus_count(), .model_hash = 78};
  RefusedCommand refused;
  RefusalTeller teller;
  Event event;
  const auto told = [&](GateVerdict why, std::int64_t now_ns) {
    for (int i = 0; i < RefusalTeller::kInARow - 1; ++i) {
      refused.add(why, command, want);
      EXPECT_FALSE(teller.next(refused, model, now_ns, event));
    }
    refused.add(why, command, want);
    return teller.next(refused, model, now_ns, event) ? std::string(event.text.data()) : std::string();
  };
  EXPECT_EQ(told(GateVerdict::kWrongModel, 0).substr(0, 70), "COMMAND is refused, 20 in a row: its model_hash is 77, this robot's 78");
  EXPECT_FALSE(teller.next(refused, model, 1, event)) << "once";
  EXPECT_TRUE(teller.next(refused, model, 11'000'000'000, event)) << "and again after a while";
  EXPECT_NE(told(GateVerdict::kOtherTerm, 1).find("its term is 2, the active source's 3"), std::string::npos);
  command.kd[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(told(GateVerdict::kNotFinite, 2).find("of joint " + model.joints[static_cast<std::size_t>(model.bus_joints[1])].name), std::string::npos);
  refused.obeyed();
  EXPECT_EQ(told(GateVerdict::kStopped, 3), "") << "a stop has been told";
}

}  // namespace
}  // namespace twinbus
