#include "bridge/source/source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "test/bridge/small_robot.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using namespace test;

// A source, a controller that answers at once or not, a clock.
class Loop : public ::testing::Test {
 protected:
  Loop() : model(small_model()), source(model, robot, config()) {}
  static SourceConfig config() {
    SourceConfig c;
    c.run_id = 1;
    return c;
  }
  void begin() {
    now += kPeriodNs;
    source.begin_tick(now);
  }
  void answer(std::int64_t after) {
    JointCommand c = command_for(source.state());
    c.q[0] = asked_q;
    source.on_command(c, now + after);
    fed = now + after;
  }
  void end() { source.end_tick(now + 3 * kPeriodNs / 5); }
  // One that is answered so much later.
  void tick(std::int64_t after = 0) {
    begin();
    answer(after);
    end();
  }
  // Ticks that are answered at once.
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }
  void activate() {
    for (int i = 0; i < 600; ++i) {
      begin();
      end();
    }
    SourceRequest r;
    r.sender_id = 5;
    r.sequence = 1;
    r.action = SourceAction::kActivate;
    r.target_run_id = 1;
    source.on_source_request(r, now);
    tick();
    ASSERT_EQ(source.state().role, Role::kActive);
  }

  Model model;
  PointRobot robot;
  Source source;
  std::int64_t now = 10'000 * kMs, fed = 0;
  double asked_q = 0.0;
};

TEST_F(Loop, StopsBetween40And46MillisecondsAfterTheLastAcceptedCommand) {
  activate();
  for (const std::int64_t when : {0, 100'000, 900'000, 1'900'000}) {
    for (int i = 0; i < 10; ++i) tick(when);
    const float kp_before = robot.written.kp[0];
    while (source.state().role != Role::kStopped) {
      begin();
      end();
      ASSERT_LT(now - fed, 60 * kMs);
    }
    const std::int64_t first_stop_write = now;  // of the tick that shows it, or up to a tick before
    EXPECT_GE(first_stop_write - fed, 40 * kMs) << when;
    EXPECT_LE(first_stop_write - fed, 46 * kMs) << when;
    EXPECT_EQ(source.status().stop_reason, StopReason::kCommandTimeout);
    EXPECT_GT(kp_before, 0.0F);
    StopRequest clear;
    clear.stop_nonce = source.state().stop_nonce;
    source.on_stop(clear, now);
    tick();
    ASSERT_EQ(source.state().role, Role::kActive);
  }
}

TEST_F(Loop, ACommandIsReadyOnceAndALateOneIsCounted) {
  activate();
  begin();
  EXPECT_FALSE(source.command_ready());
  answer(0);
  EXPECT_TRUE(source.command_ready());
  end();
  begin();
  end();
  answer(kPeriodNs / 2);  // after its set-point was written
  EXPECT_EQ(source.status().stop_kind, StopKind::kNone);
  begin();
  end();
  EXPECT_EQ(source.status().commands_late, 1);
}

TEST_F(Loop, AStopWorksWithTheControllerDeadAndStaysThroughEverythingButItsClear) {
  activate();
  StopRequest stop;
  stop.sender_id = 9;
  stop.sequence = 1;
  stop.kind = StopKind::kHold;
  stop.reason = StopReason::kOperator;
  const std::int32_t old_nonce = source.state().stop_nonce;
  source.on_stop(stop, now);
  begin();
  end();
  EXPECT_EQ(source.state().role, Role::kStopped);
  StopRequest clear;
  clear.stop_nonce = old_nonce;
  for (int i = 0; i < 100; ++i) {
    source.on_stop(clear, now);
    tick();
    ASSERT_EQ(source.state().role, Role::kStopped);
  }
}

TEST_F(Loop, ADeviceThatFailsForTwentyMillisecondsStops) {
  activate();
  run(5);
  robot.read_status = Status::kTimeout;
  run(9);
  EXPECT_EQ(source.state().role, Role::kActive);
  run(3);
  EXPECT_EQ(source.state().role, Role::kStopped);
  EXPECT_EQ(source.status().stop_reason, StopReason::kDevice);
}

TEST_F(Loop, ADeviceThatMeasuresNonsenseIsNotPublished) {
  activate();
  robot.q = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i < 20; ++i) {
    run(1);
    ASSERT_TRUE(std::isfinite(source.state().q[0]));
  }
  EXPECT_EQ(source.state().role, Role::kStopped);
}

TEST_F(Loop, ADeviceThatRefusesACommandStops) {
  activate();
  robot.write_status = Status::kDeviceError;
  tick();
  begin();
  end();
  EXPECT_EQ(source.state().role, Role::kStopped);
  EXPECT_EQ(source.status().stop_reason, StopReason::kDevice);
}

