#include "control/teleop/teleop.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace twinbus {
namespace {

constexpr std::int64_t kTeleopRun = 42;
constexpr std::int64_t kSecond = 1'000'000'000;

PadInput held() {
  PadInput input;
  input.connected = true;
  input.buttons = kPadLeftShoulder;
  return input;
}

PadInput released() {
  PadInput input;
  input.connected = true;
  return input;
}

PadInput pressed(int buttons) {
  PadInput input = released();
  input.buttons = buttons;
  return input;
}

bool all_zero(const Gamepad& pad) {
  return pad.left_x == 0 && pad.left_y == 0 && pad.right_x == 0 && pad.right_y == 0 &&
         pad.left_trigger == 0 && pad.right_trigger == 0 && !pad.deadman;
}

// A pad that has been taken hold of.
Teleop armed() {
  Teleop teleop(7, false);
  teleop.on_source(kTeleopRun, false);
  teleop.on_pad(released());
  teleop.on_pad(held());
  return teleop;
}

TEST(Teleop, SticksActOnlyWhileTheDeadmanIsHeld) {
  Teleop teleop(7, false);
  PadInput input = released();
  input.axes[1] = -32768;
  teleop.on_pad(input);
  EXPECT_TRUE(all_zero(teleop.message(0, 0)));

  Teleop held_one = armed();
  input = held();
  input.axes[1] = -32768;
  held_one.on_pad(input);
  const Gamepad pad = held_one.message(0, 0);
  EXPECT_TRUE(pad.deadman);
  EXPECT_FLOAT_EQ(pad.left_y, 1.0f);
  input.buttons = 0;
  held_one.on_pad(input);
  EXPECT_TRUE(all_zero(held_one.message(0, 0)));
}

TEST(Teleop, ForwardLeftAndUpArePositive) {
  Teleop teleop = armed();
  PadInput input = held();
  input.axes = {-32767, -32767, -32767, -32767, 32767, 32767};
  teleop.on_pad(input);
  const Gamepad pad = teleop.message(0, 0);
  EXPECT_FLOAT_EQ(pad.left_x, 1.0f);
  EXPECT_FLOAT_EQ(pad.left_y, 1.0f);
  EXPECT_FLOAT_EQ(pad.right_x, 1.0f);
  EXPECT_FLOAT_EQ(pad.right_y, 1.0f);
  EXPECT_FLOAT_EQ(pad.left_trigger, 1.0f);
  EXPECT_FLOAT_EQ(pad.right_trigger, 1.0f);
}

TEST(Teleop, DeadZoneIsTakenOffAndTheRestReachesOne) {
  EXPECT_EQ(stick_value(0, -1.0), 0.0f);
  EXPECT_EQ(stick_value(3900, -1.0), 0.0f);
  EXPECT_FLOAT_EQ(stick_value(32767, 1.0), 1.0f);
  EXPECT_FLOAT_EQ(stick_value(-32768, 1.0), -1.0f);
  EXPECT_FLOAT_EQ(stick_value(-32768, -1.0), 1.0f);
  // Continuous at the edge of the dead zone, monotonic behind it.
  float last = 0.0f;
  for (int raw = 0; raw <= 32767; ++raw) {
    const float value = stick_value(static_cast<std::int16_t>(raw), 1.0);
    EXPECT_GE(value, last);
    EXPECT_LT(value - last, 1e-3f);
    last = value;
  }
}

TEST(Teleop, TakingHoldNeedsCentredSticksAndAFreshPress) {
  Teleop teleop(7, false);
  teleop.on_source(kTeleopRun, false);
  teleop.on_pad(held());  // held since before the program started
  EXPECT_FALSE(teleop.holding());
  teleop.on_pad(released());
  PadInput off_centre = held();
  off_centre.axes[0] = 20000;
  teleop.on_pad(off_centre);
  EXPECT_FALSE(teleop.holding());
  EXPECT_TRUE(all_zero(teleop.message(0, 0)));
  teleop.on_pad(held());  // centred at last
  EXPECT_TRUE(teleop.holding());
}

TEST(Teleop, UnpluggingSendsZerosAndNeedsTakingHoldAgain) {
  Teleop teleop = armed();
  PadInput input = held();
  input.axes[0] = 30000;
  teleop.on_pad(input);
  teleop.on_pad(PadInput{});
  const Gamepad gone = teleop.message(0, 0);
  EXPECT_TRUE(all_zero(gone));
  EXPECT_FALSE(gone.connected);
  EXPECT_EQ(gone.buttons, 0);
  teleop.on_pad(held());
  EXPECT_FALSE(teleop.holding());
}

TEST(Teleop, StopWorksWithoutTheDeadmanAndLatches) {
  Teleop teleop = armed();
  PadInput input = held();
  input.axes[1] = -20000;
  input.buttons |= kPadB;
  teleop.on_pad(input);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kStop);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kNone);
  EXPECT_TRUE(teleop.message(0, 0).stop);
  EXPECT_TRUE(all_zero(teleop.message(0, 0)));

  teleop.on_pad(released());
  teleop.on_pad(held());
  EXPECT_FALSE(teleop.holding());
  input = released();
  input.buttons = kPadBack | kPadStart;
  teleop.on_pad(input);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kClear);
  EXPECT_FALSE(teleop.message(0, 0).stop);
  teleop.on_pad(released());
  teleop.on_pad(held());
  EXPECT_TRUE(teleop.holding());
}

