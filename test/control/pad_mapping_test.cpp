#include "control/teleop/pad_mapping.h"

#include <gtest/gtest.h>

#include <array>

namespace twinbus {
namespace {

class PadMapping : public ::testing::Test {
 protected:
  RawPad raw() const { return {axes_, buttons_, hats_}; }
  void press(std::size_t button) {
    buttons_[button] = 1;
    EXPECT_FALSE(mapper_.look(raw()));
    buttons_[button] = 0;
    answered_ = mapper_.look(raw());
  }
  void push(std::size_t axis, std::int16_t value) {
    const std::int16_t rest = axes_[axis];
    axes_[axis] = value;
    EXPECT_FALSE(mapper_.look(raw()));
    axes_[axis] = rest;
    answered_ = mapper_.look(raw());
  }
  std::array<std::int16_t, 6> axes_{0, 0, 0, 0, -32768, -32768};  // triggers rest at one end
  std::array<std::uint8_t, 12> buttons_{};
  std::array<std::uint8_t, 1> hats_{};
  PadMapper mapper_;
  bool answered_ = false;
};

TEST_F(PadMapping, LearnsButtonsHatsSticksAndTriggersOneByOne) {
  mapper_.rest(raw());
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_FALSE(mapper_.question().empty());
    press(11 - i);
    EXPECT_TRUE(answered_);
  }
  for (const std::uint8_t hat : {std::uint8_t{1}, std::uint8_t{4}}) {
    hats_[0] = hat;
    EXPECT_FALSE(mapper_.look(raw()));
    hats_[0] = 0;
    EXPECT_TRUE(mapper_.look(raw()));
  }
  push(0, 32767);
  push(1, -32768);  // this pad counts the other way
  push(2, 32767);
  push(3, 32767);
  push(4, 32767);
  push(5, 32767);
  EXPECT_TRUE(mapper_.question().empty());
  EXPECT_EQ(mapper_.line("00112233445566778899aabbccddeeff", "My, pad"),
            "00112233445566778899aabbccddeeff,My  "
            "pad,a:b11,b:b10,x:b9,y:b8,leftshoulder:b7,rightshoulder:b6,back:b5,"
            "start:b4,dpup:h0.1,dpdown:h0.4,leftx:a0,lefty:a1~,rightx:a2,righty:a3,lefttrigger:a4,"
            "righttrigger:a5,"
            "platform:Linux,");
}

TEST_F(PadMapping, AControlAnswersOneQuestionOnlyAndMayBeSkipped) {
  mapper_.rest(raw());
  press(0);
  EXPECT_TRUE(answered_);
  const std::string question = mapper_.question();
  press(0);
  EXPECT_FALSE(answered_);
  EXPECT_EQ(mapper_.question(), question);
  mapper_.skip();
  EXPECT_NE(mapper_.question(), question);
}

}  // namespace
}  // namespace twinbus
