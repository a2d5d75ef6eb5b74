// Stop plans at the gate: when they are followed, who may end them, and which are refused.

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "bridge/gate/command_gate.h"
#include "robot/stop_plan/stop_plan.h"
#include "test/bridge/small_robot.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using namespace test;

constexpr std::int64_t kRun = 42, kController = 7;
constexpr std::int32_t kTerm = 3;
constexpr int kKnots = 12;     // three pieces
constexpr int kSpacing = 5;    // [ticks]
constexpr int kHeld = 500;     // after the last knot [ticks]
constexpr double kRate = 0.5;  // of joint 0 [rad/s]

class StopPlanGate : public ::testing::Test {
 protected:
  StopPlanGate() : model(small_model()), limits(model), gate(limits, false, 1) { begin(); }
  // A gate that has obeyed nobody yet.
  void begin() {
    gate = CommandGate(limits, false, 1);
    gate.hold_measured(RobotState{});
    gate.open(kRun, kTerm, true, 0.0, now);
    tick = 100;
  }
  // Joint 0 on its way at a constant rate.
  JointCommand command() const {
    JointCommand c;
    c.tick = tick;
    c.run_id = kRun;
    c.model_hash = model.hash;
    c.controller_id = kController;
    c.term = kTerm;
    c.joint_count = 2;
    c.q[0] = kRate * 0.002 * static_cast<double>(tick - 100);
    c.qd[0] = static_cast<float>(kRate);
    c.kp.fill(1000.0F);
    c.kd.fill(20.0F);
    return c;
  }
  StopPlan plan(std::int32_t number) const {
    StopPlan p;
    p.head = {.run_id = kRun,
              .model_hash = model.hash,
              .controller_id = kController,
              .tick = tick - 1,
              .joints = 1,
              .term = kTerm,
              .number = number,
              .pieces = 3,
              .knot_count = kKnots,
              .spacing = kSpacing,
              .joint_count = 2};
    const double from = kRate * 0.002 * static_cast<double>(tick - 1 - 100);
    for (int k = 0; k < kKnots; ++k) {
      const double on = 0.002 * kSpacing * std::min(k, 6) * kRate;  // then it rests
      EXPECT_TRUE(to_plan(from + on, kPlanPosition, p.q[static_cast<std::size_t>(k)][0]));
    }
    return p;
  }
  void send(const StopPlan& p, const std::vector<int>& order = {0, 1, 2}) {
    for (const int i : order) {
      StopPlanPiece piece;
      p.copy_to(i, piece);
      gate.add_plan(piece, tick - 1);
    }
  }
  const JointCommand& next(bool commanded) {
    if (commanded) {
      EXPECT_EQ(offer(command()), GateVerdict::kAccepted);
    }
    const JointCommand& written = gate.output(tick, false, now);
    ++tick;
    now += kPeriodNs;
    return written;
  }
  GateVerdict offer(const JointCommand& c) { return gate.accept(c, tick, false, now); }
  void walk(int ticks) {
    for (int i = 0; i < ticks; ++i) next(true);
  }
  bool follows_next() {
    next(false);
    return gate.plan().running();
  }

  Model model;
  GateLimits limits;
  CommandGate gate;
  std::int64_t tick = 100, now = 1000 * kMs;
};

