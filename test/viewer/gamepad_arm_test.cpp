// The cycle of the gamepad process around a jogged joint, over a bus in memory: what goes out, and what comes to the terminal.

#include "control/gamepad_arm_main.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "robot/description/load.h"
#include "test/carried_arms.h"

namespace twinbus {
namespace {

constexpr std::int64_t kCycle = 10'000'000;

class JogOverTheBus : public ::testing::Test {
 protected:
  JogOverTheBus()
      : model_(load_robot("hrp1s")),
        bus_({.url = "memq://", .prefix = "", .allow = {}}),
        arm_(model_, 7),
        requests_(7),
        teleop_(7, true) {
    arm_.listen(bus_);
    bus_.listen<&JogOverTheBus::hear>(channel::kModeRequest, *this);
    state_.run_id = 42;
    state_.model_hash = model_.hash;
    state_.joint_count = static_cast<std::int16_t>(model_.bus_count());
    teleop_.on_source(42, false);
    show(Mode::kHold);
  }
  void hear(const ModeRequest& request) { heard_.push_back(request); }
  void show(Mode mode) {
    ControllerStatus status;
    status.mode = mode;
    ASSERT_TRUE(bus_.send(channel::kControllerStatus, status));
  }
  // As gamepad_main.cpp does it, with these keys before each.
  void cycles(int count, const std::string& keys) {
    for (int i = 0; i < count; ++i) {
      now_ns_ += kCycle;
      bus_.receive(0);
      for (const char key : keys) teleop_.on_key(key, now_ns_);
      for (TeleopAction action; (action = teleop_.take_action()) != TeleopAction::kNone;) {
        arm_.on_action(action);
        requests_.start(action, state_);
      }
      requests_.send(bus_);
      arm_.update(state_, true, teleop_);
      arm_.ask_for_pose(now_ns_, state_, requests_);
    }
    bus_.receive(0);
  }
  // How often the newest request of this mode was said.
  int said(Mode mode) const {
    const auto last = std::find_if(heard_.rbegin(), heard_.rend(), [&](const ModeRequest& r) { return r.mode == mode; });
    return last == heard_.rend() ? 0 : static_cast<int>(std::count_if(heard_.begin(), heard_.end(), [&](const ModeRequest& r) {
      return r.sequence == last->sequence;
    }));
  }

  Model model_;
  Bus bus_;
  GamepadArm arm_;
  Requests requests_;
  Teleop teleop_;
  RobotState state_;
  std::vector<ModeRequest> heard_;
  std::int64_t now_ns_ = 1'000'000'000;
};

TEST_F(JogOverTheBus, AModeAskedForByTheOperatorIsSaidAsOftenAsWithoutAJog) {
  cycles(1, "4");
  cycles(20, "");
  const int without = said(Mode::kHold);
  EXPECT_EQ(without, Outgoing<ModeRequest>::kRepeats);
  ASSERT_EQ(said(Mode::kPose), 0);
  cycles(40, "+");
  ASSERT_GT(said(Mode::kPose), 0);
  for (const std::string key : {"1", "4", "5"}) {
    heard_.clear();
    cycles(1, key);
    cycles(20, "+");  // the key is held on
    const Mode mode = key == "1" ? Mode::kBalance : key == "4" ? Mode::kHold : Mode::kWalk;
    EXPECT_EQ(said(mode), without) << key;
    EXPECT_GT(said(Mode::kPose), 0) << "and then the jog, while the controller shows a mode in which it may";
  }
}

// 'h' goes from arm to arm; each is asked for by its number, and told by its name.
TEST(GamepadArm, EveryArmOfARobotIsMoved) {
  const Model model = test::three_arms();
  Bus bus({.url = "memq://", .prefix = "", .allow = {}});
  GamepadArm arm(model, 7);
  Teleop teleop(7, true);
  teleop.set_hands(arm.sides());
  teleop.on_source(42, false);
  arm.listen(bus);
  struct Goals {
    std::vector<ArmGoal> heard;
    void hear(const ArmGoal& goal) { heard.push_back(goal); }
  } goals;
  bus.listen<&Goals::hear>(channel::kArmGoal, goals);
  RobotState state;
  state.run_id = 42;
  state.model_hash = model.hash;
  state.joint_count = static_cast<std::int16_t>(model.bus_count());
  state.attitude = {1.0F, 0.0F, 0.0F, 0.0F};
  std::int64_t now = 1'000'000'000;
  for (const auto& [name, side] : {std::pair{"east", ArmSide::kThird}, {"north", ArmSide::kFourth}, {"west", ArmSide::kFifth}}) {
    goals.heard.clear();
    teleop.on_key('W', now);
    for (int i = 0; i < 40; ++i) {
      now += kCycle;
      arm.update(state, true, teleop);
      arm.send(bus, state, now / 1000, now);
      bus.receive(0);
    }
    ASSERT_FALSE(goals.heard.empty()) << name;
    EXPECT_EQ(goals.heard.back().side, side);
    EXPECT_EQ(goals.heard.back().kind, ArmGoalKind::kPosition);
    EXPECT_NE(arm.words(state).find(std::string("arm ") + name + " to "), std::string::npos) << arm.words(state);
    teleop.on_key('h', now);
  }
}

TEST_F(JogOverTheBus, LettingGoAfterAnotherModeIsNoPose) {
  cycles(40, "+");
  ASSERT_GT(said(Mode::kPose), 0);
  cycles(1, "5");
  heard_.clear();
  cycles(3, "");
  teleop_.let_go();
  cycles(50, "");
  EXPECT_EQ(said(Mode::kPose), 0);
  EXPECT_GT(said(Mode::kWalk), 0);
}

TEST_F(JogOverTheBus, AJogEndsWithAModeThatSomebodyElseChose) {
  cycles(40, "+");
  show(Mode::kIdle);
  bus_.receive(0);
  cycles(5, "");
  heard_.clear();
  cycles(20, "+");
  teleop_.let_go();
  cycles(20, "");
  EXPECT_TRUE(heard_.empty());
}

TEST_F(JogOverTheBus, LettingGoStillStopsTheJoint) {
  cycles(40, "+");
  heard_.clear();
  teleop_.let_go();
  cycles(10, "");
  EXPECT_EQ(said(Mode::kPose), Outgoing<ModeRequest>::kRepeats);
}

TEST_F(JogOverTheBus, WhatOthersTellComesToTheTerminalAsText) {
  cycles(1, "+");
  Event event;
  event.kind = ProcessKind::kController;
  std::snprintf(event.text.data(), event.text.size(), "the way is\x1b[2J barred\nby the door");
  ASSERT_TRUE(bus_.send(channel::kEvent, event));
  bus_.receive(0);
  EXPECT_EQ(arm_.take_sentence(), "the way is?[2J barred?by the door");
}

}  // namespace
}  // namespace twinbus
