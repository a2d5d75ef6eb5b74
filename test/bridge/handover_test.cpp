#include "bridge/handover/handover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "lcmtypes/msg/refusal_text.h"
#include "test/bridge/small_robot.h"

namespace twinbus {
namespace {

using namespace test;

constexpr std::int64_t kMe = 1, kTarget = 2, kOperator = 5;

RobotState standing(std::int64_t run) {
  RobotState s;
  s.run_id = run;
  s.model_hash = 4711;
  s.period_ns = 2'000'000;
  s.joint_count = 2;
  s.source = SourceKind::kBridge;
  s.role = Role::kStandbyShadow;
  s.sensor_flags = kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
  for (const std::size_t foot : {std::size_t{kLeftFoot}, std::size_t{kRightFoot}}) {
    s.wrench_kind[foot] = WrenchKind::kMeasured;
    s.wrench[foot][2] = 640.0F;
  }
  return s;
}

// One source, and everything it hears by hand.
class OneSource : public ::testing::Test {
 protected:
  OneSource() : handover(config()) {
    measured = standing(kMe);
    input.measured = &measured;
  }
  static HandoverConfig config() {
    HandoverConfig c;
    c.run_id = kMe;
    c.model_hash = 4711;
    return c;
  }
  SourceRequest request(SourceAction action, std::int64_t target, std::int64_t run = kMe) {
    return {.sender_id = kOperator, .run_id = run, .target_run_id = target, .sequence = ++sequence, .action = action,
            .policy = SwitchPolicy::kNow};
  }
  void ask(const SourceRequest& r) { handover.request(r, input, now); }
  void ask_to_switch_when_safe() {
    SourceRequest r = request(SourceAction::kSwitch, kTarget);
    r.policy = SwitchPolicy::kWhenSafe;
    hear_target(standing(kTarget));
    ask(r);
  }
  // One that holds STATE.
  static RobotState holder(std::int64_t run, std::int32_t term) {
    RobotState s = standing(run);
    s.role = Role::kActive;
    s.term = term;
    return s;
  }
  Transition step() {
    now += kPeriodNs;
    return handover.begin_tick(input, now);
  }
  void activate() {
    for (int i = 0; i < 600; ++i) step();
    ask(request(SourceAction::kActivate, kMe));
    ASSERT_EQ(step(), Transition::kActivated);
  }
  void hear_target(const RobotState& s) { handover.heard_standby(s, now); }

