#include "control/balance/com_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinbus {
namespace {

constexpr double kComDt = 0.002;
const Eigen::Vector3d kHome(0.01, 0.0, 0.75);

ComMotion at_home() {
  ComMotion motion;
  motion.start(kHome, kHome, Eigen::Vector3d::Zero(), 0.01);
  for (int i = 0; i < 20; ++i) motion.advance(kComDt);
  return motion;
}

// Position, velocity and acceleration belong together.
void expect_smooth(ComMotion& motion, int ticks) {
  for (int i = 0; i < ticks; ++i) {
    const Eigen::Vector3d p = motion.position(), v = motion.velocity();
    motion.advance(kComDt);
    ASSERT_NEAR(((motion.position() - p) / kComDt - 0.5 * (v + motion.velocity())).norm(), 0.0, 4e-3)
        << i;
    ASSERT_NEAR(((motion.velocity() - v) / kComDt - motion.acceleration()).norm(), 0.0, 0.15) << i;
  }
}

TEST(ComMotion, TheWayHomeBeginsWhereAndAsFastAsTheRobotIs) {
  ComMotion motion;
  const Eigen::Vector3d p(0.05, -0.02, 0.70), v(0.1, 0.0, -0.05);
  motion.start(kHome, p, v, 1.0);
  EXPECT_EQ(motion.position(), p);
  EXPECT_EQ(motion.velocity(), v);
  expect_smooth(motion, 550);
  EXPECT_NEAR((motion.position() - kHome).norm(), 0.0, 1e-12);
  EXPECT_TRUE(motion.resting());
}

TEST(ComMotion, SwayReachesItsAmplitudeOnBothSidesAndOnlyThere) {
  ComMotion motion = at_home();
  motion.request(Motion::kSway, 0.03, 0.4);
  expect_smooth(motion, 1500);
  double low = 0.0, high = 0.0;
  for (int i = 0; i < 2500; ++i) {
    motion.advance(kComDt);
    low = std::min(low, motion.position().y());
    high = std::max(high, motion.position().y());
    ASSERT_NEAR(motion.position().x(), kHome.x(), 1e-12);
  }
  EXPECT_NEAR(high, 0.03, 1e-4);
  EXPECT_NEAR(low, -0.03, 1e-4);
}

TEST(ComMotion, ASquatNeverRisesAboveHome) {
  ComMotion motion = at_home();
  motion.request(Motion::kSquat, 0.05, 0.3);
  double low = 1.0, high = 0.0;
  for (int i = 0; i < 5000; ++i) {
    motion.advance(kComDt);
    const double height = motion.position().z();
    low = std::min(low, height);
    high = std::max(high, height);
  }
  EXPECT_LE(high, kHome.z() + 1e-12);
  EXPECT_NEAR(low, kHome.z() - 0.10, 1e-3);
}

TEST(ComMotion, AnyRequestInMidMotionIsFollowedWithoutAStep) {
  ComMotion motion = at_home();
  motion.request(Motion::kSway, 0.04, 0.5);
  expect_smooth(motion, 900);
  motion.request(Motion::kSquat, 0.04, 0.5);
  expect_smooth(motion, 1500);
  EXPECT_EQ(motion.motion(), Motion::kSquat);
  motion.stop(0.4);
  expect_smooth(motion, 400);
  EXPECT_TRUE(motion.resting());
}

TEST(ComMotion, WhatIsAskedTooMuchIsCutAndNonsenseIsIgnored) {
  ComMotion motion = at_home();
  motion.request(Motion::kSway, 10.0, 1e6);
  double most = 0.0;
  for (int i = 0; i < 3000; ++i) {
    motion.advance(kComDt);
    most = std::max(most, motion.acceleration().norm());
  }
  EXPECT_LT(most, 2.5);
  motion.request(Motion::kSquat, std::numeric_limits<double>::quiet_NaN(), 0.3);
  EXPECT_EQ(motion.motion(), Motion::kSway);
  motion.advance(kComDt);
  EXPECT_TRUE(motion.position().allFinite());
}

TEST(ComMotion, ALeanComesAndGoesSmoothly) {
  ComMotion motion = at_home();
  motion.lean({0.04, 0.0, -0.05});
  double most = 0.0, jump = 0.0, last = 0.0;
  for (int i = 0; i < 1500; ++i) {
    motion.advance(kComDt);
    const double now = motion.acceleration().norm();
    most = std::max(most, now);
    jump = std::max(jump, std::abs(now - last));
    last = now;
  }
  EXPECT_LT(most, 0.35) << "[m/s^2]";
  EXPECT_LT(jump, 0.02) << "from one tick to the next [m/s^2]";
  EXPECT_NEAR((motion.position() - kHome - Eigen::Vector3d(0.04, 0.0, -0.05)).norm(), 0.0, 1e-4);
  motion.lean(Eigen::Vector3d::Zero());
  for (int i = 0; i < 1500; ++i) motion.advance(kComDt);
  EXPECT_NEAR((motion.position() - kHome).norm(), 0.0, 1e-4);
}

}  // namespace
}  // namespace twinbus
