#include "control/teleop/sdl_pad.h"

#include <gtest/gtest.h>

#include <cstring>

namespace twinbus {
namespace {

// SDL's own path of a real pad, driven by a pad that exists in SDL only.
TEST(SdlPad, HotPlugAxesAndButtonsArriveAndUnpluggingIsSeen) {
  SdlPad pad;
  VirtualPad device;
  PadInput input;
  pad.poll(input);
  EXPECT_FALSE(input.connected);

  ASSERT_TRUE(device.plug());
  pad.poll(input);
  ASSERT_TRUE(input.connected);
  EXPECT_GT(std::strlen(input.name.data()), 0u);

  device.set_axis(1, -32000);
  device.set_button(kPadLeftShoulder, true);
  device.set_button(kPadB, true);
  pad.poll(input);
  EXPECT_EQ(input.axes[1], -32000);
  EXPECT_EQ(input.buttons, kPadLeftShoulder | kPadB);

  device.unplug();
  pad.poll(input);
  EXPECT_FALSE(input.connected);
  EXPECT_EQ(input.buttons, 0);
  EXPECT_EQ(input.axes[1], 0);

  ASSERT_TRUE(device.plug());
  pad.poll(input);
  EXPECT_TRUE(input.connected);
  EXPECT_EQ(input.buttons, 0);
}

// From the pad to GAMEPAD.
struct Cycle {
  SdlPad pad;
  Teleop teleop{1, false};
  PadInput input;
  Gamepad operator()() {
    pad.poll(input);
    teleop.on_pad(input);
    return teleop.message(0, 0);
  }
};

TEST(SdlPad, UnpluggingWhileHeldLetsGo) {
  VirtualPad device;
  Cycle cycle;
  ASSERT_TRUE(device.plug());
  cycle();
  device.set_button(kPadLeftShoulder, true);
  EXPECT_TRUE(cycle().deadman);
  device.set_axis(1, -32768);
  EXPECT_FLOAT_EQ(cycle().left_y, 1.0f);
  device.unplug();
  const Gamepad gone = cycle();
  EXPECT_FALSE(gone.deadman);
  EXPECT_FALSE(gone.connected);
  EXPECT_EQ(gone.left_y, 0.0f);
}

// Whoever holds the button of a second pad has not taken hold of the robot.
TEST(SdlPad, AnotherPadDoesNotGoOnWhereOneVanished) {
  VirtualPad first, second;
  Cycle cycle;
  ASSERT_TRUE(first.plug());
  cycle();
  ASSERT_TRUE(second.plug());
  first.set_button(kPadLeftShoulder, true);
  second.set_button(kPadLeftShoulder, true);
  EXPECT_TRUE(cycle().deadman);
  first.unplug();
  EXPECT_FALSE(cycle().connected);
  EXPECT_FALSE(cycle().deadman);
  EXPECT_TRUE(cycle.input.connected);
}

TEST(SdlPad, ItIsShaken) {
  SdlPad pad;
  VirtualPad device;
  PadInput input;
  ASSERT_TRUE(device.plug());
  pad.poll(input);
  pad.rumble(0.1);
  EXPECT_EQ(device.rumbles(), 1);
}

}  // namespace
}  // namespace twinbus