TEST_F(StopPlanGate, IsFollowedFromTheFirstMissedTickWithoutAStepAndThenLatches) {
  walk(20);
  send(plan(1));
  double before = gate.effective().q[0];
  for (int i = 0; i < kKnots * kSpacing - 6; ++i) {
    NoAlloc no_alloc;
    const double q = next(false).q[0];
    EXPECT_EQ(no_alloc.count(), 0);
    ASSERT_TRUE(gate.plan().running()) << i;
    EXPECT_EQ(gate.plan().number(), 1);
    EXPECT_EQ(gate.plan().since(), 120);
    EXPECT_NEAR(q - before, i < 25 ? 0.002 * kRate : 0.0, 0.0012) << i;  // no step
    EXPECT_FALSE(gate.latch().latched());
    before = q;
  }
  for (int i = 0; i < kHeld; ++i) {
    next(false);
    ASSERT_TRUE(gate.plan().running()) << "held at its end for a second " << i;
  }
  for (int i = 0; i < 10; ++i) next(false);
  EXPECT_FALSE(gate.plan().running());
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
  EXPECT_EQ(gate.latch().reason, StopReason::kCommandTimeout);
  EXPECT_TRUE(gate.held_after_plan());
  EXPECT_NEAR(gate.effective().q[0], before, 0.002);
}

// Controller and guard die together: the arms stop, what is no arm goes on to the plan's end.
TEST_F(StopPlanGate, WithoutAGuardArmsStopAndTheRestFollowsThePlan) {
  limits.arms = 2;
  gate = CommandGate(limits, true, 1);
  gate.hold_measured(RobotState{});
  gate.open(kRun, kTerm, true, 0.0, now);
  for (int i = 0; i < 20; ++i) {
    GuardReport report;
    report.run_id = kRun;
    report.tick = tick;
    gate.guard(report, now);
    next(true);
  }
  StopPlan both = plan(1);
  both.head.joints = 3;
  for (int k = 0; k < kKnots; ++k)
    EXPECT_TRUE(to_plan(0.002 * kSpacing * std::min(k, 6) * kRate, kPlanPosition, both.q[static_cast<std::size_t>(k)][1]));
  send(both);
  const std::int64_t silent = std::llround(model.guard_timeout / 0.002);
  for (std::int64_t i = 0; i < silent - 2; ++i) next(false);
  EXPECT_TRUE(gate.plan().running());
  EXPECT_EQ(gate.masked(), 0);
  for (int i = 0; i < 25; ++i) next(false);
  EXPECT_EQ(gate.masked(), 2);
  const JointCommand stopped = gate.effective();
  EXPECT_LT(stopped.q[1], 0.028);
  EXPECT_EQ(stopped.qd[1], 0.0F);
  for (int i = 0; i < 10; ++i) next(false);
  EXPECT_TRUE(gate.plan().running());
  EXPECT_EQ(gate.effective().q[1], stopped.q[1]);
  EXPECT_NEAR(gate.effective().q[0], kPlanPosition * both.q[kKnots - 1][0], 1e-3);
}

TEST_F(StopPlanGate, WithoutOneTheTimeoutStopsAsEver) {
  walk(20);
  for (int i = 0; i < 21; ++i) EXPECT_FALSE(follows_next());
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
}

TEST_F(StopPlanGate, ItsControllerGoesOnAtOnceAndNobodyElseBeforeTheEnd) {
  walk(20);
  send(plan(1));
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(follows_next());
  JointCommand other = command();
  other.controller_id = 8;
  EXPECT_EQ(offer(other), GateVerdict::kOtherController);
  gate.rebind(8);
  EXPECT_EQ(offer(other), GateVerdict::kPlanRuns);
  JointCommand old = command();
  old.tick = tick - 10;  // it did not know yet
  EXPECT_EQ(offer(old), GateVerdict::kTooOld);
  EXPECT_TRUE(gate.plan().running());
  EXPECT_EQ(offer(command()), GateVerdict::kAccepted);
  EXPECT_FALSE(gate.plan().running());
  EXPECT_FALSE(gate.latch().latched());
}

TEST_F(StopPlanGate, ItsOwnControllerTooWaitsForTheEndAfterTwoTenthsOfASecond) {
  walk(20);
  StopPlan longer = plan(1);
  longer.head.spacing = 20;  // 0.44 s
  send(longer);
  for (int i = 0; i < 110; ++i) ASSERT_TRUE(follows_next()) << i;
  EXPECT_EQ(offer(command()), GateVerdict::kPlanRuns);
  while (!gate.plan().ended(tick) && gate.plan().running()) next(false);
  EXPECT_FALSE(gate.latch().latched());
}

