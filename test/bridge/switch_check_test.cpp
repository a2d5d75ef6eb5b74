#include "bridge/handover/switch_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace twinbus {
namespace {

RobotState standing() {
  RobotState s;
  s.joint_count = 2;
  s.sensor_flags = kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
  for (const std::size_t foot : {std::size_t{kLeftFoot}, std::size_t{kRightFoot}}) {
    s.wrench_kind[foot] = WrenchKind::kMeasured;
    s.wrench[foot][2] = 640.0F;
  }
  return s;
}

RobotState tilted(double roll, double pitch) {
  RobotState s = standing();
  s.attitude = {static_cast<float>(std::cos(roll / 2) * std::cos(pitch / 2)),
                static_cast<float>(std::sin(roll / 2) * std::cos(pitch / 2)),
                static_cast<float>(std::cos(roll / 2) * std::sin(pitch / 2)),
                static_cast<float>(-std::sin(roll / 2) * std::sin(pitch / 2))};
  return s;
}

TEST(SwitchCheck, EqualRobotsMayTakeEachOthersPlace) {
  EXPECT_EQ(compare_measured(standing(), standing()), Refusal::kNone);
}

TEST(SwitchCheck, EachDifferenceHasItsOwnRefusalAndItsOwnLimit) {
  RobotState s = standing();
  s.q[1] = 0.049;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kNone);
  s.q[1] = -0.051;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kPosture);
  s = standing();
  s.qd[0] = 0.49F;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kNone);
  s.qd[0] = 0.51F;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kVelocity);
  EXPECT_EQ(compare_measured(standing(), tilted(0.049, -0.049)), Refusal::kNone);
  EXPECT_EQ(compare_measured(standing(), tilted(0.051, 0.0)), Refusal::kAttitude);
  EXPECT_EQ(compare_measured(standing(), tilted(0.0, -0.051)), Refusal::kAttitude);
  s = standing();
  s.gyro[2] = 0.31F;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kGyro);
  s = standing();
  s.wrench[kLeftFoot][2] = 0.0F;
  s.wrench[kRightFoot][2] = 1280.0F;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kFeet);
  s = standing();
  s.wrench[kLeftFoot][2] = 900.0F;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kLoad);
  // A third foot, that one of the two does not stand on; where no sensor says so, it is not compared.
  s = standing();
  RobotState t = standing();
  for (RobotState* each : {&s, &t}) {
    each->wrench_kind[2] = WrenchKind::kMeasured;
    each->sensor_flags |= wrench_valid(static_cast<Limb>(2));
  }
  s.wrench[2][2] = 640.0F;
  EXPECT_EQ(compare_measured(t, s), Refusal::kFeet);
  s.wrench_kind[2] = WrenchKind::kEstimated;
  EXPECT_EQ(compare_measured(t, s), Refusal::kNone);
}

TEST(SwitchCheck, HeadingIsNobodysBusiness) {
  RobotState s = standing();
  s.attitude = {static_cast<float>(std::cos(0.8)), 0.0F, 0.0F, static_cast<float>(std::sin(0.8))};
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kNone);
}

TEST(SwitchCheck, ANumberThatIsNotFiniteIsNeverClose) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    RobotState s = standing();
    s.q[0] = bad;
    EXPECT_EQ(compare_measured(standing(), s), Refusal::kPosture);
    EXPECT_EQ(compare_measured(s, standing()), Refusal::kPosture);
    s = standing();
    s.qd[0] = static_cast<float>(bad);
    EXPECT_EQ(compare_measured(standing(), s), Refusal::kVelocity);
    s = standing();
    s.attitude[0] = static_cast<float>(std::nan(""));
    s.attitude[1] = static_cast<float>(std::nan(""));
    EXPECT_EQ(compare_measured(standing(), s), Refusal::kAttitude);
    s = standing();
    s.gyro[0] = static_cast<float>(bad);
    EXPECT_EQ(compare_measured(standing(), s), Refusal::kGyro);
    s = standing();
    s.wrench[kLeftFoot][2] = static_cast<float>(bad);
    EXPECT_EQ(compare_measured(standing(), s), Refusal::kFeet);
  }
}

TEST(SwitchCheck, ASensorThatEitherLacksIsLeftOut) {
  RobotState s = tilted(0.4, 0.0);
  s.sensor_flags &= ~kImuValid;
  s.wrench_kind = {};
  s.wrench[kLeftFoot][2] = 0.0F;
  EXPECT_EQ(compare_measured(standing(), s), Refusal::kNone);
}

}  // namespace
}  // namespace twinbus
