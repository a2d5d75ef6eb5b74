#include "launcher/bus/meter.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

constexpr std::int64_t kPeriod = 2'000'000;

TEST(Meter, CountsRateOfASteadyStream) {
  Meter meter;
  for (int tick = 0; tick < 1000; ++tick) meter.add(tick, tick * kPeriod);
  EXPECT_NEAR(meter.mean_rate(), 500.0, 1e-6);
  EXPECT_NEAR(meter.rate(1000 * kPeriod), 500.0, 5.0);
  EXPECT_EQ(meter.lost(), 0);
}

TEST(Meter, CountsGapsAndRepetitions) {
  Meter meter;
  meter.add(5, 0);
  meter.add(9, 1);
  meter.add(9, 2);
  meter.add(7, 3);
  EXPECT_EQ(meter.lost(), 3);
  EXPECT_EQ(meter.repeated(), 2);
  EXPECT_EQ(meter.received(), 2);
}

TEST(Meter, ASilentStreamHasNoRateAndGrowsOld) {
  Meter meter;
  EXPECT_GT(meter.age(0), 1e8);
  for (int tick = 0; tick < 1000; ++tick) meter.add(tick, tick * kPeriod);
  const std::int64_t later = 999 * kPeriod + 3'000'000'000;
  EXPECT_DOUBLE_EQ(meter.rate(later), 0.0);
  EXPECT_NEAR(meter.age(later), 3.0, 1e-9);
}

}  // namespace
}  // namespace twinbus
