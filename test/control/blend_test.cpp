#include "control/loop/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace twinbus {
namespace {

constexpr double kBlendDt = 0.002;

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
  blend.start(last, fresh, 0, 0.5);
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
  blend.start(point(0.5, 0.2, 30.0, 100.0), fresh, 0, 0.5);
  SetPoint p;
  for (int i = 0; i < 251; ++i) {
    p = fresh;
    blend.apply(p, kBlendDt);
  }
  EXPECT_FALSE(blend.active());
  EXPECT_EQ(p.q, fresh.q);
  EXPECT_EQ(p.qd, fresh.qd);
  EXPECT_EQ(p.tau, fresh.tau);
}

TEST(Blend, VelocityIsTheDerivativeOfPosition) {
  Blend blend(1);
  const SetPoint fresh = point(0.0, 0.0, 0.0, 0.0);
  blend.start(point(0.4, -0.7, 0.0, 0.0), fresh, 0, 0.5);
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
  blend.start(a, b, 0, 0.5);
  SetPoint out;
  for (int i = 0; i < 100; ++i) {
    out = b;
    blend.apply(out, kBlendDt);
  }
  const SetPoint last = out;
  blend.start(last, a, 0, 0.5);
  out = a;
  blend.apply(out, kBlendDt);
  EXPECT_NEAR(out.q[0], last.q[0] + kBlendDt * last.qd[0], 1e-4);
  EXPECT_NEAR(out.qd[0], last.qd[0], 0.05);
  EXPECT_NEAR(out.tau[0], last.tau[0], 0.05);
}

TEST(Blend, TheSpeedOfWhatIsMeasuredIsNotCarriedOn) {
  Blend blend(2);
  SetPoint last, fresh;
  last.qd = {0.3, 0.3};
  blend.start(last, fresh, 1, 0.5);
  double measured = 0.0, wanted = 0.0;
  for (int i = 0; i < 250; ++i) {
    SetPoint p;
    blend.apply(p, kBlendDt);
    measured = std::max(measured, std::abs(p.q[0]));
    wanted = std::max(wanted, std::abs(p.q[1]));
  }
  EXPECT_EQ(measured, 0.0);
  EXPECT_GT(wanted, 0.02);
}

TEST(Blend, TheTorqueOfATickIsNotKeptWhereSetPointsAreWhatIsMeasured) {
  Blend blend(2);
  SetPoint last, fresh;
  last.tau = {20.0, 20.0};
  blend.start(last, fresh, 1, 0.5);
  SetPoint p;
  blend.apply(p, 1e-6);  // yet it does not jump
  EXPECT_NEAR(p.tau[0], 20.0, 1e-3);
  double kept[2] = {};  // impulse [N m s]
  for (int i = 0; i < 250; ++i) {
    p = fresh;
    blend.apply(p, kBlendDt);
    for (std::size_t j = 0; j < 2; ++j) kept[j] += kBlendDt * p.tau[j];
  }
  EXPECT_LT(kept[0], 0.15 * kept[1]);
}

TEST(Blend, CancelledChangesNothing) {
  Blend blend(1);
  blend.start(point(1.0, 1.0, 1.0, 1.0), point(0.0, 0.0, 0.0, 0.0), 0, 0.5);
  blend.cancel();
  SetPoint p = point(0.2, 0.0, 0.0, 0.0);
  blend.apply(p, kBlendDt);
  EXPECT_EQ(p.q[0], 0.2);
}

}  // namespace
}  // namespace twinbus
