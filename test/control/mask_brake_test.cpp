#include "control/loop/mask_brake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/kinematics/brake.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr double kBrakeDt = 0.002;
constexpr std::size_t kBraked = 6;  // of an arm

double asked(int tick) { return 0.4 * kBrakeDt * tick; }

struct BrakeRig {
  MaskBrake brake{test::hrp1s()};
  SetPoint point;
  // The set-point that is asked runs on at 0.4 rad/s.
  void tick(int n, bool masked) {
    point = {};
    point.q[kBraked] = asked(n);
    point.qd[kBraked] = 0.4;
    brake.apply(point, masked ? std::int64_t{1} << kBraked : 0, kBrakeDt);
  }
};

TEST(MaskBrake, WithoutAMaskNothingChanges) {
  BrakeRig f;
  f.tick(10, false);
  EXPECT_EQ(f.point.q[kBraked], asked(10));
  EXPECT_EQ(f.point.qd[kBraked], 0.4);
}

TEST(MaskBrake, AMaskedJointComesToRestAsFastAsItBrakes) {
  BrakeRig f;
  for (int n = 0; n < 10; ++n) f.tick(n, false);
  const double begin = f.point.q[kBraked];
  for (int n = 10; n < 200; ++n) f.tick(n, true);
  EXPECT_EQ(f.point.qd[kBraked], 0.0);
  const Joint& joint =
      test::hrp1s().joints[static_cast<std::size_t>(test::hrp1s().bus_joints[kBraked])];
  EXPECT_LE(f.point.q[kBraked] - begin,
            0.5 * 0.4 * 0.4 / brake_deceleration(joint) + 2.0 * 0.4 * kBrakeDt);
}

// The guard looks ahead by this law, and the gate brakes by it: a joint must not stop anywhere else.
TEST(MaskBrake, AMaskedJointStopsWhereTheGuardPredictsAndTheGateWouldStopIt) {
  BrakeRig f;
  for (int n = 0; n < 10; ++n) f.tick(n, false);
  const Joint& joint =
      test::hrp1s().joints[static_cast<std::size_t>(test::hrp1s().bus_joints[kBraked])];
  double q = asked(9) + 0.4 * kBrakeDt, v = 0.4;
  for (int n = 10; n < 200; ++n) {
    f.tick(n, true);
    brake_step(brake_deceleration(joint), kBrakeDt, q, v);
    ASSERT_NEAR(f.point.q[kBraked], q, 1e-12) << n;
  }
  // No more than rounding a way to rest into ticks costs.
  EXPECT_NEAR(q - asked(10), 0.5 * 0.4 * 0.4 / brake_deceleration(joint), 5e-5);
}

TEST(MaskBrake, ReturnsInTheTimeInWhichGateAndGuardFade) {
  BrakeRig f;
  int n = 0;
  for (; n < 100; ++n) f.tick(n, true);
  const int end = n + static_cast<int>(test::hrp1s().blend_s / kBrakeDt) + 2;
  for (; n < end; ++n) f.tick(n, false);
  EXPECT_NEAR(f.point.q[kBraked], asked(end - 1), 1e-12);
}

TEST(MaskBrake, OtherJointsGoOn) {
  BrakeRig f;
  f.point.q[0] = 0.3;
  f.brake.apply(f.point, std::int64_t{1} << kBraked, kBrakeDt);
  EXPECT_EQ(f.point.q[0], 0.3);
}

TEST(MaskBrake, LetGoItReturnsWithoutAStepAndEndsOnWhatIsAsked) {
  BrakeRig f;
  for (int n = 0; n < 10; ++n) f.tick(n, false);
  for (int n = 10; n < 100; ++n) f.tick(n, true);
  double last = f.point.q[kBraked], last_speed = f.point.qd[kBraked];
  for (int n = 100; n < 400; ++n) {
    f.tick(n, false);
    ASSERT_LT(std::abs(f.point.q[kBraked] - last), 3.0 * kBrakeDt);
    ASSERT_LT(std::abs(f.point.qd[kBraked] - last_speed), 0.1) << n;
    last = f.point.q[kBraked];
    last_speed = f.point.qd[kBraked];
  }
  EXPECT_NEAR(f.point.q[kBraked], asked(399), 1e-12);
}

TEST(MaskBrake, ResetForgetsTheMask) {
  BrakeRig f;
  for (int n = 0; n < 50; ++n) f.tick(n, true);
  f.brake.reset();
  f.tick(200, false);
  EXPECT_EQ(f.point.q[kBraked], asked(200));
}

}  // namespace
}  // namespace twinbus
