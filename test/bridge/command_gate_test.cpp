#include "bridge/gate/command_gate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/kinematics/brake.h"
#include "test/bridge/small_robot.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using namespace test;

class Gate : public ::testing::Test {
 protected:
  Gate() : model(small_model()), limits(model), gate(limits, false, 1) {
    RobotState rest;
    gate.hold_measured(rest);
    gate.open(kRun, kTerm, true, 0.0, now);
  }

  JointCommand command() const {
    JointCommand c;
    c.tick = tick;
    c.run_id = kRun;
    c.model_hash = model.hash;
    c.controller_id = 7;
    c.term = kTerm;
    c.joint_count = 2;
    c.kp.fill(1000.0F);
    c.kd.fill(20.0F);
    return c;
  }
  GateVerdict offer(const JointCommand& c) { return gate.accept(c, tick, false, now); }
  const JointCommand& next() {
    const JointCommand& written = gate.output(tick, false, now);
    ++tick;
    now += kPeriodNs;
    return written;
  }

  static constexpr std::int64_t kRun = 42;
  static constexpr std::int32_t kTerm = 3;
  Model model;
  GateLimits limits;
  CommandGate gate;
  std::int64_t tick = 100, now = 1000 * kMs;
};

TEST_F(Gate, PassesAGoodCommandUnchanged) {
  JointCommand c = command();
  c.q[0] = 0.005;
  c.tau[0] = 3.0F;
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  const JointCommand& written = next();
  EXPECT_EQ(written.q[0], 0.005);
  EXPECT_EQ(written.tau[0], 3.0F);
  EXPECT_EQ(gate.counters().clamped, 0);
}

TEST_F(Gate, RefusesEveryWrongAddressWithItsOwnVerdict) {
  const auto refuses = [&](GateVerdict verdict, const auto& change) {
    JointCommand c = command();
    change(c);
    const std::int64_t before = gate.counters().rejected;
    EXPECT_EQ(offer(c), verdict);
    EXPECT_EQ(gate.counters().rejected, before + 1);
    EXPECT_FALSE(gate.commanded());
  };
  refuses(GateVerdict::kOtherRun, [](JointCommand& c) { c.run_id = 43; });
  refuses(GateVerdict::kOtherTerm, [](JointCommand& c) { c.term = 2; });
  refuses(GateVerdict::kOtherTerm, [](JointCommand& c) { c.term = 4; });
  refuses(GateVerdict::kTooOld, [](JointCommand& c) { c.tick = 100 - 21; });
  refuses(GateVerdict::kTooOld, [](JointCommand& c) { c.tick = 101; });
  refuses(GateVerdict::kWrongSize, [](JointCommand& c) { c.joint_count = 1; });
  refuses(GateVerdict::kWrongSize, [](JointCommand& c) { c.joint_count = 3; });
  refuses(GateVerdict::kWrongSize, [](JointCommand& c) { c.joint_count = -1; });
  refuses(GateVerdict::kWrongModel, [](JointCommand& c) { c.model_hash += 1; });
}

TEST_F(Gate, RefusesTheWholeCommandForOneNumberThatIsNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()}) {
    for (int field = 0; field < 5; ++field) {
      for (const std::size_t joint : {0U, 1U}) {
        JointCommand c = command();
        c.q[0] = 0.004;
        const auto f = static_cast<float>(bad);
        if (field == 0) c.q[joint] = bad;
        if (field == 1) c.qd[joint] = f;
        if (field == 2) c.tau[joint] = f;
        if (field == 3) c.kp[joint] = f;
        if (field == 4) c.kd[joint] = f;
        EXPECT_EQ(offer(c), GateVerdict::kNotFinite) << field;
      }
    }
  }
  EXPECT_EQ(next().q[0], 0.0);
}

TEST_F(Gate, NumbersBeyondTheJointsOfTheRobotDoNotMatter) {
  JointCommand c = command();
  c.q[2] = std::nan("");
  EXPECT_EQ(offer(c), GateVerdict::kAccepted);
}

