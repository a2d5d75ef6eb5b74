#include "control/loop/set_point_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/kinematics/brake.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr double kLimitsDt = 0.002;

struct LimitsRig {
  RobotState state;
  const Model& model = test::hrp1s();
  SetPointLimits limits{model};
  SetPoint last, point;
  const Joint& joint(std::size_t k) const {
    return model.joints[static_cast<std::size_t>(model.bus_joints[k])];
  }
};

TEST(SetPointLimits, WhatIsWithinTheLimitsIsLeftAlone) {
  LimitsRig f;
  f.point.q[0] = 0.0005;
  f.point.tau[0] = 5.0;
  f.point.kp[0] = 100.0;
  const SetPoint asked = f.point;
  f.limits.apply(f.state, &f.last, kLimitsDt, f.point);
  EXPECT_EQ(f.point.q[0], asked.q[0]);
  EXPECT_EQ(f.point.tau, asked.tau);
  EXPECT_EQ(f.point.kp, asked.kp);
}

TEST(SetPointLimits, EverythingTooLargeIsCut) {
  LimitsRig f;
  for (std::size_t k = 0; k < 29; ++k) {
    f.point.q[k] = 1e9;
    f.point.qd[k] = -1e9;
    f.point.tau[k] = 1e9;
    f.point.kp[k] = -5.0;
  }
  f.limits.apply(f.state, nullptr, kLimitsDt, f.point);
  for (std::size_t k = 0; k < 29; ++k) {
    EXPECT_DOUBLE_EQ(f.point.q[k], f.joint(k).upper);
    EXPECT_DOUBLE_EQ(f.point.qd[k], -f.joint(k).velocity);
    EXPECT_DOUBLE_EQ(f.point.tau[k], f.joint(k).effort);
    EXPECT_EQ(f.point.kp[k], 0.0);
  }
}

TEST(SetPointLimits, NoSetPointMovesFasterThanItsJoint) {
  LimitsRig f;
  f.point.q[0] = 0.2;
  f.limits.apply(f.state, &f.last, kLimitsDt, f.point);
  EXPECT_GT(f.point.q[0], 0.0);
  EXPECT_LE(f.point.q[0], f.joint(0).velocity * kLimitsDt + 1e-15);
}

TEST(SetPointLimits, NoTorqueChangesFasterThanTheGateAllows) {
  LimitsRig f;
  f.last.tau[3] = 10.0;
  f.point.tau[3] = -f.joint(3).effort;
  f.limits.apply(f.state, &f.last, kLimitsDt, f.point);
  EXPECT_DOUBLE_EQ(f.point.tau[3], 10.0 - kTorqueStep * f.joint(3).effort);
}

TEST(SetPointLimits, ANumberThatIsNoneLeavesTheJointWhereItWas) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int field = 0; field < 5; ++field) {
      LimitsRig f;
      f.last.q[3] = 0.1;
      f.point = f.last;
      PerJoint<double>* fields[] = {&f.point.q, &f.point.qd, &f.point.tau, &f.point.kp,
                                    &f.point.kd};
      (*fields[field])[3] = bad;
      f.limits.apply(f.state, &f.last, kLimitsDt, f.point);
      EXPECT_NEAR(f.point.q[3], 0.1, f.joint(3).velocity * kLimitsDt);
      EXPECT_EQ(f.point.qd[3], 0.0);
      EXPECT_EQ(f.point.tau[3], 0.0);
      EXPECT_EQ(f.point.kp[3], f.joint(3).kp);
      EXPECT_EQ(f.point.kd[3], f.joint(3).kd);
    }
  }
}

}  // namespace
}  // namespace twinbus
