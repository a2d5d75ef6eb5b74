#include "control/loop/driver_token.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kTick = 10'000'000;  // [ns]

Gamepad pad(std::int64_t sender, bool deadman) {
  return {.sender_id = sender, .connected = true, .deadman = deadman};
}

TEST(DriverToken, TheFirstWhoHoldsTheButtonDrivesUntilItLetsGo) {
  DriverToken token;
  std::int64_t now = kTick;
  EXPECT_TRUE(token.admits(pad(1, true), now));
  EXPECT_FALSE(token.admits(pad(2, false), now += kTick));
  EXPECT_FALSE(token.admits(pad(2, true), now += kTick));
  EXPECT_TRUE(token.admits(pad(1, true), now += kTick));
  EXPECT_EQ(token.driver(), 1);
  EXPECT_TRUE(token.admits(pad(1, false), now += kTick));
  EXPECT_EQ(token.driver(), 0);
}

TEST(DriverToken, WhoPressedWhileAnotherDroveMustPressAnew) {
  DriverToken token;
  std::int64_t now = kTick;
  EXPECT_TRUE(token.admits(pad(1, true), now));
  EXPECT_FALSE(token.admits(pad(2, true), now += kTick));
  EXPECT_TRUE(token.admits(pad(1, false), now += kTick));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(token.admits(pad(2, true), now += kTick));
  EXPECT_TRUE(token.admits(pad(2, false), now += kTick));
  EXPECT_TRUE(token.admits(pad(2, true), now += kTick));
  EXPECT_EQ(token.driver(), 2);
}

TEST(DriverToken, ADriverThatFallsSilentHasLetGo) {
  DriverToken token;
  std::int64_t now = kTick;
  EXPECT_TRUE(token.admits(pad(1, true), now));
  now += 300'000'000;
  EXPECT_TRUE(token.admits(pad(2, true), now));
  EXPECT_EQ(token.driver(), 2);
  // The first one comes back: it is not the driver any more.
  EXPECT_FALSE(token.admits(pad(1, true), now += kTick));
}

}  // namespace
}  // namespace twinbus
