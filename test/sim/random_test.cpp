#include "common/math/random.h"

#include <gtest/gtest.h>

namespace twinbus {
namespace {

TEST(Random, IsTheSameEverywhere) {
  Random random(42);
  const std::uint64_t first = random.next();
  EXPECT_EQ(first, Random(42).next());
  EXPECT_NE(first, Random(43).next());
}

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  Random random(7);
  const int n = 200000;
  double sum = 0.0, square = 0.0, fourth = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x;
    square += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / n, 0.0, 0.01);
  EXPECT_NEAR(square / n, 1.0, 0.02);
  EXPECT_NEAR(fourth / n, 3.0, 0.1);
}

TEST(Random, UniformIsInTheHalfOpenInterval) {
  Random random(1);
  double sum = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100000, 0.5, 0.01);
}

}  // namespace
}  // namespace twinbus
