#include "launcher/bus/bus_health.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kStep = 100'000'000;  // [ns]

// A controller that hears STATE, the first channel of the table.
class Heard {
 public:
  explicit Heard(int channel = 1, ProcessKind kind = ProcessKind::kController) {
    process_.beat.process_id = 7;
    process_.beat.pid = 70;
    process_.beat.kind = kind;
    process_.beat.channels = 1;
    process_.beat.channel[0] = static_cast<std::int8_t>(channel);
  }
  // So many more messages in a second, of which so many are missing or refused, and the age of the newest at its end.
  std::vector<std::string> second(int received, int lost, int rejected, float age_ms, bool paused = false) {
    std::vector<std::string> all;
    for (int i = 0; i < 10; ++i) {
      now_ += kStep;
      process_.beat.channel_received[0] += received / 10;
      process_.beat.channel_lost[0] += lost / 10;
      process_.beat.channel_rejected[0] += rejected / 10;
      process_.beat.channel_age_ms[0] = age_ms;
      for (std::string& alarm : health_.look({&process_}, now_, paused)) all.push_back(std::move(alarm));
    }
    return all;
  }
  const SeenProcess& process() const { return process_; }

 private:
  SeenProcess process_;
  BusHealth health_;
  std::int64_t now_ = 1'000'000'000;
};

TEST(BusHealth, AHealthyChannelRaisesNoAlarm) {
  Heard heard;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(heard.second(500, 0, 0, 1.0F).empty());
}

TEST(BusHealth, WhatAPauseLeftBehindInHeartbeatsIsNoSilence) {
  Heard heard;
  for (int i = 0; i < 7; ++i) heard.second(500, 0, 0, 1.0F);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(heard.second(0, 0, 0, 900.0F, true).empty());
  EXPECT_TRUE(heard.second(0, 0, 0, 900.0F).empty());
  EXPECT_TRUE(heard.second(500, 0, 0, 1.0F).empty());
  for (int i = 0; i < 2; ++i) heard.second(500, 0, 0, 1.0F);
  EXPECT_EQ(heard.second(0, 0, 0, 900.0F).size(), 1u);
}

// sim pace 5: the guard looks at the newest state, as fast as it can.
TEST(BusHealth, WhoeverDoesNotKeepUpWithAHurriedWorldIsNoAlarm) {
  Heard heard;
  for (int i = 0; i < 7; ++i) heard.second(500, 0, 0, 1.0F);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(heard.second(1500, 1000, 0, 1.0F, true).empty());
  EXPECT_TRUE(heard.second(500, 100, 0, 1.0F).empty());  // what its last heartbeat tells
  for (int i = 0; i < 2; ++i) heard.second(500, 0, 0, 1.0F);
  std::size_t alarms = 0;
  for (int i = 0; i < 2; ++i) alarms += heard.second(400, 100, 0, 1.0F).size();
  EXPECT_EQ(alarms, 1u);
}

TEST(BusHealth, MissingAndRefusedMessagesAreSaidOnceInAWhile) {
  Heard heard;
  heard.second(500, 0, 0, 1.0F);
  heard.second(500, 0, 0, 1.0F);
  int alarms = 0;
  for (int i = 0; i < 8; ++i) {
    for (const std::string& alarm : heard.second(400, 100, 0, 1.0F)) {
      EXPECT_NE(alarm.find("controller (pid 70): "), std::string::npos) << alarm;
      EXPECT_NE(alarm.find("on STATE are missing"), std::string::npos) << alarm;
      ++alarms;
    }
  }
  EXPECT_EQ(alarms, 1);
}

TEST(BusHealth, ABusyChannelThatFallsSilentIsSaid) {
  Heard heard;
  heard.second(500, 0, 0, 1.0F);
  heard.second(500, 0, 0, 1.0F);
  const std::vector<std::string> alarms = heard.second(0, 0, 0, 900.0F);
  ASSERT_EQ(alarms.size(), 1u);
  EXPECT_NE(alarms[0].find("hears nothing on STATE any more"), std::string::npos);
  EXPECT_TRUE(heard.second(0, 0, 0, 1900.0F).empty());
}

