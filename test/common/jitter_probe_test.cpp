#include "common/time/jitter_probe.h"

#include <gtest/gtest.h>

#include <array>

#include "lcmtypes/node/missed_ticks.h"

namespace twinbus {
namespace {

constexpr std::int64_t kPeriod = 2'000'000;

TEST(CoveredTime, CountsWhatOverlapsOnce) {
  std::array<Interval, 4> intervals{{{50, 60}, {10, 30}, {20, 40}, {0, 5}}};
  EXPECT_EQ(covered_ns(intervals, 0, 100), 5 + 30 + 10);
  EXPECT_EQ(covered_ns(intervals, 15, 55), 25 + 5);
  EXPECT_EQ(covered_ns(intervals, 41, 49), 0);
  EXPECT_EQ(covered_ns({}, 0, 100), 0);
}

// The system refuses priority 0, as it refuses any to a user without the right: an ordinary timer
// proves nothing, so there is no probe, and every missed tick is the loop's own.
constexpr int kRefused = 0;

TEST(JitterProbe, IsNotThereWhereFifoPriorityIsRefused) {
  const JitterProbe probe(kPeriod, kRefused);
  EXPECT_FALSE(probe.running());
  EXPECT_EQ(probe.missed(), 0);
  EXPECT_EQ(probe.stood_still_ns(0, INT64_MAX), 0);
}

TEST(MissedTicks, AreTheLoopsOwnWhereThereIsNoProbe) {
  MissedTicks missed;
  Heartbeat beat;
  missed.add(2, 500'000, 0, kPeriod);
  missed.tell(beat);
  EXPECT_EQ(beat.ticks_missed, 2);
  EXPECT_EQ(beat.ticks_stalled, 0);
  EXPECT_EQ(beat.timer_missed, -1);
  missed.watch(kPeriod, kRefused);
  missed.add(1, 500'000, 0, kPeriod);
  missed.tell(beat);
  EXPECT_EQ(beat.ticks_missed, 3);
  EXPECT_EQ(beat.ticks_stalled, 0);
  EXPECT_EQ(beat.timer_missed, -1);
}

}  // namespace
}  // namespace twinbus
