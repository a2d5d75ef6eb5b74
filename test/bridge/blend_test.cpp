#include "bridge/gate/blend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

constexpr double kDt = 1e-4;  // fine, so that a jump cannot hide in a step
constexpr double kDuration = 0.3;

JointCommand client_at(double t) {
  JointCommand c;
  c.q[0] = 0.2 * std::sin(3.0 * t);
  c.qd[0] = static_cast<float>(0.6 * std::cos(3.0 * t));
  c.tau[0] = 5.0F;
  c.kp[0] = 100.0F;
  c.kd[0] = 10.0F;
  return c;
}

JointCommand own_set_point() {
  JointCommand own;
  own.q[0] = 0.5;
  own.qd[0] = -0.4F;
  own.tau[0] = -20.0F;
  own.kp[0] = 300.0F;
  own.kd[0] = 30.0F;
  return own;
}

TEST(OffsetBlend, StartsFromTheOwnSetPointInPositionVelocityTorqueAndGains) {
  OffsetBlend blend;
  const JointCommand own = own_set_point();
  blend.start(own, client_at(0.0), 1, 0.0, kDuration);
  JointCommand c = client_at(kDt);
  blend.advance_and_apply(kDt, 1, c);
  EXPECT_NEAR(c.q[0], own.q[0] + static_cast<double>(own.qd[0]) * kDt, 1e-6);
  EXPECT_NEAR(c.qd[0], own.qd[0], 0.01);
  EXPECT_NEAR(c.tau[0], own.tau[0], 0.01);
  EXPECT_NEAR(c.kp[0], own.kp[0], 0.01);
  EXPECT_NEAR(c.kd[0], own.kd[0], 0.01);
}

TEST(OffsetBlend, PositionAndVelocityNeverJumpAndAgreeWithEachOther) {
  OffsetBlend blend;
  JointCommand last = own_set_point();
  blend.start(last, client_at(0.0), 1, 0.0, kDuration);
  for (int i = 1; i < 4000; ++i) {
    JointCommand c = client_at(i * kDt);
    blend.advance_and_apply(kDt, 1, c);
    ASSERT_NEAR((c.q[0] - last.q[0]) / kDt, 0.5 * static_cast<double>(c.qd[0] + last.qd[0]), 2e-3)
        << i;
    ASSERT_LT(std::abs(c.qd[0] - last.qd[0]), 0.02) << i;
    last = c;
  }
}

TEST(OffsetBlend, EndsAtTheClientExactly) {
  OffsetBlend blend;
  blend.start(own_set_point(), client_at(0.0), 1, 0.0, kDuration);
  const JointCommand client = client_at(kDuration);
  JointCommand c = client;
  blend.advance_and_apply(kDuration + kDt, 1, c);
  EXPECT_EQ(c.q[0], client.q[0]);
  EXPECT_EQ(c.qd[0], client.qd[0]);
  EXPECT_EQ(c.tau[0], client.tau[0]);
  EXPECT_EQ(blend.active, 0);
}

TEST(OffsetBlend, MayStartAgainInTheMiddleOfAFadeWithoutAJump) {
  for (const int again : {1, 500, 1500, 2999}) {
    OffsetBlend blend;
    JointCommand last = own_set_point();
    blend.start(last, client_at(0.0), 1, 0.0, kDuration);
    for (int i = 1; i < again + 3500; ++i) {
      JointCommand c = client_at(i * kDt);
      if (i == again) {  // another client, somewhere else
        c.q[0] += 0.3;
        blend.start(last, c, 1, kDt, kDuration);
      } else if (i > again) {
        c.q[0] += 0.3;
      }
      blend.advance_and_apply(kDt, 1, c);
      ASSERT_LT(std::abs(c.q[0] - last.q[0]), 5.0 * kDt) << again << " " << i;
      ASSERT_LT(std::abs(c.qd[0] - last.qd[0]), 0.05) << again << " " << i;
      ASSERT_LT(std::abs(c.tau[0] - last.tau[0]), 0.1F) << again << " " << i;
      last = c;
    }
    EXPECT_EQ(blend.active, 0);
  }
}

TEST(OffsetBlend, TorqueMayFadeSoonerThanTheRest) {
  OffsetBlend blend;
  const JointCommand own = own_set_point();
  blend.start(own, client_at(0.0), 1, 0.0, kDuration, 0.04);
  float before = own.tau[0];
  double q = 0.0;
  for (int i = 1; i <= 400; ++i) {
    JointCommand c = client_at(i * kDt);
    blend.advance_and_apply(kDt, 1, c);
    ASSERT_LT(std::abs(c.tau[0] - before), 0.2F) << i;
    before = c.tau[0];
    q = c.q[0] - client_at(i * kDt).q[0];
  }
  EXPECT_NEAR(before, client_at(0.04).tau[0], 1e-3);
  EXPECT_GT(q, 0.3);  // positions have just begun
}

TEST(OffsetBlend, TakesTheClientAtOnceWithoutADuration) {
  OffsetBlend blend;
  blend.start(own_set_point(), client_at(0.0), 1, 0.0, 0.0);
  JointCommand c = client_at(0.0);
  blend.advance_and_apply(kDt, 1, c);
  EXPECT_EQ(c.q[0], client_at(0.0).q[0]);
}

TEST(OffsetBlend, LeavesJointsOutsideTheMaskAlone) {
  OffsetBlend blend;
  JointCommand own = own_set_point();
  own.q[1] = 1.0;
  blend.start(own, client_at(0.0), 1, 0.0, kDuration);
  JointCommand c = client_at(kDt);
  NoAlloc no_alloc;
  blend.advance_and_apply(kDt, 2, c);
  EXPECT_EQ(no_alloc.count(), 0);
  EXPECT_EQ(c.q[1], 0.0);
}

}  // namespace
}  // namespace twinbus
