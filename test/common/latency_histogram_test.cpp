#include "common/time/latency_histogram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

TEST(RateStats, PercentilesAreThoseOfTheSortedValues) {
  std::mt19937_64 random(4);
  std::lognormal_distribution<double> draw(10.0, 2.0);
  RateStats stats;
  std::vector<std::int64_t> values;
  for (int i = 0; i < 20000; ++i) {
    values.push_back(static_cast<std::int64_t>(draw(random)));
    stats.add(values.back());
  }
  std::sort(values.begin(), values.end());
  for (const double share : {0.01, 0.5, 0.9, 0.99, 0.999}) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * 20000)) - 1;
    const auto exact = static_cast<double>(values[rank]);
    EXPECT_NEAR(stats.percentile_ns(share), exact, 0.04 * exact + 1.0) << share;
  }
  EXPECT_EQ(stats.max_ns(), values.back());
  EXPECT_EQ(stats.min_ns(), values.front());
  EXPECT_EQ(stats.count(), 20000);
}

TEST(RateStats, SmallValuesAreExact) {
  RateStats stats;
  for (int i = 0; i < 32; ++i) stats.add(i);
  EXPECT_EQ(stats.percentile_ns(0.5), 15.0);
  EXPECT_EQ(stats.percentile_ns(1.0), 31.0);
}

TEST(RateStats, EmptyAndExtremeValues) {
  RateStats stats;
  EXPECT_EQ(stats.median_ns(), 0.0);
  EXPECT_EQ(stats.min_ns(), 0);
  stats.add(-5);
  EXPECT_EQ(stats.median_ns(), 0.0);
  stats.add(INT64_MAX);
  EXPECT_EQ(stats.max_ns(), INT64_MAX);
  EXPECT_GT(stats.percentile_ns(1.0), 1e12);
}

TEST(RateStats, MergeIsBothTogether) {
  RateStats a, b, both;
  for (int i = 1; i < 1000; ++i) {
    (i % 2 == 0 ? a : b).add(i * 100);
    both.add(i * 100);
  }
  a.merge(b);
  EXPECT_EQ(a.p99_ns(), both.p99_ns());
  EXPECT_EQ(a.count(), both.count());
}

TEST(RateStats, DoesNotAllocate) {
  RateStats stats;
  NoAlloc no_alloc;
  stats.add(123456);
  EXPECT_GT(stats.p999_ns(), 0.0);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus
