#include "common/math/splitmix64.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

// The first numbers of the reference implementation with seed 0.
TEST(PlannerRandom, IsSplitmix64) {
  SplitMix64 random(0);
  EXPECT_EQ(random.next(), 0xE220A8397B1DCDAFULL);
  EXPECT_EQ(random.next(), 0x6E789E6AA1B965F4ULL);
  EXPECT_EQ(random.next(), 0x06C45D188009454FULL);
}

TEST(PlannerRandom, UniformStaysInsideAndFillsItsRange) {
  SplitMix64 random(3);
  double sum = 0.0;
  double low = 9.0;
  double high = -9.0;
  constexpr int kDraws = 100000;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform(-1.0, 3.0);
    ASSERT_GE(x, -1.0);
    ASSERT_LT(x, 3.0);
    sum += x;
    low = std::min(low, x);
    high = std::max(high, x);
  }
  EXPECT_NEAR(sum / kDraws, 1.0, 0.02);
  EXPECT_LT(low, -0.999);
  EXPECT_GT(high, 2.999);
}

}  // namespace
}  // namespace twinbus
