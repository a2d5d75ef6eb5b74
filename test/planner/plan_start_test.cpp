#include "planner/plan_start.h"

#include <gtest/gtest.h>

#include "robot/description/load.h"

namespace twinbus {
namespace {

TEST(PlanStart, GoesOnFromASetPointThatTheServoFollowsAndFromTheJointElsewhere) {
  const Model model = load_robot("hrp1s");
  RobotState state;
  state.run_id = 5;
  JointCommand command;
  command.run_id = 5;
  command.q[6] = 0.08;  // a servo error as gravity makes it
  command.q[7] = 0.12;  // too far: not the set-point that this joint follows
  const Configuration measured(model);
  const auto joint = [&](std::size_t k) { return model.bus_joints[k]; };
  const Configuration start = plan_start(model, measured, state, command);
  EXPECT_EQ(start.q[joint(6)], 0.08);
  EXPECT_EQ(start.q[joint(7)], measured.q[joint(7)]);
  command.run_id = 4;  // of another run
  EXPECT_EQ(plan_start(model, measured, state, command).q, measured.q);
}

}  // namespace
}  // namespace twinbus