TEST_F(Gate, ATickIsObeyedOnceAndNeverAfterANewerOne) {
  EXPECT_EQ(offer(command()), GateVerdict::kAccepted);
  EXPECT_EQ(offer(command()), GateVerdict::kOldTick);
  next();
  JointCommand old = command();
  old.tick = 99;
  EXPECT_EQ(offer(old), GateVerdict::kOldTick);
  EXPECT_EQ(offer(command()), GateVerdict::kAccepted);
}

TEST_F(Gate, IsBoundToTheFirstControllerUntilItIsReboundByRequest) {
  offer(command());
  next();
  JointCommand other = command();
  other.controller_id = 8;
  EXPECT_EQ(offer(other), GateVerdict::kOtherController);
  gate.rebind(8);
  EXPECT_EQ(offer(command()), GateVerdict::kAccepted);  // the old one until the new one speaks
  next();
  other = command();
  other.controller_id = 8;
  EXPECT_EQ(offer(other), GateVerdict::kAccepted);
  EXPECT_TRUE(gate.blending());
  next();
  EXPECT_EQ(offer(command()), GateVerdict::kOtherController);
}

TEST_F(Gate, CutsPositionVelocityTorqueGainsAndSteps) {
  for (int i = 0; i < 1000; ++i) {
    JointCommand c = command();
    c.q[0] = 1e300;
    c.qd[0] = 1e30F;
    c.tau[0] = -1e30F;
    c.kp[0] = 1e30F;
    c.kd[0] = -5.0F;
    ASSERT_EQ(offer(c), GateVerdict::kAccepted);
    const double before = gate.effective().q[0];
    const float tau = gate.effective().tau[0];
    const JointCommand& w = next();
    ASSERT_LE(w.q[0], 2.0);
    ASSERT_LE(w.q[0] - before, 1.05 * 4.0 * 0.002 + 1e-12);
    ASSERT_LE(w.qd[0], 4.0F);
    ASSERT_GE(w.tau[0], -100.0F);
    ASSERT_LE(std::abs(w.tau[0] - tau), 10.0F + 1e-4F);
    ASSERT_LE(w.kp[0], 10000.0F);
    ASSERT_GE(w.kd[0], 0.0F);
  }
  EXPECT_DOUBLE_EQ(gate.effective().q[0], 2.0);
  EXPECT_GT(gate.counters().clamped, 1000);
}

TEST_F(Gate, KeepsTheFirstNumberThatItCut) {
  JointCommand c = command();
  c.qd[1] = -5.0F;
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  next();
  c = command();
  c.q[0] = 3.0;
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  next();
  EXPECT_EQ(gate.first_cut().what, FirstCut::What::kVelocity);
  EXPECT_EQ(gate.first_cut().joint, 1);
  EXPECT_EQ(gate.first_cut().asked, -5.0);
  EXPECT_EQ(gate.first_cut().given, -4.0);
}

TEST_F(Gate, ACutOfLessThanAFiftiethIsCountedAndNotKept) {
  JointCommand c = command();
  c.q[1] = 0.0;
  c.qd[1] = 4.05F;  // of 4
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  next();
  EXPECT_EQ(gate.counters().clamped, 1);
  EXPECT_EQ(gate.first_cut().what, FirstCut::What::kNone);
  c = command();
  c.qd[1] = 4.2F;
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  next();
  EXPECT_EQ(gate.counters().clamped, 2);
  EXPECT_EQ(gate.first_cut().what, FirstCut::What::kVelocity);
}

