#include "viewer_log/view/gap_meter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twinbus {
namespace {

RobotState state(std::int64_t run, std::int64_t tick, Role role, double q) {
  RobotState s;
  s.run_id = run;
  s.tick = tick;
  s.role = role;
  s.model_hash = 7;
  s.joint_count = 2;
  s.q[0] = q;
  s.tau[1] = static_cast<float>(10.0 * q);
  s.wrench[0][2] = static_cast<float>(600.0 + q);
  s.attitude = {std::cos(0.5F * static_cast<float>(q)), std::sin(0.5F * static_cast<float>(q)),
                0.0F, 0.0F};
  return s;
}

TEST(GapMeter, TellsTheDifferenceAtTheSameTick) {
  GapMeter meter;
  Gap gap;
  for (std::int64_t tick = 100; tick < 110; ++tick)
    meter.on_active(state(1, tick, Role::kActive, 0.1));
  meter.on_other(state(2, 107, Role::kStandbyShadow, 0.3));
  ASSERT_TRUE(meter.take(gap));
  EXPECT_EQ(gap.run_id, 1);
  EXPECT_EQ(gap.other_run_id, 2);
  EXPECT_EQ(gap.tick, 107);
  EXPECT_NEAR(static_cast<double>(gap.q[0]), 0.2, 1e-6);
  EXPECT_NEAR(static_cast<double>(gap.tau[1]), 2.0, 1e-5);
  EXPECT_NEAR(static_cast<double>(gap.foot_force[0][2]), 0.2, 1e-3);
  EXPECT_NEAR(static_cast<double>(gap.tilt[0]), 0.2, 1e-6);
  EXPECT_FALSE(meter.take(gap));
}

TEST(GapMeter, AStandbyThatIsAheadIsComparedWhenTheActiveStateComes) {
  GapMeter meter;
  Gap gap;
  for (std::int64_t tick = 100; tick < 110; ++tick) {
    meter.on_other(state(2, tick + 1, Role::kStandbyShadow, 0.3));
    meter.on_active(state(1, tick, Role::kActive, 0.1));
    ASSERT_EQ(meter.take(gap), tick > 100) << tick;
  }
  EXPECT_EQ(gap.tick, 109);
  EXPECT_EQ(gap.other_run_id, 2);
  EXPECT_NEAR(static_cast<double>(gap.q[0]), 0.2, 1e-6);
}

TEST(GapMeter, ParkedSourcesOtherRobotsAndTicksNotSeenAreNotCompared) {
  GapMeter meter;
  Gap gap;
  meter.on_active(state(1, 100, Role::kActive, 0.1));
  meter.on_other(state(2, 100, Role::kParked, 0.3));
  meter.on_other(state(2, 101, Role::kStandbyShadow, 0.3));
  RobotState other_robot = state(2, 100, Role::kStandbyShadow, 0.3);
  other_robot.model_hash = 8;
  meter.on_other(other_robot);
  EXPECT_FALSE(meter.take(gap));
}

}  // namespace
}  // namespace twinbus
