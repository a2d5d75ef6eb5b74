#include "control/loop/driver_token.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kTick = 10'000'000;  // [ns]

class DriverTokenTest : public ::testing::Test {
 protected:
  // The next message of a pad, so much later.
  bool admits(std::int64_t sender, bool deadman, std::int64_t later = kTick) {
    return token.admits({.sender_id = sender, .connected = true, .deadman = deadman}, now += later);
  }
  DriverToken token;
  std::int64_t now = 0;
};

TEST_F(DriverTokenTest, TheFirstWhoHoldsTheButtonDrivesUntilItLetsGo) {
  EXPECT_TRUE(admits(1, true));
  EXPECT_FALSE(admits(2, false));
  EXPECT_FALSE(admits(2, true));
  EXPECT_TRUE(admits(1, true));
  EXPECT_EQ(token.driver(), 1);
  EXPECT_TRUE(admits(1, false));
  EXPECT_EQ(token.driver(), 0);
}

TEST_F(DriverTokenTest, WhoPressedWhileAnotherDroveMustPressAnew) {
  EXPECT_TRUE(admits(1, true));
  EXPECT_FALSE(admits(2, true));
  EXPECT_TRUE(admits(1, false));
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(admits(2, true));
  EXPECT_TRUE(admits(2, false));
  EXPECT_TRUE(admits(2, true));
  EXPECT_EQ(token.driver(), 2);
}

TEST_F(DriverTokenTest, ADriverThatFallsSilentHasLetGo) {
  EXPECT_TRUE(admits(1, true));
  EXPECT_TRUE(admits(2, true, 300'000'000));
  EXPECT_EQ(token.driver(), 2);
  // The first one comes back: it is not the driver any more.
  EXPECT_FALSE(admits(1, true));
}

}  // namespace
}  // namespace twinbus