// A controller that keeps to 1 rad/s asks for the way of all the ticks in which its commands were lost.
TEST_F(Gate, AStepThatMakesUpForLostCommandsIsNotAControllerBeyondItsLimit) {
  JointCommand c = command();
  const auto go_on = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      c.tick = tick;
      c.q[0] += 0.006;  // of 0.0084 in a tick
      ASSERT_EQ(offer(c), GateVerdict::kAccepted);
      next();
    }
  };
  go_on(1);
  gate.blend_again(0.0);
  go_on(20);
  ASSERT_EQ(gate.first_cut().what, FirstCut::What::kNone);
  ASSERT_EQ(gate.first_catch_up().what, FirstCut::What::kNone);
  for (int i = 0; i < 2; ++i) {
    c.q[0] += 0.006;
    next();
  }
  go_on(20);
  EXPECT_EQ(gate.first_cut().what, FirstCut::What::kNone);
  EXPECT_EQ(gate.first_catch_up().what, FirstCut::What::kPositionStep);
  EXPECT_EQ(gate.first_catch_up().silent, 2);
  EXPECT_NEAR(gate.first_catch_up().asked, 0.018, 1e-9);
  EXPECT_NEAR(gate.first_catch_up().given, 0.0084, 1e-9);
  EXPECT_NEAR(gate.effective().q[0], c.q[0], 1e-9) << "it has caught up";
  for (int i = 0; i < 100; ++i) {  // and then it does go beyond
    c.tick = tick;
    c.q[0] -= 0.02;
    ASSERT_EQ(offer(c), GateVerdict::kAccepted);
    next();
  }
  EXPECT_EQ(gate.first_cut().what, FirstCut::What::kPositionStep);
}

TEST_F(Gate, HoldsWhenNothingIsAcceptedForTheTimeoutAndNotBefore) {
  offer(command());
  const std::int64_t fed = now;
  gate.watch(fed + 40 * kMs - 1);
  EXPECT_FALSE(gate.latch().latched());
  gate.watch(fed + 40 * kMs);
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
  EXPECT_EQ(gate.latch().reason, StopReason::kCommandTimeout);
}

TEST_F(Gate, ABacklogAfterASleepDoesNotFeedTheWatchdog) {
  offer(command());
  next();
  now += 50 * kMs;
  EXPECT_EQ(offer(command()), GateVerdict::kStopped);
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
}

TEST_F(Gate, AHoldBringsTheSetPointToRestWithoutAJump) {
  JointCommand c = command();
  for (int i = 0; i < 50; ++i) {
    c.tick = tick;
    c.q[0] += 0.002;
    c.qd[0] = 1.0F;
    ASSERT_EQ(offer(c), GateVerdict::kAccepted);
    next();
  }
  gate.stop(StopKind::kHold, StopReason::kOperator, now);
  double q = gate.effective().q[0];
  float qd = gate.effective().qd[0];
  for (int i = 0; i < 200; ++i) {
    const JointCommand& w = next();
    ASSERT_LE(std::abs(w.q[0] - q), 0.0021);
    ASSERT_LE(std::abs(w.qd[0] - qd), 0.09F);
    q = w.q[0];
    qd = w.qd[0];
  }
  EXPECT_EQ(qd, 0.0F);
  EXPECT_FLOAT_EQ(gate.effective().kp[0], 800.0F);  // those of a stop
  EXPECT_FLOAT_EQ(gate.effective().kd[0], 40.0F);
}

TEST_F(Gate, OffLetsGo) {
  offer(command());
  gate.stop(StopKind::kOff, StopReason::kOperator, now);
  const JointCommand& w = next();
  EXPECT_EQ(w.kp[0], 0.0F);
  EXPECT_EQ(w.tau[0], 0.0F);
  EXPECT_EQ(w.kd[0], 40.0F);  // damping, as this robot says
}

TEST_F(Gate, ABalancedStopPassesOnlyStoppingCommandsAndAtMostTwoSeconds) {
  offer(command());
  next();
  gate.stop(StopKind::kBalanced, StopReason::kOperator, now);
  EXPECT_EQ(offer(command()), GateVerdict::kStopped);
  for (int i = 0; i < 1002; ++i) {
    JointCommand c = command();
    c.flags = kCommandStopping;
    const GateVerdict verdict = offer(c);
    if (i < 1000) {
      ASSERT_EQ(verdict, GateVerdict::kAccepted) << i;
    }
    next();
  }
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
}