// A source that takes over leaves STATE_SIM, the second row of the table, for STATE.
TEST(BusHealth, AStandbyThatBecomesActiveIsNoAlarm) {
  Heard heard(2);
  heard.second(500, 0, 0, 1.0F);
  heard.second(500, 0, 0, 1.0F);
  EXPECT_TRUE(heard.second(0, 0, 0, 900.0F).empty());
}

// STATE_SIM again: its states come from another tick on after a restart, and a bridge that starts hears what is not for it.
TEST(BusHealth, WhatAStandbyChannelMissesOrRefusesIsNoAlarm) {
  Heard heard(2);
  for (int i = 0; i < 8; ++i) heard.second(500, 0, 0, 1.0F);
  EXPECT_TRUE(heard.second(500, 8800, 250, 1.0F).empty());
}

TEST(BusHealth, AStartIsNoAlarmNorAreTheTicksOfANewRun) {
  Heard heard;
  EXPECT_TRUE(heard.second(500, 0, 250, 1.0F).empty());
  EXPECT_TRUE(heard.second(500, 0, 250, 1.0F).empty());
  for (int i = 0; i < 5; ++i) heard.second(500, 0, 0, 1.0F);
  EXPECT_TRUE(heard.second(500, 200000, 0, 1.0F).empty());
  EXPECT_FALSE(heard.second(500, 0, 250, 1.0F).empty());
}

// After every stop it refuses the commands of the robot that is stopped.
TEST(BusHealth, WhatAPageRefusesIsNoAlarm) {
  Heard page(1, ProcessKind::kViewer), loop(1, ProcessKind::kSimulator);
  for (int i = 0; i < 8; ++i) {
    page.second(500, 0, 0, 1.0F);
    loop.second(500, 0, 0, 1.0F);
  }
  EXPECT_TRUE(page.second(500, 0, 500, 1.0F).empty());
  EXPECT_FALSE(loop.second(500, 0, 500, 1.0F).empty());
}

TEST(BusHealth, AQuietChannelMayBeSilent) {
  Heard heard;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(heard.second(10, 0, 0, 900.0F).empty());
}

TEST(BusHealth, ARowThatIsNotKnownIsAQuestionMark) {
  Heartbeat beat;
  beat.channel[0] = 127;
  beat.channel[1] = -3;
  EXPECT_STREQ(heard_channel(beat, 0), "?");
  EXPECT_STREQ(heard_channel(beat, 1), "?");
}

TEST(BusHealth, TheTableNamesProcessAndChannel) {
  Heard heard;
  heard.second(500, 20, 0, 1.0F);
  const std::vector<std::string> lines = channel_lines({&heard.process()});
  ASSERT_EQ(lines.size(), 5u);
  for (const std::string& line : lines) EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_NE(lines[1].find("controller"), std::string::npos);
  EXPECT_NE(lines[1].find("STATE"), std::string::npos);
  EXPECT_NE(lines[2].find("lost: numbers that never came"), std::string::npos);
}

// A stranger's heartbeat: counters from one end of their range to the other, back and forth.
TEST(BusHealth, CountersThatNobodyCountedRaiseNoAlarm) {
  SeenProcess process;
  process.beat.channels = 1;
  process.beat.channel[0] = 1;
  BusHealth health;
  for (int i = 0; i < 12; ++i) {
    const std::int32_t wild = i % 2 == 0 ? INT32_MAX : INT32_MIN;
    process.beat.channel_received[0] = process.beat.channel_lost[0] =
        process.beat.channel_rejected[0] = wild;
    for (const std::string& alarm : health.look({&process}, (i + 1) * std::int64_t{1'000'000'000}))
      EXPECT_EQ(alarm.find("messages on"), std::string::npos) << alarm;
  }
}

}  // namespace
}  // namespace twinbus
