#include "lcmtypes/node/pulse.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(Pulse, SaysWhoItIsAndThatNothingRunsYet) {
  Pulse pulse(ProcessKind::kGuard, 42);
  const Heartbeat& beat = pulse.beat(1000 * kMs);
  EXPECT_EQ(beat.process_id, 42);
  EXPECT_EQ(beat.kind, ProcessKind::kGuard);
  EXPECT_EQ(beat.state, 1);
  EXPECT_EQ(beat.ticks, 0);
}

TEST(Pulse, CountsTicksAndMeasuresTheirRateAndTimes) {
  Pulse pulse(ProcessKind::kController, 1);
  const std::int64_t start = 1000 * kMs;
  pulse.beat(start);  // the window of the rate begins here
  for (int n = 1; n <= 300; ++n) {
    pulse.tick(start + 2 * kMs * n, 40'000);
    pulse.answered(250'000);
  }
  const std::int64_t end = start + 600 * kMs;
  const Heartbeat& beat = pulse.beat(end);
  EXPECT_EQ(beat.ticks, 300);
  EXPECT_NEAR(beat.rate, 500.0F, 1e-3F);
  EXPECT_NEAR(beat.tick_median_us, 40.0F, 2.0F);
  EXPECT_NEAR(beat.age_p99_us, 250.0F, 10.0F);
  EXPECT_EQ(beat.state, 2);
  EXPECT_FALSE(pulse.due(end + Pulse::kEvery - 1));
  EXPECT_TRUE(pulse.due(end + Pulse::kEvery));
  EXPECT_EQ(pulse.beat(end + Pulse::kWindow).state, 1) << "silent for half a second";
}

}  // namespace
}  // namespace twinbus