TEST_F(Gate, TheAnswerToAStateFromBeforeABalancedStopIsObeyed) {
  offer(command());
  next();
  const JointCommand answer = command();
  gate.published(answer.tick);
  gate.stop(StopKind::kBalanced, StopReason::kOperator, now);
  EXPECT_EQ(offer(answer), GateVerdict::kAccepted);
  next();
  gate.published(answer.tick + 1);
  EXPECT_EQ(offer(command()), GateVerdict::kStopped);
}

TEST_F(Gate, ABalancedStopHoldsAfterThreeTicksWithoutStopping) {
  offer(command());
  next();
  gate.stop(StopKind::kBalanced, StopReason::kOperator, now);
  next();
  next();
  EXPECT_EQ(gate.latch().kind, StopKind::kBalanced);
  next();
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
}

TEST_F(Gate, WhoAsksForNoFadeIsObeyedFromTheFirstTickAndNothingJumps) {
  gate.blend_again(0.3);
  JointCommand c = command();
  c.flags = kCommandNoFade;
  c.q[0] = 0.005;
  c.q[1] = 3.0;
  c.tau[0] = 1000.0F;
  const double before = gate.effective().q[1];
  const double torque = static_cast<double>(gate.effective().tau[0]);
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  const JointCommand& w = next();
  EXPECT_EQ(w.q[0], 0.005);
  EXPECT_FLOAT_EQ(w.kp[0], 1000.0F);
  EXPECT_LE(w.q[1] - before, limits.step[1] + 1e-12);
  EXPECT_LE(static_cast<double>(w.tau[0]) - torque, 0.1 * limits.effort[0] + 1e-6);
}

TEST_F(Gate, AfterAClearTheClientIsFadedIn) {
  offer(command());
  next();
  gate.stop(StopKind::kHold, StopReason::kOperator, now);
  next();
  EXPECT_FALSE(gate.clear(gate.latch().nonce + 1, now));
  ASSERT_TRUE(gate.clear(gate.latch().nonce, now));
  JointCommand c = command();
  c.q[0] = 0.5;
  ASSERT_EQ(offer(c), GateVerdict::kAccepted);
  EXPECT_LT(std::abs(next().q[0]), 1e-3);
}

TEST_F(Gate, SaysHowFarAClientIsFadedIn) {
  EXPECT_EQ(gate.faded_in(), 0.0F);  // nobody has spoken
  gate.blend_again(0.1);
  float before = 0.0F;
  for (int i = 0; i < 60; ++i) {
    JointCommand c = command();
    c.q[0] = 0.5;
    ASSERT_EQ(offer(c), GateVerdict::kAccepted);
    next();
    EXPECT_GE(gate.faded_in(), before);
    if (i == 0) { EXPECT_LT(gate.faded_in(), 0.01F); }
    if (i == 24) { EXPECT_NEAR(gate.faded_in(), 0.5F, 0.05F); }  // 50 of 100 ms
    before = gate.faded_in();
  }
  EXPECT_EQ(before, 1.0F);
  gate.stop(StopKind::kHold, StopReason::kOperator, now);
  EXPECT_EQ(gate.faded_in(), 0.0F);  // a hold is obeyed, no client
}

TEST_F(Gate, TheGuardsMaskBrakesAJointAndLetsTheOthersGo) {
  JointCommand c = command();
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      c.tick = tick;
      c.q[0] += 0.002;
      c.q[1] += 0.002;
      c.qd[0] = c.qd[1] = 1.0F;
      EXPECT_EQ(offer(c), GateVerdict::kAccepted);
      next();
    }
  };
  run(20);
  const double before = gate.effective().q[0];
  for (int i = 0; i < 100; ++i) {
    GuardReport report;
    report.run_id = kRun;
    report.tick = tick;
    report.hold_mask = 1;
    gate.guard(report, now);
    run(1);
  }
  EXPECT_EQ(gate.effective().qd[0], 0.0F);
  EXPECT_LT(gate.effective().q[0] - before, 0.02);
  EXPECT_NEAR(gate.effective().q[1], c.q[1], 1e-9);
  run(200);  // the guard is silent and not required: faded back
  EXPECT_NEAR(gate.effective().q[0], c.q[0], 1e-6);
}