// A driver that repeats its last reading; what a robot at rest shows is no fault as long as nobody moves it.
TEST_F(Loop, FrozenSensorsUnderAMovingCommandStop) {
  robot.has_imu = true;
  activate();
  const auto step = [&] {
    tick();
  };
  for (int i = 0; i < 500; ++i) step();
  EXPECT_EQ(source.status().stop_kind, StopKind::kNone);
  int ticks = 0;
  for (; ticks < 500 && source.state().role == Role::kActive; ++ticks) {
    asked_q = 0.001 * ticks;
    step();
  }
  EXPECT_LE(ticks, 100);
  EXPECT_EQ(source.state().role, Role::kStopped);
  EXPECT_EQ(source.status().stop_reason, StopReason::kDevice);
}

TEST_F(Loop, NothingIsAllocated) {
  activate();
  NoAlloc no_alloc;
  for (int i = 0; i < 100; ++i) tick();
  EXPECT_EQ(no_alloc.count(), 0);
}

// Two real sources that hear each other; the controller answers whoever is on STATE.
class Pair : public ::testing::Test {
 protected:
  explicit Pair(bool simulators = false)
      : model(small_model()), hardware(simulators), a(model, sim, config(1)), b(model, hardware, config(2)) {
    for (int i = 0; i < 600; ++i) tick();
    request(SourceAction::kActivate, 1, 0);
    for (int i = 0; i < 10; ++i) tick();
    request(simulators ? SourceAction::kStandbyTrack : SourceAction::kStandbyShadow, 2, 2);
    for (int i = 0; i < 10; ++i) tick();
  }
  static SourceConfig config(std::int64_t run) {
    SourceConfig c;
    c.run_id = run;
    c.kind = run == 1 ? SourceKind::kSimulator : SourceKind::kBridge;
    return c;
  }
  void request(SourceAction action, std::int64_t target, std::int64_t run) {
    SourceRequest r;
    r.sender_id = 5;
    r.sequence = ++sequence;
    r.action = action;
    r.target_run_id = target;
    r.run_id = run;
    r.policy = SwitchPolicy::kNow;
    a.on_source_request(r, now);
    b.on_source_request(r, now);
  }
  void hear(Source& from, Source& to) {
    if (from.publishes_on_state()) {
      to.on_state(from.state(), now);
    } else {
      to.on_standby_state(from.state(), now);
    }
  }
  // q: what the client asks for.  speaks: it does.
  void tick(double q = 0.0, bool speaks = true) {
    now += kPeriodNs;
    for (Source* source : {second_ticks_first ? &b : &a, second_ticks_first ? &a : &b}) {
      source->begin_tick(now);
      hear(*source, source == &a ? b : a);
    }
    int obeying = 0;
    for (Source* source : {&a, &b}) {
      if (!source->publishes_on_state() || !speaks) continue;
      JointCommand c;
      c.tick = source->state().tick;
      c.run_id = source->state().run_id;
      c.term = source->state().term;
      c.model_hash = model.hash;
      c.controller_id = 7;
      c.joint_count = 2;
      c.q[0] = q;
      c.kp.fill(1000.0F);
      c.kd.fill(20.0F);
      const std::int64_t before = source->status().commands_accepted;
      a.on_command(c, now);
      b.on_command(c, now);
      obeying += source->status().commands_accepted > before;
    }
    a.end_tick(now + kPeriodNs / 2);
    b.end_tick(now + kPeriodNs / 2);
    EXPECT_LE(obeying, 1);
  }

  Model model;
  PointRobot sim{true}, hardware;
  Source a, b;
  std::int64_t now = 10'000 * kMs;
  std::int32_t sequence = 0;
  bool second_ticks_first = false;  // before it hears this tick's STATE of the first, as a standby in time does
};

TEST_F(Pair, SwitchAndSwitchBack) {
  ASSERT_EQ(b.state().role, Role::kStandbyShadow);
  request(SourceAction::kSwitch, 2, 1);
  int ticks = 0;
  while (!b.publishes_on_state() && ++ticks < 20) tick();
  EXPECT_EQ(b.state().term, 2);
  // No tick is missing, none is there twice.
  ASSERT_TRUE(a.publishes_on_state());
  EXPECT_EQ(b.state().tick, a.state().tick + 1);
  tick();
  tick();
  EXPECT_FALSE(a.publishes_on_state());
  for (int i = 0; i < 520; ++i) tick();  // a robot changes its source once a second
  request(SourceAction::kSwitch, 1, 2);
  ticks = 0;
  while (!a.publishes_on_state() && ++ticks < 20) tick();
  EXPECT_EQ(a.state().term, 3);
}

TEST_F(Pair, TheSetPointOfTheRobotThatTakesOverDoesNotJump) {
  hardware.q = 0.04;  // its own: near enough to be granted
  for (int i = 0; i < 400; ++i) tick(0.03);
  request(SourceAction::kSwitch, 2, 1);
  double q = hardware.written.q[0];
  float tau = hardware.written.tau[0];
  for (int i = 0; i < 300; ++i) {
    tick(0.03);
    EXPECT_LT(std::abs(hardware.written.q[0] - q), 0.0005) << i;
    EXPECT_LT(std::abs(hardware.written.tau[0] - tau), 1.0F) << i;
    q = hardware.written.q[0];
    tau = hardware.written.tau[0];
  }
  EXPECT_TRUE(b.publishes_on_state());
  EXPECT_NEAR(q, 0.03, 1e-9);
}

