#include "control/blend.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twinbus {
namespace {

constexpr double kDt = 0.002;

SetPoint point(double q, double qd, double tau, double kp) {
  SetPoint p;
  p.q[0] = q;
  p.qd[0] = qd;
  p.tau[0] = tau;
  p.kp[0] = kp;
  p.kd[0] = 0.1 * kp;
  return p;
}

TEST(Blend, BeginsAtTheOldSetPointAndItsVelocity) {
  Blend blend(1);
  const SetPoint last = point(0.5, 0.2, 30.0, 100.0), fresh = point(-0.1, 0.0, -10.0, 500.0);
  blend.start(last, fresh, 0.5);
  SetPoint p = fresh;
  blend.apply(p, 1e-6);
  EXPECT_NEAR(p.q[0], 0.5, 1e-6);
  EXPECT_NEAR(p.qd[0], 0.2, 1e-6);
  EXPECT_NEAR(p.tau[0], 30.0, 1e-6);
  EXPECT_NEAR(p.kp[0], 100.0, 1e-6);
  EXPECT_NEAR(p.kd[0], 10.0, 1e-6);
}

TEST(Blend, EndsAtTheNewSetPointAndLeavesItAlone) {
  Blend blend(1);
  const SetPoint fresh = point(-0.1, 0.3, -10.0, 500.0);
  blend.start(point(0.5, 0.2, 30.0, 100.0), fresh, 0.5);
  SetPoint p;
  for (int i = 0; i < 251; ++i) {
    p = fresh;
    blend.apply(p, kDt);
  }
  EXPECT_FALSE(blend.active());
  EXPECT_EQ(p.q, fresh.q);
  EXPECT_EQ(p.qd, fresh.qd);
  EXPECT_EQ(p.tau, fresh.tau);
}

TEST(Blend, VelocityIsTheDerivativeOfPosition) {
  Blend blend(1);
  const SetPoint fresh = point(0.0, 0.0, 0.0, 0.0);
  blend.start(point(0.4, -0.7, 0.0, 0.0), fresh, 0.5);
  double last = 0.4;
  for (int i = 0; i < 2500; ++i) {
    SetPoint p = fresh;
    blend.apply(p, 2e-4);
    EXPECT_NEAR((p.q[0] - last) / 2e-4, p.qd[0], 5e-3);
    last = p.q[0];
  }
}

TEST(Blend, AChangeInMidFadeDoesNotStep) {
  Blend blend(1);
  const SetPoint a = point(0.0, 0.0, 0.0, 100.0), b = point(1.0, 0.0, 50.0, 300.0);
  blend.start(a, b, 0.5);
  SetPoint out;
  for (int i = 0; i < 100; ++i) {
    out = b;
    blend.apply(out, kDt);
  }
  const SetPoint last = out;
  blend.start(last, a, 0.5);
  out = a;
  blend.apply(out, kDt);
  EXPECT_NEAR(out.q[0], last.q[0] + kDt * last.qd[0], 1e-4);
  EXPECT_NEAR(out.qd[0], last.qd[0], 0.05);
  EXPECT_NEAR(out.tau[0], last.tau[0], 0.05);
}

TEST(Blend, CancelledChangesNothing) {
  Blend blend(1);
  blend.start(point(1.0, 1.0, 1.0, 1.0), point(0.0, 0.0, 0.0, 0.0), 0.5);
  blend.cancel();
  SetPoint p = point(0.2, 0.0, 0.0, 0.0);
  blend.apply(p, kDt);
  EXPECT_EQ(p.q[0], 0.2);
}

}  // namespace
}  // namespace twinbus
