#include "control/loop/state_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

StateCheck check() { return StateCheck(test::hrp1s()); }

RobotState good() {
  RobotState state;
  state.joint_count = static_cast<std::int16_t>(test::hrp1s().bus_count());
  state.attitude = {1.0F, 0.0F, 0.0F, 0.0F};
  return state;
}

TEST(StateCheck, ARobotAtRestIsSane) { EXPECT_TRUE(check().is_sane(good())); }

TEST(StateCheck, NaNAndTheImpossibleInAnyFieldIsNot) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e9F}) {
    RobotState s = good();
    s.q[28] = static_cast<double>(bad);
    EXPECT_FALSE(check().is_sane(s));
    for (int field = 0; field < 6; ++field) {
      s = good();
      float* const fields[] = {&s.qd[28],  &s.tau[28],  &s.attitude[3],
                               &s.gyro[2], &s.accel[0], &s.wrench[1][5]};
      *fields[field] = bad;
      EXPECT_FALSE(check().is_sane(s)) << field << " " << bad;
    }
  }
}

TEST(StateCheck, AnAttitudeThatIsNoRotationAndAnotherRobotAreNot) {
  RobotState s = good();
  s.attitude = {};
  EXPECT_FALSE(check().is_sane(s));
  s = good();
  s.joint_count = 12;
  EXPECT_FALSE(check().is_sane(s));
}

TEST(StateCheck, JointsBehindTheCountDoNotMatter) {
  RobotState s = good();
  s.q[47] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(check().is_sane(s));
}

}  // namespace
}  // namespace twinbus