// Two simulators of which one is set to the other's state.
class Twins : public Pair {
 protected:
  Twins() : Pair(true) { sim.has_torque = hardware.has_torque = true; }
  void let_the_second_take_over(double q) {
    second_ticks_first = true;
    request(SourceAction::kSwitch, 2, 1);
    for (int i = 0; i < 20 && !b.publishes_on_state(); ++i) tick(i % 2 == 0 ? 0.0 : q);
    ASSERT_TRUE(b.publishes_on_state());
  }
};

// What the holder measured comes of the command before the newest one: its client's steps are no jump of the switch.
TEST_F(Twins, AClientWhoseSetPointStepsIsObeyedAtOnceAfterASwitch) {
  for (int i = 0; i < 100; ++i) tick(i % 2 == 0 ? 0.0 : 0.004);
  let_the_second_take_over(0.004);
  for (int i = 0; i < 10; ++i) {
    const double asked = i % 2 == 0 ? 0.004 : 0.0;
    tick(asked);
    EXPECT_EQ(hardware.written.q[0], asked) << i;
    EXPECT_EQ(hardware.written.tau[0], 0.0F) << i;
  }
}

// A simulator that was parked takes over within five ticks; a client of 50 Hz speaks every tenth.
TEST_F(Twins, TheClientsCommandIsKnownToASimulatorThatWasParkedWhenItCame) {
  request(SourceAction::kPark, 2, 2);
  for (int i = 0; i < 10; ++i) tick(0.004);
  ASSERT_EQ(b.state().role, Role::kParked);
  request(SourceAction::kStandbyTrack, 2, 2);
  for (int i = 0; i < 3; ++i) tick(0.004, false);
  request(SourceAction::kSwitch, 2, 1);
  for (int i = 0; i < 12 && !b.publishes_on_state(); ++i) tick(0.004, false);
  ASSERT_TRUE(b.publishes_on_state());
  EXPECT_EQ(hardware.written.q[0], 0.004);
  tick(0.004);
  EXPECT_EQ(hardware.written.q[0], 0.004);
}

// What the client wanted long ago, before this one shadowed, is nothing that it takes over.
TEST_F(Twins, AnOldCommandIsNotTakenOverByWhoShadowedSince) {
  request(SourceAction::kPark, 2, 2);
  for (int i = 0; i < 10; ++i) tick(0.3);
  request(SourceAction::kStandbyShadow, 2, 2);
  for (int i = 0; i < 600; ++i) tick(0.0);
  request(SourceAction::kSwitch, 2, 1);
  for (int i = 0; i < 30; ++i) {
    tick(0.0);
    EXPECT_LT(std::abs(hardware.written.q[0]), 0.05) << i;
  }
  EXPECT_TRUE(b.publishes_on_state());
}

TEST_F(Twins, ATorqueThatNoCommandExplainsFadesAfterASwitch) {
  sim.friction = 10.0F;
  for (int i = 0; i < 100; ++i) tick(0.004);
  let_the_second_take_over(0.004);
  EXPECT_NEAR(hardware.written.tau[0], 10.0F, 5.0F);
  for (int i = 0; i < 300; ++i) tick(0.004);
  EXPECT_EQ(hardware.written.tau[0], 0.0F);
}

TEST_F(Pair, ARobotHoldsItsPostureWhileTheOneItShadowsWalks) {
  const auto say = [&](Mode mode) {
    ControllerStatus status;
    status.run_id = 1;
    status.controller_id = 7;
    status.mode = mode;
    a.on_controller_status(status, now);
    b.on_controller_status(status, now);
  };
  for (int i = 0; i < 400; ++i) tick(0.03);
  ASSERT_NEAR(hardware.written.q[0], 0.03, 1e-6);
  for (int i = 0; i < 500; ++i) {
    say(Mode::kWalk);
    tick(0.03 + 0.2 * std::sin(0.05 * i));
    hardware.q = hardware.written.q[0];
    EXPECT_NEAR(hardware.written.q[0], 0.03, 0.01) << i;
  }
  EXPECT_EQ(b.state().role, Role::kStandbyShadow);
  for (int i = 0; i < 600; ++i) {
    say(Mode::kBalance);
    sim.q = 0.05;
    tick(0.05);
    hardware.q = hardware.written.q[0];
  }
  EXPECT_NEAR(hardware.written.q[0], 0.05, 1e-6) << "it follows again";
}

TEST_F(Pair, ARefusedSwitchMovesNothing) {
  hardware.q = 0.2;
  tick();
  const JointCommand before_a = sim.written, before_b = hardware.written;
  request(SourceAction::kSwitch, 2, 1);
  for (int i = 0; i < 50; ++i) tick();
  EXPECT_EQ(a.status().refusal, Refusal::kPosture);
  EXPECT_TRUE(a.publishes_on_state());
  EXPECT_FALSE(b.publishes_on_state());
  EXPECT_EQ(sim.written.q[0], before_a.q[0]);
  EXPECT_EQ(hardware.written.q[0], before_b.q[0]);
}

}  // namespace
}  // namespace twinbus