// A policy's set-point lies far from its joint on purpose: held, it would pull the joint there.
TEST_F(Gate, ASoftJointIsBrakedFromWhereItIsWithTheGainsOfAHold) {
  JointCommand c = command();
  c.kp[0] = 30.0F;
  c.kd[0] = 1.0F;
  c.q[0] = 0.6;
  c.tau[0] = 5.0F;
  RobotState state;
  state.q[0] = 0.1;
  state.qd[0] = 0.8F;
  GuardReport report;
  report.run_id = kRun;
  const auto run = [&](int ticks, std::int64_t mask) {
    for (int i = 0; i < ticks; ++i) {
      c.tick = state.tick = report.tick = tick;
      report.hold_mask = mask;
      gate.measured(state);
      gate.guard(report, now);
      ASSERT_EQ(offer(c), GateVerdict::kAccepted);
      next();
    }
  };
  run(100, 0);
  EXPECT_EQ(gate.effective().q[0], 0.6);
  const std::int64_t clamped = gate.counters().clamped;
  run(1, 1);
  double q = 0.1;
  float qd = 0.8F;
  brake_step(limits.brake[0], limits.period, q, qd);
  EXPECT_NEAR(gate.effective().q[0], q, 1e-9);
  EXPECT_EQ(gate.effective().qd[0], qd);
  EXPECT_EQ(gate.effective().kp[0], limits.stop_kp[0]);
  EXPECT_EQ(gate.effective().kd[0], limits.stop_kd[0]);
  EXPECT_EQ(gate.effective().tau[0], 0.0F);
  EXPECT_EQ(gate.counters().clamped, clamped) << "a brake is no jump of a client";
  run(60, 1);
  EXPECT_EQ(gate.effective().qd[0], 0.0F);
  EXPECT_LT(gate.effective().q[0], 0.12);
  const double held = gate.effective().q[0];
  run(1, 0);  // at once, as fast as a set-point may move
  EXPECT_EQ(gate.effective().kp[0], 30.0F);
  EXPECT_NEAR(gate.effective().q[0], held + limits.step[0], 1e-9);
}

TEST(GuardedGate, BrakesTheArmsWhenARequiredGuardFallsSilentButNeverWalkingLegs) {
  const Model model = small_model();
  GateLimits limits(model);
  limits.arms = 2;
  limits.legs = 1;
  CommandGate gate(limits, true, 1);
  gate.open(42, 3, false, 0.0, 0);
  gate.output(0, true, 30 * kMs);
  EXPECT_EQ(gate.masked(), 0);
  gate.hold_measured({});
  JointCommand c;
  c.run_id = 42;
  c.term = 3;
  c.model_hash = model.hash;
  c.joint_count = 2;
  ASSERT_EQ(gate.accept(c, 0, false, 30 * kMs), GateVerdict::kAccepted);
  gate.output(0, true, 31 * kMs);
  EXPECT_EQ(gate.masked(), 2);
  GuardReport report;
  report.run_id = 42;
  report.tick = 1;
  report.hold_mask = 3;
  gate.guard(report, 32 * kMs);
  gate.output(1, true, 32 * kMs);
  EXPECT_EQ(gate.masked(), 2);
  gate.output(2, false, 33 * kMs);
  EXPECT_EQ(gate.masked(), 3);
}

TEST_F(Gate, NothingInTheLoopAllocates) {
  NoAlloc no_alloc;
  for (int i = 0; i < 100; ++i) {
    (void)offer(command());
    next();
  }
  gate.stop(StopKind::kHold, StopReason::kOperator, now);
  next();
  EXPECT_EQ(no_alloc.count(), 0);
}

TEST_F(Gate, AClosedGateObeysNobody) {
  gate.close();
  EXPECT_EQ(offer(command()), GateVerdict::kClosed);
  now += 1000 * kMs;
  gate.watch(now);
  EXPECT_FALSE(gate.latch().latched());  // nobody is expected to speak
}

}  // namespace
}  // namespace twinbus