  Handover handover;
  HandoverInput input;
  RobotState measured;
  std::int64_t now = 10'000 * kMs;
  std::int32_t sequence = 0;
};

TEST_F(OneSource, IsActivatedByRequestOnlyAndAfterListening) {
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(step(), Transition::kNone);
  EXPECT_EQ(handover.role, Role::kParked);
  ask(request(SourceAction::kActivate, kMe));
  EXPECT_EQ(step(), Transition::kActivated);
  EXPECT_EQ(handover.term, 1);
}

TEST_F(OneSource, AStartIsNotActivatedBeforeASecondOfListening) {
  step();
  ask(request(SourceAction::kActivate, kMe));
  const std::int64_t asked = now;
  while (step() != Transition::kActivated) ASSERT_LT(now - asked, 1100 * kMs);
  EXPECT_GE(now - asked, 990 * kMs);
}

TEST_F(OneSource, ActivatesAboveTheHighestTermHeard) {
  RobotState other = standing(9);
  other.role = Role::kActive;
  other.term = 17;
  other.tick = 1000;
  for (int i = 0; i < 5; ++i) {
    step();
    handover.heard_state(other, now);
  }
  for (int i = 0; i < 600; ++i) step();
  ask(request(SourceAction::kActivate, kMe));
  ASSERT_EQ(step(), Transition::kActivated);
  EXPECT_EQ(handover.term, 18);
}

TEST_F(OneSource, GrantsAtLeastFiveTicksAheadAndCancelsWhenNobodyAppears) {
  activate();
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  const std::int32_t term = handover.term;
  ASSERT_EQ(step(), Transition::kGranted);
  EXPECT_EQ(handover.role, Role::kReleasing);
  EXPECT_GE(handover.grant_tick, handover.tick + 5);
  while (handover.tick < handover.grant_tick - 1) {
    ASSERT_EQ(step(), Transition::kNone);
    EXPECT_TRUE(handover.obeys());
  }
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(step(), Transition::kNone);
    EXPECT_FALSE(handover.obeys());
  }
  EXPECT_EQ(step(), Transition::kCancelled);
  EXPECT_EQ(handover.term, term + 2);
  EXPECT_EQ(handover.role, Role::kActive);
  EXPECT_TRUE(handover.obeys());
}

TEST_F(OneSource, LeavesStateWhenTheSuccessorIsSeen) {
  activate();
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  ASSERT_EQ(step(), Transition::kGranted);
  RobotState successor = standing(kTarget);
  successor.role = Role::kActive;
  successor.term = handover.term + 1;
  successor.tick = handover.grant_tick;
  while (handover.tick < handover.grant_tick) step();
  handover.heard_state(successor, now);
  EXPECT_EQ(step(), Transition::kReleased);
  EXPECT_FALSE(handover.holds_state());
  EXPECT_EQ(handover.holder, kTarget);
}

TEST_F(OneSource, OneForgedDatagramDeposesNobody) {
  activate();
  RobotState forged = standing(999);
  forged.role = Role::kActive;
  for (const std::int32_t term : {2, 3, 100, 1 << 29, 1 << 30, 0x7fffffff}) {
    forged.term = term;
    forged.tick = handover.tick + 1;
    handover.heard_state(forged, now);
    EXPECT_NE(step(), Transition::kGaveWay);
    EXPECT_EQ(handover.role, Role::kActive);
    EXPECT_EQ(handover.term, 1);
  }
  EXPECT_GE(handover.terms_ignored, 6);
}

TEST_F(OneSource, ASourceThatObeysIsNotDeposedByAnOldLogEither) {
  activate();
  RobotState old = holder(999, 50);
  for (int i = 0; i < 2000; ++i) {
    old.tick = 10'000 + i;
    handover.heard_state(old, now);
    ASSERT_EQ(step(), Transition::kNone);
  }
  EXPECT_EQ(handover.role, Role::kActive);
}

TEST_F(OneSource, ARepeatedRequestIsObeyedOnce) {
  activate();
  hear_target(standing(kTarget));
  const SourceRequest r = request(SourceAction::kSwitch, kTarget);
  ask(r);
  ASSERT_EQ(step(), Transition::kGranted);
  while (step() != Transition::kCancelled) {
  }
  now += 5000 * kMs;
  hear_target(standing(kTarget));
  ask(r);
  EXPECT_EQ(step(), Transition::kNone);
}

TEST_F(OneSource, AStopBeforeTheSuccessorIsSeenCancels) {
  activate();
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  ASSERT_EQ(step(), Transition::kGranted);
  input.stop_kind = StopKind::kHold;
  EXPECT_EQ(step(), Transition::kCancelled);
  EXPECT_EQ(handover.role, Role::kStopped);
}

// Every refusal of a switch: its own reason, and nothing moves.
struct RefusalCase {
  const char* name;
  Refusal expected;
  std::function<void(RobotState& target, RobotState& mine, HandoverInput& input, Handover& me)>
      arrange;
};

class Refused : public OneSource, public ::testing::WithParamInterface<RefusalCase> {};

TEST_P(Refused, WithItsOwnReasonAndNothingMoves) {
  activate();
  RobotState target = standing(kTarget);
  hear_target(target);
  GetParam().arrange(target, measured, input, handover);
  if (GetParam().expected == Refusal::kStale) now += 201 * kMs;
  if (GetParam().expected != Refusal::kStale && GetParam().expected != Refusal::kUnknownTarget)
    hear_target(target);
  const std::int32_t term = handover.term;
  const Role role = handover.role;
  const std::int64_t wanted = GetParam().expected == Refusal::kUnknownTarget   ? std::int64_t{77}
                              : GetParam().expected == Refusal::kAlreadyActive ? kMe
                                                                               : kTarget;
  const SourceRequest r = request(SourceAction::kSwitch, wanted);
  ask(r);
  for (int i = 0; i < 20; ++i) ASSERT_EQ(step(), Transition::kNone);
  EXPECT_EQ(handover.refusal, GetParam().expected);
  EXPECT_EQ(handover.refusal_sequence, r.sequence);
  EXPECT_EQ(handover.term, term);
  if (input.stop_kind == StopKind::kNone) {
    EXPECT_EQ(handover.role, role);
  }
  EXPECT_EQ(handover.successor, 0);
  EXPECT_FALSE(handover.pending_switch);
}

using S = RobotState;
using I = HandoverInput;
using H = Handover;
const RefusalCase kRefusals[] = {
    {"Posture", Refusal::kPosture, [](S& t, S&, I&, H&) { t.q[1] = 0.06; }},
    {"PostureNotFinite", Refusal::kPosture, [](S& t, S&, I&, H&) { t.q[1] = std::nan(""); }},
    {"Velocity", Refusal::kVelocity, [](S& t, S&, I&, H&) { t.qd[0] = 0.6F; }},
    {"Attitude", Refusal::kAttitude,
     [](S& t, S&, I&, H&) {
       t.attitude = {0.9995F, 0.0316F, 0.0F, 0.0F};
     }},
    {"Gyro", Refusal::kGyro, [](S& t, S&, I&, H&) { t.gyro[0] = 0.4F; }},
    {"Feet", Refusal::kFeet, [](S& t, S&, I&, H&) { t.wrench[kLeftFoot][2] = 0.0F; }},
    {"Load", Refusal::kLoad, [](S& t, S&, I&, H&) { t.wrench[kLeftFoot][2] = 1000.0F; }},
    {"Hash", Refusal::kModelHash, [](S& t, S&, I&, H&) { t.model_hash += 1; }},
    {"Period", Refusal::kPeriod, [](S& t, S&, I&, H&) { t.period_ns = 5'000'000; }},
    {"Freshness", Refusal::kStale, [](S&, S&, I&, H&) {}},
    {"OwnDeviceSilent", Refusal::kStale, [](S&, S&, I& i, H&) { i.device_ok = false; }},
    {"TargetStopped", Refusal::kStopped, [](S& t, S&, I&, H&) { t.stop_kind = StopKind::kHold; }},
    {"SelfStopped", Refusal::kStopped, [](S&, S&, I& i, H&) { i.stop_kind = StopKind::kHold; }},
    {"Unstable", Refusal::kUnstable, [](S&, S&, I& i, H&) { i.stable = false; }},
    {"UnknownTarget", Refusal::kUnknownTarget, [](S&, S&, I&, H&) {}},
    {"AlreadyActive", Refusal::kAlreadyActive, [](S&, S&, I&, H&) {}},
    {"NotStandby", Refusal::kNotStandby, [](S& t, S&, I&, H&) { t.role = Role::kParked; }},
    {"TargetsDevice", Refusal::kDevice,
     [](S& t, S&, I&, H&) { t.sensor_flags &= ~kEncodersValid; }},
    {"Pace", Refusal::kPace, [](S&, S&, I&, H& h) { h.config.real_time = false; }},
};

INSTANTIATE_TEST_SUITE_P(Switch, Refused, ::testing::ValuesIn(kRefusals),
                         [](const auto& which) { return which.param.name; });

TEST_F(OneSource, TwoSwitchesInASecondAreRefusedAsTooSoon) {
  activate();
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  ASSERT_EQ(step(), Transition::kGranted);
  ask(request(SourceAction::kSwitch, 3));
  EXPECT_EQ(handover.refusal, Refusal::kBusy);
  while (step() != Transition::kCancelled) {
  }
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  EXPECT_EQ(step(), Transition::kNone);
  EXPECT_EQ(handover.refusal, Refusal::kBusy);
}

// Else two sources, each within its own limit, change a robot to and fro.
TEST_F(OneSource, WhoHasTakenOverDoesNotGrantAtOnce) {
  RobotState holder = standing(9);
  holder.role = Role::kActive;
  holder.term = 3;
  const auto holder_speaks = [&] {
    ++holder.tick;
    handover.heard_state(holder, now);
    return step();
  };
  handover.config.can_be_set = true;
  for (int i = 0; i < 600; ++i) holder_speaks();
  holder.role = Role::kReleasing;
  holder.grant_run_id = handover.config.run_id;
  holder.grant_tick = holder.tick + 5;
  Transition happened = Transition::kNone;
  for (int i = 0; i < 12 && happened != Transition::kTookOver; ++i) happened = holder_speaks();
  ASSERT_EQ(happened, Transition::kTookOver);
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  EXPECT_NE(step(), Transition::kGranted);
  EXPECT_EQ(handover.refusal, Refusal::kBusy);
  now += handover.config.switch_interval_ns;
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  EXPECT_EQ(step(), Transition::kGranted);
}

TEST_F(OneSource, ASecondActivationIsRefusedWhileAnotherSourceIsHeard) {
  step();
  RobotState other = holder(9, 1);
  for (int i = 0; i < 600; ++i) {
    other.tick = i + 1;
    handover.heard_state(other, now);
    step();
  }
  ask(request(SourceAction::kActivate, kMe));
  EXPECT_EQ(handover.refusal, Refusal::kAnotherActive);
  EXPECT_EQ(step(), Transition::kNone);
}

TEST_F(OneSource, TrackNeedsARobotThatCanBeSet) {
  step();
  ask(request(SourceAction::kStandbyTrack, kMe));
  EXPECT_EQ(handover.refusal, Refusal::kCannotBeSet);
  ask(request(SourceAction::kStandbyShadow, kMe));
  EXPECT_EQ(handover.refusal, Refusal::kNone);
  EXPECT_EQ(step(), Transition::kStandby);
}

TEST_F(OneSource, AnUnstableRobotIsLeftAsSoonAsItStandsWhenThePolicySaysSo) {
  activate();
  input.stable = false;
  ask_to_switch_when_safe();
  for (int i = 0; i < 100; ++i) {
    hear_target(standing(kTarget));
    ASSERT_EQ(step(), Transition::kNone);
    EXPECT_TRUE(handover.wants_rest);
  }
  input.stable = true;
  EXPECT_EQ(step(), Transition::kGranted);
}

// The machine stood still: the switch is made once the target is heard again.
TEST_F(OneSource, ATargetThatIsLateIsWaitedFor) {
  activate();
  hear_target(standing(kTarget));
  now += 150 * kMs;
  ask(request(SourceAction::kSwitch, kTarget));
  for (int i = 0; i < 10; ++i) ASSERT_EQ(step(), Transition::kNone);
  EXPECT_TRUE(handover.pending_switch);
  EXPECT_EQ(handover.refusal, Refusal::kNone);
  hear_target(standing(kTarget));
  EXPECT_EQ(step(), Transition::kGranted);
}

TEST_F(OneSource, AWalkingSimulatorComesToRestBeforeARobotThatStandsTakesOver) {
  activate();
  RobotState in_step = standing(kMe);
  in_step.q[0] += 0.3;
  input.measured = &in_step;
  input.walking = true;
  ask_to_switch_when_safe();
  for (int i = 0; i < 100; ++i) {
    hear_target(standing(kTarget));
    input.walking = i < 50;  // it stands, but not yet as the robot does
    ASSERT_EQ(step(), Transition::kNone);
    EXPECT_TRUE(handover.wants_rest);
  }
  in_step = standing(kMe);
  EXPECT_EQ(step(), Transition::kGranted);
}

// A standby wakes late, hears two ticks at once, and counts one ahead at its next tick.
TEST_F(OneSource, AStandbyThatCountsAheadWaitsForTheHoldersLastTick) {
  for (int i = 0; i < 600; ++i) step();
  RobotState holder = standing(kTarget);
  holder.role = Role::kActive;
  holder.term = 3;
  ask(request(SourceAction::kStandbyShadow, kMe));
  for (holder.tick = 100; holder.tick < 104; ++holder.tick) {
    handover.heard_state(holder, now);
    step();
  }
  holder.role = Role::kReleasing;
  holder.grant_run_id = kMe;
  holder.grant_tick = 106;
  handover.heard_state(holder, now);  // 104
  EXPECT_EQ(step(), Transition::kNone);
  EXPECT_EQ(step(), Transition::kNone) << "it counts 106 and has not heard 105";
  holder.tick = 105;
  handover.heard_state(holder, now);
  EXPECT_EQ(step(), Transition::kTookOver);
  EXPECT_EQ(handover.tick, 106);
}

TEST_F(OneSource, AGrantOfAHolderThatIsGoneIsStillTaken) {
  for (int i = 0; i < 600; ++i) step();
  RobotState holder = standing(kTarget);
  holder.role = Role::kReleasing;
  holder.term = 3;
  holder.tick = 104;
  holder.grant_run_id = kMe;
  holder.grant_tick = 106;
  ask(request(SourceAction::kStandbyShadow, kMe));
  handover.heard_state(holder, now);
  int ticks = 0;
  while (step() != Transition::kTookOver) ASSERT_LT(++ticks, 6);
  EXPECT_EQ(handover.tick, 108);
}

TEST_F(OneSource, NoHardwareTakesOverInMidStep) {
  activate();
  input.walking = true;
  hear_target(standing(kTarget));
  ask(request(SourceAction::kSwitch, kTarget));
  EXPECT_EQ(step(), Transition::kNone);
  EXPECT_EQ(handover.refusal, Refusal::kUnstable);
}

TEST(RefusalText, EveryRefusalHasASentenceOfItsOwn) {
  std::set<std::string> texts;
  for (int i = 1; i <= static_cast<int>(Refusal::kDevice); ++i) {
    const std::string text = refusal_text(static_cast<Refusal>(i));
    EXPECT_GT(text.size(), 15U) << i;
    EXPECT_TRUE(texts.insert(text).second) << text;
  }
}

}  // namespace
}  // namespace twinbus
