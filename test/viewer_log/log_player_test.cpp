#include "viewer_log/log/log_player.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "viewer_log/log/log_writer.h"

namespace twinbus {
namespace {

class LogPlayerTest : public ::testing::Test {
 protected:
  LogPlayerTest() {
    LogWriter writer(file_);
    for (int i = 0; i <= 2000; ++i) {
      const auto byte = static_cast<std::uint8_t>(i);
      writer.add(5'000'000 + 2000 * i, "STATE", std::vector<std::uint8_t>(10, byte));
    }
    writer.close();
  }
  ~LogPlayerTest() override { std::filesystem::remove(file_); }
  int passed(LogPlayer& player, double dt) {
    int count = 0;
    player.advance(dt, [&](const LogEvent& event) { count += event.channel == "STATE"; });
    return count;
  }
  const std::string file_ = std::filesystem::temp_directory_path() /
                            ("twinbus_log_player_test." + std::to_string(getpid()) + ".log");
};

TEST_F(LogPlayerTest, PassesEveryEventOnceInItsTime) {
  LogPlayer player(file_);
  EXPECT_NEAR(player.duration(), 4.0, 1e-9);
  int all = 0;
  for (int i = 0; i < 2100; ++i) {
    const int count = passed(player, 0.002);
    EXPECT_LE(count, 2);
    all += count;
  }
  EXPECT_EQ(all, 2001);
  EXPECT_TRUE(player.at_end());
}

TEST_F(LogPlayerTest, SpeedPauseAndSeek) {
  LogPlayer player(file_);
  player.set_speed(4.0);
  EXPECT_EQ(passed(player, 0.1), 201);
  EXPECT_NEAR(player.position(), 0.4, 1e-6);
  player.pause(true);
  EXPECT_EQ(passed(player, 1.0), 0);
  player.pause(false);
  player.set_speed(0.5);
  player.seek(2.0);
  EXPECT_NEAR(player.position(), 2.0, 1e-6);
  EXPECT_EQ(passed(player, 0.1), 26);  // the one at 2.0 and 25 behind it
  player.seek(-3.0);
  EXPECT_NEAR(player.position(), 0.0, 1e-9);
  player.seek(1e300);
  EXPECT_NEAR(player.position(), 4.0, 1e-6);
}

TEST_F(LogPlayerTest, LoopsWhenAsked) {
  LogPlayer player(file_);
  player.set_loop(true);
  player.seek(3.99);
  for (int i = 0; i < 10; ++i) (void)passed(player, 0.002);
  EXPECT_EQ(player.loops(), 1);
  EXPECT_LT(player.position(), 0.1);
  EXPECT_FALSE(player.at_end());
}

}  // namespace
}  // namespace twinbus