TEST(Teleop, AStopClearedBySomebodyElseUnlatches) {
  Teleop teleop = armed();
  teleop.on_pad(pressed(kPadB));
  teleop.on_source(kTeleopRun, false);  // our stop has not reached the source yet
  EXPECT_TRUE(teleop.stop_latched());
  teleop.on_source(kTeleopRun, true);
  teleop.on_no_source();
  EXPECT_TRUE(teleop.stop_latched());
  teleop.on_source(kTeleopRun, false);
  EXPECT_FALSE(teleop.stop_latched());
}

TEST(Teleop, ModeButtonsNeedTheDeadman) {
  Teleop teleop = armed();
  PadInput input = pressed(kPadX);
  teleop.on_pad(input);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kNone);
  teleop.on_pad(released());
  teleop.on_pad(held());
  input.buttons = kPadX | kPadLeftShoulder;
  teleop.on_pad(input);
  teleop.on_pad(input);  // still down: asked once
  EXPECT_EQ(teleop.take_action(), TeleopAction::kSway);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kNone);
}

TEST(Teleop, RunIsTheOneSeenWhenTakingHold) {
  Teleop teleop = armed();
  teleop.on_source(kTeleopRun + 1, false);
  teleop.on_pad(held());
  EXPECT_EQ(teleop.message(0, 0).run_id, kTeleopRun);
  teleop.on_pad(released());
  EXPECT_EQ(teleop.message(0, 0).run_id, kTeleopRun + 1);
}

TEST(Teleop, SequenceCountsEveryMessage) {
  Teleop teleop(7, false);
  for (int i = 1; i <= 5; ++i) EXPECT_EQ(teleop.message(i, 0).sequence, i);
  EXPECT_EQ(teleop.message(99, 0).utime, 99);
  EXPECT_EQ(teleop.message(99, 0).sender_id, 7);
}

TEST(Keyboard, KeysMoveSetPointsAndComeBackToExactlyZero) {
  Teleop teleop(7, true);
  for (int i = 0; i < 3; ++i) teleop.on_key('w', 0);
  EXPECT_FLOAT_EQ(teleop.message(0, 0).left_y, 0.3f);
  EXPECT_TRUE(teleop.message(0, 0).deadman);
  for (int i = 0; i < 3; ++i) teleop.on_key(kKeyDown, 0);
  EXPECT_EQ(teleop.message(0, 0).left_y, 0.0f);
  for (int i = 0; i < 30; ++i) teleop.on_key('a', 0);
  EXPECT_EQ(teleop.message(0, 0).left_x, 1.0f);
  teleop.on_key('x', 0);
  EXPECT_EQ(teleop.message(0, 0).left_x, 0.0f);
}

