#include "control/joint/min_jerk.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twinbus {
namespace {

TEST(MinJerk, ArrivesAtRestWhereItWasSent) {
  MinJerk x;
  x.rest(0.3);
  x.aim(1.0, 0.5);
  double before = 0.0;
  for (int i = 0; i < 249; ++i) {
    before = x.position();
    x.advance(0.002);
  }
  EXPECT_NEAR(x.position(), 1.0, 1e-5);
  EXPECT_NEAR(x.velocity(), 0.0, 1e-2);
  EXPECT_LE(before, x.position());
  x.advance(0.004);
  EXPECT_EQ(x.position(), 1.0);
  EXPECT_FALSE(x.moving());
}

TEST(MinJerk, ReaimedInFlightKeepsPositionVelocityAndAcceleration) {
  MinJerk x;
  x.rest(0.0);
  x.aim(1.0, 0.5);
  for (int i = 0; i < 60; ++i) x.advance(0.002);
  const double p = x.position(), v = x.velocity(), a = x.acceleration();
  x.aim(-2.0, 0.7);
  EXPECT_DOUBLE_EQ(x.position(), p);
  EXPECT_DOUBLE_EQ(x.velocity(), v);
  EXPECT_DOUBLE_EQ(x.acceleration(), a);
}

TEST(MinJerk, VelocityAndAccelerationAreDerivatives) {
  MinJerk x;
  x.aim_from(0.2, -0.4, 1.0, 0.9, 0.8);
  const double h = 1e-5;
  for (int i = 0; i < 70; ++i) {
    MinJerk later = x;
    later.advance(h);
    EXPECT_NEAR((later.position() - x.position()) / h, x.velocity(), 1e-3);
    EXPECT_NEAR((later.velocity() - x.velocity()) / h, x.acceleration(), 1e-2);
    x.advance(0.01);
  }
}

TEST(MinJerk, AZeroDurationIsAMillisecond) {
  MinJerk x;
  x.rest(0.0);
  x.aim(1.0, 0.0);
  EXPECT_TRUE(std::isfinite(x.acceleration()));
  x.advance(0.002);
  EXPECT_EQ(x.position(), 1.0);
}

}  // namespace
}  // namespace twinbus
