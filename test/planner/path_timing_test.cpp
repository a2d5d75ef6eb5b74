#include "planner/timing/path_timing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/math/splitmix64.h"
#include "test/planner/flat_world.h"

namespace twinbus {
namespace {

TimingLimits limits2(double v0, double v1, double a0, double a1) {
  TimingLimits limits;
  limits.velocity = point2(v0, v1);
  limits.acceleration = point2(a0, a1);
  limits.jerk = 10.0 * limits.acceleration;
  return limits;
}

TimedPath timed(const JointPath& corners, const TimingLimits& limits, int most_knots = 360) {
  FlatWorld world;
  return time_path(RoundedPath::parts(world, corners, 0.3), limits, 0.025, most_knots);
}

TEST(PathTiming, StartsAndEndsAtRestAtTheEndsOfThePath) {
  const JointPath corners = {point2(0.0, 0.0), point2(1.0, 0.2), point2(1.0, 1.0)};
  const TimedPath path = timed(corners, limits2(1.0, 2.0, 3.0, 2.0));
  ASSERT_GE(path.size(), 3U);
  EXPECT_DOUBLE_EQ(path.front().time, 0.0);
  EXPECT_NEAR((path.front().q - corners.front()).norm(), 0.0, 1e-9);
  EXPECT_NEAR((path.back().q - corners.back()).norm(), 0.0, 1e-9);
  EXPECT_NEAR(path.front().qd.norm(), 0.0, 1e-9);
  EXPECT_NEAR(path.back().qd.norm(), 0.0, 1e-9);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) EXPECT_LT(path[i].time, path[i + 1].time);
}

// SplitMix64 paths and limits, looked at a thousand times a second: no sample beyond a limit, and a
// motion that could be stretched by no more than the limits leave.
TEST(PathTiming, NoSampleIsBeyondALimitAndSomeSampleIsAtOne) {
  SplitMix64 random(20261121);
  for (int round = 0; round < 60; ++round) {
    JointPath corners = {point2(0.0, 0.0)};
    const int lines = 1 + static_cast<int>(random.uniform(0.0, 5.0));
    for (int i = 0; i < lines; ++i)
      corners.push_back(point2(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)));
    const TimingLimits limits = limits2(random.uniform(0.2, 6.0), random.uniform(0.2, 6.0),
                                        random.uniform(0.5, 12.0), random.uniform(0.5, 12.0));
    const TimedPath path = timed(corners, limits);
    ASSERT_GE(path.size(), 2U);
    double most = 0.0;
    JointPoint q, qd, qdd, before = JointPoint::Zero(2);
    for (double t = 0.0; t <= path.back().time; t += 0.001) {
      sample(path, t, q, qd, qdd);
      for (int k = 0; k < 2; ++k) {
        const double jerk = std::abs(qdd[k] - before[k]) / 0.001 / limits.jerk[k];
        ASSERT_LE(jerk, 1.0 + 1e-6) << "round " << round << " t " << t;
        most = std::max(most, jerk);
      }
      before = qdd;
      for (int k = 0; k < 2; ++k) {
        const double velocity = std::abs(qd[k]) / limits.velocity[k];
        const double acceleration = std::abs(qdd[k]) / limits.acceleration[k];
        ASSERT_LE(velocity, 1.0 + 1e-6) << "round " << round << " t " << t;
        ASSERT_LE(acceleration, 1.0 + 1e-6) << "round " << round << " t " << t;
        most = std::max({most, velocity, acceleration});
      }
    }
    EXPECT_GT(most, 0.98) << "round " << round;
    const LimitUse use = limit_use(path, limits);
    EXPECT_LE(use.velocity, 1.0 + 1e-6);
    EXPECT_LE(use.acceleration, 1.0 + 1e-6);
  }
}

// However short: a tenth of a second to full push and back is most of it.
TEST(PathTiming, AShortMotionTakesAShortTime) {
  for (double distance = 1e-4; distance < 0.3; distance *= 1.1) {
    const TimedPath path =
        timed({point2(0.3, 0.1), point2(0.3 + distance, 0.1)}, limits2(2.0, 2.0, 4.0, 4.0));
    EXPECT_LT(path.back().time, 2.0 * std::sqrt(distance / 4.0) + 0.4) << distance;
  }
}

// One joint over a distance: no motion can be faster than bang-bang, and a tenth of a second to
// full push, as often as the push changes, is what the limit of jerk costs.
TEST(PathTiming, IsNearlyAsFastAsTheLimitsAllow) {
  for (const double distance : {0.3, 1.0, 3.0}) {
    const double v = 2.0;
    const double a = 4.0;
    TimingLimits limits = limits2(v, v, a, a);
    const TimedPath path = timed({point2(0.0, 0.0), point2(distance, 0.0)}, limits);
    const double fastest =
        distance * a > v * v ? distance / v + v / a : 2.0 * std::sqrt(distance / a);
    EXPECT_GE(path.back().time, fastest - 1e-6);
    EXPECT_LE(path.back().time, 1.02 * fastest + 0.15) << distance;
  }
}

TEST(PathTiming, SamplesBetweenKnotsAreTheDerivativesOfEachOther) {
  const TimedPath path =
      timed({point2(0.0, 0.0), point2(1.0, 0.2), point2(1.0, 1.0)}, limits2(1.0, 2.0, 3.0, 2.0));
  JointPoint q, qd, qdd, a, b, unused, va, vb;
  constexpr double kH = 1e-6;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double t = 0.5 * (path[i].time + path[i + 1].time);
    sample(path, t, q, qd, qdd);
    sample(path, t - kH, a, va, unused);
    sample(path, t + kH, b, vb, unused);
    EXPECT_LT(((b - a) / (2.0 * kH) - qd).norm(), 1e-6);
    EXPECT_LT(((vb - va) / (2.0 * kH) - qdd).norm(), 1e-4);
  }
  sample(path, -5.0, q, qd, qdd);
  EXPECT_NEAR((q - path.front().q).norm(), 0.0, 1e-12) << "clamped before the start";
  sample(path, 1e9, q, qd, qdd);
  EXPECT_NEAR((q - path.back().q).norm(), 0.0, 1e-12) << "and behind the end";
}

TEST(PathTiming, LongPathsKeepToTheNumberOfKnots) {
  JointPath corners;
  for (int i = 0; i < 40; ++i) corners.push_back(point2(i % 2 == 0 ? -2.0 : 2.0, 0.05 * i));
  const TimedPath path = timed(corners, limits2(1.0, 1.0, 2.0, 2.0), 360);
  EXPECT_LE(path.size(), 360U);
  EXPECT_GT(path.back().time, 100.0);
}

TEST(PathTiming, NothingToDoIsAnEmptyPath) {
  EXPECT_TRUE(timed({point2(1.0, 1.0), point2(1.0, 1.0)}, limits2(1.0, 1.0, 1.0, 1.0)).empty());
}

}  // namespace
}  // namespace twinbus