TEST(Keyboard, AnotherModeBeginsWithSetPointsAtZero) {
  for (const int key : {'1', '2', '3', '4', '5'}) {
    Teleop teleop(7, true);
    for (const int moves : {'w', 'w', 'w', 'a', 'k', 'j'}) teleop.on_key(moves, 0);
    ASSERT_FLOAT_EQ(teleop.message(0, 0).left_y, 0.3f);
    teleop.on_key(key, 0);
    Gamepad pad = teleop.message(0, 0);
    EXPECT_TRUE(pad.deadman);
    for (const float axis : {pad.left_x, pad.left_y, pad.right_x, pad.right_y}) EXPECT_EQ(axis, 0.0f) << key;
    teleop.on_key('w', 0);
    EXPECT_FLOAT_EQ(teleop.message(0, 0).left_y, 0.1f);
  }
}

TEST(Teleop, SticksPushedInOneModeCountInAnotherOnceCentred) {
  for (const std::int32_t button : {kPadUp, kPadA, kPadX, kPadY, kPadDown}) {
    Teleop teleop = armed();
    PadInput input = held();
    input.axes[1] = -32767;
    teleop.on_pad(input);
    ASSERT_FLOAT_EQ(teleop.message(0, 0).left_y, 1.0f);
    input.buttons |= button;
    for (int i = 0; i < 3; ++i) {
      teleop.on_pad(input);
      EXPECT_EQ(teleop.message(0, 0).left_y, 0.0f) << button;
      EXPECT_TRUE(teleop.message(0, 0).deadman);
    }
    input.buttons = kPadLeftShoulder;
    teleop.on_pad(input);
    EXPECT_EQ(teleop.message(0, 0).left_y, 0.0f);
    teleop.on_pad(held());
    teleop.on_pad(input);
    EXPECT_FLOAT_EQ(teleop.message(0, 0).left_y, 1.0f);
  }
}

TEST(Keyboard, SpaceStopsAndKeysDoNothingUntilCleared) {
  Teleop teleop(7, true);
  teleop.on_key('w', 0);
  teleop.on_key(' ', 0);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kStop);
  teleop.on_key('w', 0);
  EXPECT_TRUE(all_zero(teleop.message(0, 0)));
  EXPECT_TRUE(teleop.message(0, 0).stop);
  teleop.on_key('c', 0);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kClear);
  teleop.on_key('w', 0);
  EXPECT_FLOAT_EQ(teleop.message(0, 0).left_y, 0.1f);
}

TEST(Keyboard, LeftAloneItLetsGo) {
  Teleop teleop(7, true);
  teleop.on_key('w', 1);
  EXPECT_TRUE(teleop.message(0, 29 * kSecond).deadman);
  EXPECT_TRUE(all_zero(teleop.message(0, 31 * kSecond)));
  EXPECT_TRUE(all_zero(teleop.message(0, 2 * kSecond)));
}

TEST(Keyboard, LettingGoSendsZeros) {
  Teleop teleop(7, true);
  teleop.on_key('w', 1);
  teleop.let_go();
  EXPECT_TRUE(all_zero(teleop.message(0, 1)));
  EXPECT_FALSE(teleop.message(0, 1).connected);
}

TEST(Keyboard, UnknownKeysDoNothing) {
  Teleop teleop(7, true);
  for (int key = -5; key < 600; ++key) {
    if (key == ' ' || key == 'c' || key == 'q' || key == 3) continue;
    teleop.on_key(key, 0);
  }
  EXPECT_FALSE(teleop.stop_latched());
}

TEST(Teleop, AStopIsNotLostAmongManyActions) {
  Teleop teleop(7, true);
  for (int i = 0; i < 100; ++i) teleop.on_key('2', 0);
  teleop.on_key(' ', 0);
  bool stopped = false;
  for (TeleopAction a; (a = teleop.take_action()) != TeleopAction::kNone;) {
    stopped = stopped || a == TeleopAction::kStop;
  }
  EXPECT_TRUE(stopped);
}

TEST(CheatSheet, NamesEveryControl) {
  const std::string pad = cheat_sheet(false);
  for (const char* word : {"STOP", "back + start", "left bumper", "lean forward", "crouch"}) {
    EXPECT_NE(pad.find(word), std::string::npos) << word;
  }
  const std::string keys = cheat_sheet(true);
  for (const char* word : {"space", "STOP", "clear", "lean left", "sway", "quit"}) {
    EXPECT_NE(keys.find(word), std::string::npos) << word;
  }
}

