#include "lcmtypes/bus/inbox.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "test/lcmtypes/samples.h"

namespace twinbus {
namespace {

RobotState state_of(std::int64_t run_id, std::int64_t tick) {
  RobotState state = sample<RobotState>();
  state.run_id = run_id;
  state.tick = tick;
  return state;
}

TEST(Latest, KeepsTheNewestAndGivesItOutOnce) {
  Latest<RobotState> latest;
  latest.offer(state_of(1, 10), 100);
  latest.offer(state_of(1, 11), 200);
  RobotState out;
  ASSERT_TRUE(latest.take(out));
  EXPECT_EQ(out.tick, 11);
  EXPECT_FALSE(latest.take(out));
  EXPECT_EQ(latest.received, 2);
}

TEST(Latest, CountsGapsRepetitionsAndMessagesThatComeLate) {
  Latest<RobotState> latest;
  EXPECT_EQ(latest.offer(state_of(1, 10), 1), Verdict::kTaken);
  EXPECT_EQ(latest.offer(state_of(1, 14), 2), Verdict::kTaken);
  EXPECT_EQ(latest.offer(state_of(1, 14), 3), Verdict::kRepeated);
  EXPECT_EQ(latest.offer(state_of(1, 12), 4), Verdict::kRejected);
  EXPECT_EQ(latest.lost, 3);
  EXPECT_EQ(latest.repeated, 1);
  EXPECT_EQ(latest.rejected, 1);
  EXPECT_EQ(latest.message.tick, 14);
}

TEST(Latest, WhoAnswersEveryTenthTickEvenlyHasLostNothing) {
  Latest<RobotState> latest;
  for (int k = 0; k < 100; ++k) latest.offer(state_of(1, 10 * k), k + 1);
  EXPECT_EQ(latest.lost, 18);  // until its rate is known
  latest.offer(state_of(1, 1000 + 10), 200);
  EXPECT_EQ(latest.lost, 18 + 1);
}

TEST(Latest, ASlowSenderWhoseTurnsAreEarlyOrLateHasLostNothing) {
  Latest<RobotState> latest;
  std::int64_t tick = 0;
  for (int k = 0; k < 200; ++k) latest.offer(state_of(1, tick += 7 + k % 7 * k % 5 + (k % 3 == 0 ? 3 : 0)), k + 1);
  EXPECT_LE(latest.lost, 25);  // of 1,800 ticks not answered
}

TEST(Latest, WhatAFastSenderLosesIsCounted) {
  Latest<RobotState> latest;
  int kept = 0;
  for (int k = 0; k < 1000; ++k) {
    if (k % 4 == 3 || k % 11 == 5) continue;
    latest.offer(state_of(1, k), ++kept);
  }
  EXPECT_LE(std::abs(latest.lost - (1000 - kept)), 10);
}

TEST(Latest, AnotherSenderStartsItsOwnCount) {
  Latest<RobotState> latest;
  latest.offer(state_of(1, 1000), 1);
  EXPECT_EQ(latest.offer(state_of(2, 5), 2), Verdict::kTaken);
  EXPECT_EQ(latest.lost, 0);
}

TEST(Latest, WhatIsNotAdmittedNeitherHidesNorReplacesTheGoodOne) {
  const auto only_run_1 = [](const RobotState& candidate, const RobotState&) noexcept {
    return candidate.run_id == 1;
  };
  Latest<RobotState> latest;
  latest.admit_by(only_run_1);
  latest.offer(state_of(1, 10), 1);
  EXPECT_EQ(latest.offer(state_of(66, 999'999), 2), Verdict::kRejected);
  EXPECT_EQ(latest.offer(state_of(1, 11), 3), Verdict::kTaken);
  EXPECT_EQ(latest.message.tick, 11);
  EXPECT_EQ(latest.rejected, 1);
}

TEST(Latest, AgeRunsFromTheLastAdmittedMessage) {
  Latest<RobotState> latest;
  EXPECT_GT(latest.age(1'000'000'000), 1e8);
  latest.offer(state_of(1, 10), 1'000'000'000);
  EXPECT_DOUBLE_EQ(latest.age(1'500'000'000), 0.5);
}

Heartbeat heartbeat_of(std::int64_t process_id) {
  Heartbeat heartbeat = sample<Heartbeat>();
  heartbeat.process_id = process_id;
  return heartbeat;
}

TEST(Slots, KeepOneMessagePerSender) {
  Slots<Heartbeat, 4> slots;
  for (int round = 0; round < 3; ++round) {
    for (std::int64_t id = 1; id <= 4; ++id) slots.offer(heartbeat_of(id), 1'000'000'000 + round);
  }
  for (std::int64_t id = 1; id <= 4; ++id) {
    ASSERT_NE(slots.find(id), nullptr);
    EXPECT_EQ(slots.find(id)->received, 3);
  }
  EXPECT_EQ(slots.find(5), nullptr);
}

TEST(Slots, AFullTableRefusesNewSendersUntilOneHasGoneSilent) {
  Slots<Heartbeat, 2> slots;
  slots.offer(heartbeat_of(1), 1'000'000'000);
  slots.offer(heartbeat_of(2), 5'000'000'000);
  EXPECT_EQ(slots.offer(heartbeat_of(3), 5'500'000'000), Verdict::kRejected);
  EXPECT_EQ(slots.rejected, 1);
  EXPECT_EQ(slots.offer(heartbeat_of(3), 6'500'000'000), Verdict::kTaken);
  EXPECT_EQ(slots.find(1), nullptr);
  EXPECT_NE(slots.find(2), nullptr);
}

}  // namespace
}  // namespace twinbus
