#include "control/loop/mode_queue.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kQueueRun = 5;

ModeRequest request(std::int32_t sequence, std::int64_t at_tick, std::int64_t run = kQueueRun,
                    std::int64_t sender = 1) {
  return {.sender_id = sender, .run_id = run, .at_tick = at_tick, .sequence = sequence};
}

TEST(ModeQueue, ARequestWaitsForItsTickAndComesOnce) {
  ModeQueue queue;
  ASSERT_TRUE(queue.add(request(1, 100), kQueueRun));
  EXPECT_EQ(queue.take(99), nullptr);
  ASSERT_NE(queue.take(100), nullptr);
  EXPECT_EQ(queue.take(101), nullptr);
}

TEST(ModeQueue, TheEarlierTickComesFirst) {
  ModeQueue queue;
  ASSERT_TRUE(queue.add(request(1, 20), kQueueRun));
  ASSERT_TRUE(queue.add(request(2, 10), kQueueRun));
  EXPECT_EQ(queue.take(30)->sequence, 2);
  EXPECT_EQ(queue.take(30)->sequence, 1);
}

TEST(ModeQueue, ARequestForAnotherRunDoesNothing) {
  ModeQueue queue;
  EXPECT_FALSE(queue.add(request(1, 0, kQueueRun + 1), kQueueRun));
  EXPECT_EQ(queue.take(1000), nullptr);
}

TEST(ModeQueue, RepetitionAndOldSequencesDoNothing) {
  ModeQueue queue;
  ASSERT_TRUE(queue.add(request(7, 0), kQueueRun));
  EXPECT_FALSE(queue.add(request(7, 0), kQueueRun));
  EXPECT_FALSE(queue.add(request(6, 0), kQueueRun));
  EXPECT_TRUE(queue.add(request(6, 0, kQueueRun, 2), kQueueRun)) << "another sender counts for itself";
}

TEST(ModeQueue, AFullQueueRefusesAndKeepsWhatItHas) {
  ModeQueue queue;
  int taken = 0;
  for (int i = 1; i <= 50; ++i) taken += queue.add(request(i, 1000 + i), kQueueRun) ? 1 : 0;
  EXPECT_GT(taken, 0);
  EXPECT_LT(taken, 50);
  for (int i = 1; i <= taken; ++i) ASSERT_EQ(queue.take(5000)->sequence, i);
  EXPECT_EQ(queue.take(5000), nullptr);
}

}  // namespace
}  // namespace twinbus