TEST_F(StopPlanGate, AHoldGoesAlongThePlanAndStaysLatched) {
  walk(20);
  send(plan(1));
  gate.stop({.sequence = 1, .kind = StopKind::kHold}, now);
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
  EXPECT_EQ(offer(command()), GateVerdict::kStopped);
  ASSERT_TRUE(follows_next());
  for (int i = 0; i < kKnots * kSpacing + kHeld; ++i) next(false);
  EXPECT_FALSE(gate.plan().running());
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
  EXPECT_NEAR(gate.effective().q[0], kRate * 0.002 * (19 + 6 * kSpacing), 0.003);
}

TEST_F(StopPlanGate, OffIsOffAtOnce) {
  walk(20);
  send(plan(1));
  gate.stop({.sequence = 1, .kind = StopKind::kOff}, now);
  EXPECT_FALSE(follows_next());
  EXPECT_EQ(gate.effective().kp[0], 0.0F);
}

// Pieces lost, repeated and out of order: only whole plans are followed, and those as they were made.
TEST_F(StopPlanGate, CountsOnlyWhenWholeWhateverTheOrder) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 300; ++trial) {
    begin();
    walk(20);
    std::vector<int> order;
    unsigned have = 0;
    for (int n = 0; n < 5; ++n) {
      const int piece = static_cast<int>(random() % 3);
      order.push_back(piece);
      have |= 1U << piece;
    }
    send(plan(1), order);
    EXPECT_EQ(follows_next(), have == 7U);
  }
}

TEST_F(StopPlanGate, NeverMixesTwo) {
  walk(20);
  send(plan(1), {0, 1});
  send(plan(2), {2});
  EXPECT_FALSE(follows_next());
  walk(5);
  StopPlan a = plan(3), b = plan(3);
  b.head.tick -= 1;
  send(a, {0, 1});
  send(b, {2});
  EXPECT_EQ(gate.plan_refusal(), PlanRefusal::kMixed);
  EXPECT_FALSE(follows_next());
  walk(5);
  send(plan(5));
  send(plan(4));  // older, later
  EXPECT_EQ(gate.plan_refusal(), PlanRefusal::kOldNumber);
  ASSERT_TRUE(follows_next());
  EXPECT_EQ(gate.plan().number(), 5);
}

TEST_F(StopPlanGate, RefusesWithItsReasonAndHoldsAsEver) {
  struct Bad {
    PlanRefusal why;
    std::function<void(StopPlan&)> spoil;
  };
  const std::vector<Bad> all{
      {PlanRefusal::kOtherSource, [](StopPlan& p) { p.head.run_id += 1; }},
      {PlanRefusal::kOtherSource, [](StopPlan& p) { p.head.term += 1; }},
      {PlanRefusal::kOtherSource, [](StopPlan& p) { p.head.model_hash += 1; }},
      {PlanRefusal::kOtherController, [](StopPlan& p) { p.head.controller_id += 1; }},
      {PlanRefusal::kWrongSize, [](StopPlan& p) { p.head.joint_count = 3; }},
      {PlanRefusal::kWrongSize, [](StopPlan& p) { p.head.knot_count = 31; }},
      {PlanRefusal::kWrongSize, [](StopPlan& p) { p.head.spacing = 0; }},
      {PlanRefusal::kWrongSize, [](StopPlan& p) { p.head.spacing = 1000; }},  // too long
      {PlanRefusal::kWrongSize, [](StopPlan& p) { p.head.pieces = 2; }},
      {PlanRefusal::kWrongTime, [](StopPlan& p) { p.head.tick += 20; }},
      {PlanRefusal::kWrongTime, [](StopPlan& p) { p.head.tick -= 110; }},
      {PlanRefusal::kBeyondLimits, [](StopPlan& p) { p.tau[7][0] = 3000; }},
      {PlanRefusal::kBeyondLimits,
       [](StopPlan& p) {
         p.head.walks = true;  // a robot without feet
       }},
      {PlanRefusal::kTooFast, [](StopPlan& p) { p.q[7][0] = static_cast<std::int16_t>(p.q[7][0] + 900); }},
      {PlanRefusal::kOutOfReach,
       [](StopPlan& p) {
         for (PlanRow& row : p.q) row[0] = static_cast<std::int16_t>(row[0] + 1000);
       }},
  };
  std::int32_t number = 0;
  for (const Bad& bad : all) {
    walk(5);
    StopPlan p = plan(++number);
    bad.spoil(p);
    const std::int64_t before = gate.counters().plans_refused;
    send(p);
    EXPECT_EQ(gate.plan_refusal(), bad.why) << number;
    EXPECT_GT(gate.counters().plans_refused, before) << number;
    EXPECT_FALSE(follows_next()) << number;
  }
  for (int i = 0; i < 21; ++i) next(false);
  EXPECT_EQ(gate.latch().kind, StopKind::kHold);
}