TEST(Teleop, CapitalsMoveAHandByTwentyMillimetresAndLeaveTheBodyAlone) {
  Teleop teleop(7, true);
  teleop.on_source(kTeleopRun, false);
  for (const char key : {'W', 'W', 'D', 'I'}) teleop.on_key(key, kSecond);
  const std::array<double, 3> move = teleop.take_hand_move().by;
  EXPECT_NEAR(move[0], 0.04, 1e-12);
  EXPECT_NEAR(move[1], -0.02, 1e-12);
  EXPECT_NEAR(move[2], 0.02, 1e-12);
  EXPECT_EQ(teleop.take_hand_move().by[0], 0.0) << "once";
  const Gamepad pad = teleop.message(0, kSecond);
  EXPECT_TRUE(pad.deadman);
  EXPECT_EQ(pad.left_y, 0.0f);
  EXPECT_EQ(teleop.hand(), ArmSide::kLeft);
  teleop.on_key('h', kSecond);
  EXPECT_EQ(teleop.hand(), ArmSide::kRight);
  teleop.on_key(' ', kSecond);
  teleop.on_key('W', kSecond);
  EXPECT_EQ(teleop.take_hand_move().by[0], 0.0) << "while a stop is asked for";
}

TEST(Teleop, AllArmsOfARobotAreSteppedThrough) {
  Teleop keys(7, true);
  const std::array<ArmSide, 3> three{ArmSide::kThird, ArmSide::kFourth, ArmSide::kFifth};
  keys.set_hands(three);
  keys.on_source(kTeleopRun, false);
  EXPECT_EQ(keys.hand(), ArmSide::kThird);
  for (const ArmSide next : {ArmSide::kFourth, ArmSide::kFifth, ArmSide::kThird}) {
    keys.on_key('h', kSecond);
    EXPECT_EQ(keys.hand(), next);
  }
  Teleop pad = armed();
  pad.set_hands(three);
  const auto press = [&](std::int32_t button) {
    PadInput input = held();
    input.buttons |= kPadRightShoulder | button;
    pad.on_pad(input);
    input.buttons &= ~button;
    pad.on_pad(input);
    return pad.hand();
  };
  EXPECT_EQ(press(kPadRight), ArmSide::kFourth);
  EXPECT_EQ(press(kPadRight), ArmSide::kFifth);
  EXPECT_EQ(press(kPadRight), ArmSide::kFifth) << "it is the last";
  EXPECT_EQ(press(kPadLeft), ArmSide::kFourth);
  EXPECT_EQ(press(kPadLeft), ArmSide::kThird);
  EXPECT_EQ(press(kPadLeft), ArmSide::kThird) << "it is the first";
  pad.set_hands({});
  EXPECT_EQ(pad.hand(), ArmSide::kThird) << "of a robot without arms nothing is known";
}

TEST(Teleop, WithTheRightBumperTheSticksMoveAHandAndLeaveTheBodyAlone) {
  Teleop teleop = armed();
  PadInput input = held();
  input.buttons |= kPadRightShoulder | kPadRight;
  input.axes[1] = -32767;
  for (int cycle = 0; cycle < 100; ++cycle) teleop.on_pad(input);
  EXPECT_NEAR(teleop.take_hand_move().by[0], 0.10, 1e-6) << "after a second at full stick";
  EXPECT_EQ(teleop.message(0, 0).left_y, 0.0f);
  EXPECT_EQ(teleop.hand(), ArmSide::kRight);
  teleop.on_pad(input);
  teleop.on_pad(released());
  EXPECT_EQ(teleop.take_hand_move().by[0], 0.0) << "who has let go moves nothing";
}

TEST(Teleop, CapitalsTurnAHandAndSignsMoveAJoint) {
  Teleop teleop(7, true);
  teleop.on_source(kTeleopRun, false);
  for (const char key : {'O', 'O', 'G', 'J', '+', '=', '-', '+'}) teleop.on_key(key, kSecond);
  const HandMove move = teleop.take_hand_move();
  EXPECT_EQ(move.by, (std::array<double, 3>{}));
  EXPECT_NEAR(move.turn[0], 0.10, 1e-12);
  EXPECT_NEAR(move.turn[1], -0.05, 1e-12);
  EXPECT_NEAR(move.turn[2], 0.05, 1e-12);
  EXPECT_NEAR(teleop.take_joint_move(), 0.2, 1e-12);
  EXPECT_EQ(teleop.take_joint_move(), 0.0) << "once";
  teleop.on_key(']', kSecond);
  teleop.on_key('[', kSecond);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kNextJoint);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kPreviousJoint);
  teleop.on_key('+', kSecond);
  teleop.on_key('x', kSecond);
  EXPECT_EQ(teleop.take_joint_move(), 0.0) << "x stops it";
  teleop.on_key(' ', kSecond);
  for (const char key : {'+', 'O'}) teleop.on_key(key, kSecond);
  EXPECT_EQ(teleop.take_joint_move(), 0.0) << "while a stop is asked for";
  EXPECT_EQ(teleop.take_hand_move().turn[0], 0.0);
}

