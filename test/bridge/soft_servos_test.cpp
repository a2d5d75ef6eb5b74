// A learned policy commands soft servos whose set-points are far from the joints: holds and stop plans begin where they are.

#include "bridge/gate/soft_servos.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bridge/gate/command_gate.h"
#include "robot/stop_plan/stop_plan.h"
#include "test/bridge/small_robot.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using namespace test;

constexpr float kKp = 40.0F, kKd = 1.0F;  // of the policy
constexpr double kFar = 0.5;              // of its set-points from the joints [rad]

float torque(const JointCommand& c, const RobotState& s, std::size_t i) {
  return c.tau[i] + c.kp[i] * static_cast<float>(c.q[i] - s.q[i]) + c.kd[i] * (c.qd[i] - s.qd[i]);
}

TEST(SoftServos, OtherGainsAskForTheSameTorqueAndStiffJointsAreNotTouched) {
  RobotState state;
  state.q = {0.3, -0.2};
  state.qd = {0.7F, -3.0F};
  const MeasuredJoints measured{true, state.q, state.qd};
  JointCommand c;
  c.joint_count = 2;
  c.q = {0.3 + kFar, 0.1};
  c.kp = {kKp, 900.0F};
  c.kd = {kKd, 20.0F};
  c.tau = {2.0F, 3.0F};
  PerJoint<float> kp{}, kd{};
  kp.fill(800.0F);
  kd.fill(40.0F);
  EXPECT_EQ(soft_joints(c, kp, 2), 1);
  const JointCommand before = c;
  stiffen(measured, kp, kd, soft_joints(c, kp, 2), c);
  EXPECT_EQ(c.kp[0], 800.0F);
  EXPECT_EQ(c.kd[0], 40.0F);
  EXPECT_NEAR(torque(c, state, 0), torque(before, state, 0), 1e-3);
  EXPECT_NEAR(c.q[0], state.q[0], 0.07);
  EXPECT_EQ(c.q[1], before.q[1]);
  EXPECT_EQ(c.kp[1], before.kp[1]);
  c = before;
  stiffen({}, kp, kd, 3, c);
  EXPECT_EQ(c.kp[0], kKp) << "nothing was measured";
}

class SoftGate : public ::testing::Test {
 protected:
  SoftGate() : model(small_model()), limits(model), gate(limits, false, 1) {
    state.q = {0.2, -0.1};
    state.joint_count = 2;
    gate.hold_measured(state);
    gate.open(42, 3, true, 0.0, now);
    for (int i = 0; i < 100; ++i) next(true);  // the set-points get there within the joints' rate
  }
  JointCommand command() const {
    JointCommand c;
    c.tick = tick;
    c.run_id = 42;
    c.model_hash = model.hash;
    c.controller_id = 7;
    c.term = 3;
    c.joint_count = 2;
    c.q = {state.q[0] + kFar, state.q[1] - kFar};
    c.kp.fill(kKp);
    c.kd.fill(kKd);
    return c;
  }
  const JointCommand& next(bool commanded) {
    gate.measured(state);
    if (commanded) {
      EXPECT_EQ(gate.accept(command(), tick, false, now), GateVerdict::kAccepted);
    }
    NoAlloc no_alloc;
    const JointCommand& written = gate.output(tick, true, now);
    EXPECT_EQ(no_alloc.count(), 0);
    ++tick;
    now += kPeriodNs;
    return written;
  }
  // To a posture of both joints, as a policy sends it.
  void send_plan(double posture) {
    StopPlan p;
    p.head = {.run_id = 42, .model_hash = model.hash, .controller_id = 7, .tick = tick - 1, .joints = 3, .term = 3,
              .number = ++number, .pieces = 1, .knot_count = 2, .spacing = 125, .joint_count = 2};
    for (std::size_t k = 0; k < 2; ++k) {
      for (std::size_t j = 0; j < 2; ++j) EXPECT_TRUE(to_plan(posture, kPlanPosition, p.q[k][j]));
    }
    StopPlanPiece piece;
    p.copy_to(0, piece);
    gate.add_plan(piece, tick - 1);
  }

  Model model;
  GateLimits limits;
  CommandGate gate;
  RobotState state;
  std::int64_t tick = 100, now = 1000 * kMs;
  std::int32_t number = 0;
};

TEST_F(SoftGate, AHoldBeginsWhereTheJointsAreAndNotAtTheSetPoints) {
  ASSERT_NEAR(gate.effective().q[0], state.q[0] + kFar, 1e-9);
  const float before = torque(gate.effective(), state, 0);
  gate.stop(StopKind::kHold, StopReason::kController, now);
  const JointCommand& held = next(false);
  EXPECT_NEAR(torque(held, state, 0), before, 2.0F);
  for (int i = 0; i < 500; ++i) next(false);
  EXPECT_NEAR(gate.effective().q[0], state.q[0], kFar * 0.06);
  EXPECT_NEAR(gate.effective().q[1], state.q[1], kFar * 0.06);
  EXPECT_EQ(gate.effective().kp[0], 800.0F);
}

TEST_F(SoftGate, AStopPlanIsFollowedFromTheCommandTimeoutOnWithTheServosOfAStop) {
  send_plan(0.0);
  ASSERT_EQ(gate.counters().plans_accepted, 1) << static_cast<int>(gate.plan_refusal());
  const int timeout = static_cast<int>(std::llround(model.command_timeout / 0.002));
  for (int i = 0; i < timeout; ++i) {
    const JointCommand& c = next(false);
    ASSERT_FALSE(gate.plan().running()) << "a short silence changes nothing: tick " << i;
    ASSERT_EQ(c.kp[0], kKp);
    ASSERT_FALSE(gate.latch().latched());
  }
  const float before = torque(gate.effective(), state, 0);
  EXPECT_NEAR(torque(next(false), state, 0), before, 2.0F) << "no step";
  for (int i = 0; i < 130; ++i) {
    const double q = gate.effective().q[0];
    const JointCommand& c = next(false);
    ASSERT_TRUE(gate.plan().running()) << i;
    ASSERT_EQ(c.kp[0], 800.0F);
    ASSERT_LE(std::abs(c.q[0] - q), 0.0085) << "tick " << i;
    state.q = {c.q[0], c.q[1]};
  }
  EXPECT_NEAR(gate.effective().q[0], 0.0, 1e-3);
  EXPECT_NEAR(gate.effective().q[1], 0.0, 1e-3);
  for (int i = 0; i < 700; ++i) next(false);
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
  EXPECT_EQ(gate.latch().reason, StopReason::kCommandTimeout);
  EXPECT_TRUE(gate.held_after_plan());
}

TEST_F(SoftGate, AHoldThatTheControllerAsksForFollowsThePlanAtOnce) {
  send_plan(0.0);
  gate.stop(StopKind::kHold, StopReason::kController, now);
  next(false);
  EXPECT_TRUE(gate.plan().running());
  EXPECT_EQ(gate.effective().kp[0], 800.0F);
}

TEST_F(SoftGate, APlanThatBeginsFarFromTheJointsIsRefused) {
  send_plan(-1.2);
  EXPECT_EQ(gate.plan_refusal(), PlanRefusal::kOutOfReach);
}

TEST_F(SoftGate, TheControllerGoesOnAfterAShortSilenceAsIfNothingHadBeen) {
  send_plan(0.0);
  for (int i = 0; i < 10; ++i) next(false);
  EXPECT_EQ(next(true).kp[0], kKp);
  EXPECT_FALSE(gate.plan().running());
}

}  // namespace
}  // namespace twinbus