// A stream of plans of which pieces are lost, come twice, out of order and mixed: what is followed is one that was made, whole.
TEST_F(StopPlanGate, AStreamWithLossFollowsWholePlansOnly) {
  std::mt19937 random(11);
  int followed = 0;
  for (int trial = 0; trial < 200; ++trial) {
    begin();
    walk(5);
    std::vector<StopPlan> made;
    std::vector<StopPlanPiece> on_the_way;
    for (int n = 1; n <= 6; ++n) {
      made.push_back(plan(n));
      made.back().tau[3][0] = static_cast<std::int16_t>(10 * n);  // tells it from the others
      for (int i = 0; i < 3; ++i) {
        StopPlanPiece piece;
        made.back().copy_to(i, piece);
        if (random() % 10 == 0) continue;  // lost
        on_the_way.push_back(piece);
        if (random() % 5 == 0) on_the_way.push_back(piece);
      }
      for (std::size_t k = 0; k + 1 < on_the_way.size(); ++k) {
        if (random() % 4 == 0) std::swap(on_the_way[k], on_the_way[k + 1]);
      }
      while (on_the_way.size() > 2) {  // the rest comes among those of the next
        gate.add_plan(on_the_way.front(), tick - 1);
        on_the_way.erase(on_the_way.begin());
      }
      walk(3);
    }
    if (!follows_next()) continue;
    ++followed;
    const StopPlan& whole = *gate.plan().whole();
    const StopPlan& same = made[static_cast<std::size_t>(whole.head.number - 1)];
    EXPECT_TRUE(whole.head == same.head);
    for (std::size_t k = 0; k < kKnots; ++k) {
      EXPECT_EQ(whole.q[k], same.q[k]);
      EXPECT_EQ(whole.tau[k], same.tau[k]);
    }
  }
  EXPECT_GT(followed, 150);
}

// One that was good grows too old, and is not followed then.
TEST_F(StopPlanGate, IsNotFollowedWhenItHasBecomeTooOld) {
  walk(20);
  send(plan(1));
  walk(105);
  EXPECT_FALSE(follows_next());
}

// A command that comes a tick late every now and then is no silence.
TEST_F(StopPlanGate, ATickLateIsBridgedWithoutAStep) {
  walk(20);
  for (int i = 0; i < 40; ++i) {
    if (i % 4 == 0) send(plan(i + 1));
    const double before = gate.effective().q[0];
    const double q = next(i % 2 == 0).q[0];
    EXPECT_NEAR(q - before, 0.002 * kRate, 0.0005) << i;
  }
  EXPECT_FALSE(gate.latch().latched());
}

}  // namespace
}  // namespace twinbus
