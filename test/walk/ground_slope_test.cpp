#include "control/walk/ground_slope.h"

#include <gtest/gtest.h>

#include <random>

namespace twinbus {
namespace {

using Eigen::Vector2d;

TEST(GroundSlope, ARampIsBelievedAfterAFewStepsAndLevelGroundAgainAfterIt) {
  const Vector2d ramp(0.0875, 0.03);
  GroundSlope slope;
  for (int i = 0; i < 4; ++i) slope.stood_on(ramp);
  EXPECT_LT((slope.gradient() - ramp).norm(), 0.1 * ramp.norm());
  for (int i = 0; i < 20; ++i) slope.stood_on(ramp);
  EXPECT_LT((slope.gradient() - ramp).norm(), 1e-6);
  for (int i = 0; i < 4; ++i) slope.stood_on(Vector2d::Zero());
  EXPECT_LT(slope.gradient().norm(), 0.1 * ramp.norm());
  for (int i = 0; i < 20; ++i) slope.stood_on(Vector2d::Zero());
  EXPECT_EQ(slope.gradient(), Vector2d(Vector2d::Zero()));
}

// A gyro's bias of a degree is no ramp.
TEST(GroundSlope, AlmostLevelGroundIsLevel) {
  GroundSlope slope;
  for (int i = 0; i < 100; ++i) {
    slope.stood_on({0.017, -0.01});
    ASSERT_EQ(slope.gradient(), Vector2d(Vector2d::Zero())) << i;
  }
}

// Tiles of walk_rough: +- 3 degrees.  By chance a few in a row tilt alike; what is then believed is small.
TEST(GroundSlope, TilesThatTiltAtRandomAreHardlyEverASlope) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> tilt(-0.052, 0.052);
  GroundSlope slope;
  int believed = 0;
  constexpr int kSteps = 20000;
  for (int i = 0; i < kSteps; ++i) {
    slope.stood_on({tilt(random), tilt(random)});
    believed += slope.gradient().norm() > 0.0 ? 1 : 0;
    ASSERT_LT(slope.gradient().norm(), 0.075);
  }
  EXPECT_LT(believed, kSteps / 50);
}

TEST(GroundSlope, AWallIsNoGroundToWalkOn) {
  GroundSlope slope;
  for (int i = 0; i < 50; ++i) slope.stood_on({3.0, 4.0});
  EXPECT_LE(slope.gradient().norm(), 0.25 + 1e-12);
}

}  // namespace
}  // namespace twinbus