TEST(Keyboard, AnotherModeForgetsHowAHandOrJointWasToMove) {
  for (const int key : {'1', '2', '3', '4', '5'}) {
    Teleop teleop(7, true);
    for (const char moves : {'W', 'O', '+'}) teleop.on_key(moves, 0);
    teleop.on_key(key, 0);
    const HandMove move = teleop.take_hand_move();
    EXPECT_EQ(move.by, (std::array<double, 3>{})) << key;
    EXPECT_EQ(move.turn, (std::array<double, 3>{}));
    EXPECT_EQ(teleop.take_joint_move(), 0.0);
    teleop.on_key('+', 0);
    EXPECT_NEAR(teleop.take_joint_move(), 0.1, 1e-12);
  }
}

TEST(Teleop, InAnotherModeTheSticksMoveAHandOrJointOnceCentred) {
  for (const std::int16_t trigger : {std::int16_t{0}, std::int16_t{32767}}) {
    Teleop teleop = armed();
    PadInput input = held();
    input.buttons |= kPadRightShoulder;
    input.axes = {0, 0, 0, -32767, 0, trigger};
    const auto moved = [&] { return teleop.take_joint_move() + teleop.take_hand_move().by[2]; };
    teleop.on_pad(input);
    ASSERT_GT(moved(), 0.0);
    teleop.on_pad(input);
    input.buttons |= kPadUp;
    for (int cycle = 0; cycle < 3; ++cycle) teleop.on_pad(input);
    EXPECT_EQ(teleop.take_action(), TeleopAction::kWalk);
    input.buttons &= ~kPadUp;
    for (int cycle = 0; cycle < 3; ++cycle) teleop.on_pad(input);
    EXPECT_EQ(moved(), 0.0) << trigger;
    input.axes[3] = 0;
    teleop.on_pad(input);
    input.axes[3] = -32767;
    teleop.on_pad(input);
    EXPECT_GT(moved(), 0.0);
  }
}

TEST(Teleop, WithATriggerTheSticksTurnTheHandOrMoveAJoint) {
  Teleop teleop = armed();
  PadInput input = held();
  input.buttons |= kPadRightShoulder;
  input.axes = {32767, 0, 0, -32767, 32767, 0};  // left trigger
  for (int cycle = 0; cycle < 100; ++cycle) teleop.on_pad(input);
  HandMove move = teleop.take_hand_move();
  EXPECT_NEAR(move.turn[0], 0.4, 1e-6) << "to the right: rolls to the right";
  EXPECT_EQ(move.by, (std::array<double, 3>{}));
  EXPECT_EQ(teleop.take_joint_move(), 0.0);
  input.axes = {32767, 0, 0, -32767, 0, 32767};  // right trigger
  for (int cycle = 0; cycle < 100; ++cycle) teleop.on_pad(input);
  move = teleop.take_hand_move();
  EXPECT_EQ(move.turn[0], 0.0);
  EXPECT_EQ(move.by, (std::array<double, 3>{}));
  EXPECT_NEAR(teleop.take_joint_move(), 1.0, 1e-6);
  EXPECT_EQ(teleop.message(0, 0).right_trigger, 0.0f) << "the body is left alone";
  input.buttons |= kPadRight;
  teleop.on_pad(input);
  EXPECT_EQ(teleop.take_action(), TeleopAction::kNextJoint);
  EXPECT_EQ(teleop.hand(), ArmSide::kLeft) << "no hand is chosen by it";
  teleop.on_pad(released());
  EXPECT_EQ(teleop.take_joint_move(), 0.0) << "who has let go moves nothing";
}

}  // namespace
}  // namespace twinbus
