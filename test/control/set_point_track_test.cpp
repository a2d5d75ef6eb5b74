#include "control/guard/set_point_predictor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "robot/kinematics/brake.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr std::size_t kTracked = 6;
constexpr double kTrackDelay = 0.004;  // of one tick until the brake of the next look

struct TrackRig {
  const Model& model = test::hrp1s();
  SetPointTrack track{model, 1, 0.0};
  RobotState state;
  JointCommand command;
  double brake() const {
    return brake_deceleration(model.joints[static_cast<std::size_t>(model.bus_joints[kTracked])]);
  }
  void follow(std::int64_t mask) {
    ++command.tick;
    track.follow(state, command, mask);
  }
  void follow_again() { track.follow(state, command, 0); }
  // One tick: the command is obeyed at once, the joint follows.
  void tick(double q, bool held = false) {
    command.q[kTracked] = q;
    follow(held ? std::int64_t{1} << kTracked : 0);
    measured = state.q[kTracked];
    state.q[kTracked] = q;
  }
  double obeyed() const { return measured + track.if_obeyed(kTracked).rest(); }
  double held() const { return measured + track.if_held(kTracked).rest(); }
  double measured = 0.0;
};

TEST(SetPointTrack, AJointAtRestComesToRestWhereItIs) {
  TrackRig f;
  for (int i = 0; i < 3; ++i) f.tick(0.02);
  EXPECT_NEAR(f.obeyed(), 0.02, 1e-9);
  EXPECT_NEAR(f.held(), 0.02, 1e-9);
}

// Ticks that a busy guard left out, or that the controller did not answer: the set-point is as fast as it was on the whole.
TEST(SetPointTrack, TicksThatWereLeftOutMakeNoJointFaster) {
  for (const int left_out : {1, 3}) {
    TrackRig f;
    const double speed = 0.5, step = speed * f.model.period();
    double q = 0.0;
    for (int i = 0; i < 50; ++i) f.tick(q += step);
    for (int i = 0; i < left_out; ++i) f.follow_again();  // the same command, heard again
    EXPECT_NEAR(f.track.if_obeyed(kTracked).speed, speed, 1e-6) << "it says nothing new";
    f.command.tick += left_out;
    f.tick(q += (left_out + 1) * step);
    EXPECT_LT(f.track.if_obeyed(kTracked).speed, 1.05 * speed) << left_out;
    EXPECT_GT(f.track.if_obeyed(kTracked).speed, 0.95 * speed) << left_out;
  }
}

// A guard that stood still finds a joint far from where it was, and the set-point with it: nothing runs after anything.
TEST(SetPointTrack, ALookAfterALongPauseSeesTheSpeedThatThereIs) {
  TrackRig f;
  const double speed = 0.5, step = speed * f.model.period();
  double q = 0.0;
  for (int i = 0; i < 50; ++i) f.tick(q += step);
  f.command.tick += 100;
  f.state.tick += 101;
  q += 101 * step;
  f.state.q[kTracked] = q - step;
  f.tick(q);
  EXPECT_LT(f.track.if_obeyed(kTracked).speed, 1.05 * speed);
  EXPECT_GT(f.track.if_obeyed(kTracked).speed, 0.95 * speed);
}

// look_ahead(v) = v delay + v |v| / (2 deceleration)
TEST(SetPointTrack, AMovingJointComesToRestAfterDelayAndBrake) {
  for (const double speed : {0.5, -0.5}) {
    TrackRig f;
    double q = 0.0;
    for (int i = 0; i < 50; ++i) f.tick(q += speed * f.model.period());
    const double ahead = speed * kTrackDelay + 0.5 * speed * std::abs(speed) / f.brake();
    EXPECT_NEAR(f.obeyed(), q + ahead, 1e-9);
    EXPECT_NEAR(f.track.if_braked(kTracked, speed).rest(), ahead, 1e-12);
  }
}

TEST(SetPointTrack, AHeldSetPointStopsAndStays) {
  TrackRig f;
  double q = 0.0;
  for (int i = 0; i < 50; ++i) f.tick(q += 0.001);
  const double rest = f.held();
  f.measured = f.state.q[kTracked];
  for (int i = 0; i < 200; ++i) {
    f.command.q[kTracked] = q += 0.001;
    f.follow(std::int64_t{1} << kTracked);
  }
  EXPECT_LT(f.held(), rest);
  EXPECT_GT(f.obeyed(), f.held()) << "let go it would run after its command";
}

TEST(SetPointTrack, AMaskHoldsUntilWhatWasSentBeforeItHasArrived) {
  TrackRig f;
  SetPointTrack late(f.model, 3, 0.0);
  const std::int64_t one = 2, other = 8;
  EXPECT_EQ(late.on_hold(), 0);
  late.follow(f.state, f.command, one);
  late.follow(f.state, f.command, other);
  EXPECT_EQ(late.on_hold(), one | other);
  late.follow(f.state, f.command, 0);
  EXPECT_EQ(late.on_hold(), one | other);
  late.follow(f.state, f.command, 0);
  EXPECT_EQ(late.on_hold(), other);
  late.follow(f.state, f.command, 0);
  EXPECT_EQ(late.on_hold(), 0);
}

TEST(SetPointTrack, RunningAfterACommandNeverLeadsPastIt) {
  TrackRig f;
  f.tick(0.0);
  f.tick(0.0);
  f.command.q[kTracked] = 0.01;
  for (int i = 0; i < 20; ++i) {
    f.follow(0);
    if (i > 0) {
      EXPECT_LE(f.obeyed(), 0.01 + 1e-12);
    }
  }
  EXPECT_NEAR(f.obeyed(), 0.01, 1e-9);
}

TEST(SetPointTrack, AFirstCommandFarFromItsJointIsNotTakenForItsSetPoint) {
  TrackRig f;
  f.command.q[kTracked] = -1.5;
  f.follow(std::int64_t{1} << kTracked);
  EXPECT_GT(f.held(), -0.11);
}

// Let go, a set-point fades back to its command over blend_s: it is known where it is on the way.
TEST(SetPointTrack, WhatIsLetGoFadesBackAsTheGateLetsIt) {
  TrackRig f;
  const double far = 0.2, period = f.model.period();
  f.tick(0.0);
  for (int i = 0; i < 200; ++i) {
    f.command.q[kTracked] = std::min(far, f.command.q[kTracked] + 0.002);
    f.follow(std::int64_t{1} << kTracked);
  }
  const int ticks = static_cast<int>(std::lround(f.model.blend_s / period));
  double last = f.track.if_held(kTracked).rest();
  for (int i = 0; i <= ticks; ++i) {
    f.follow(0);
    const Course now = f.track.if_obeyed(kTracked);
    EXPECT_GE(now.rest(), last - 1e-3) << i;
    EXPECT_LE(now.rest(), far + 1e-2) << i;
    last = now.rest();
  }
  EXPECT_NEAR(last, far, 1e-6);
}

// The course passes through where the brake comes and ends at rest, however long one waits.
TEST(SetPointTrack, ACourseEndsAtRest) {
  const Course course{0.02, -3.0, 40.0};
  EXPECT_DOUBLE_EQ(course.at(1.0, 0.0), 0.02);
  EXPECT_DOUBLE_EQ(course.at(0.5, 0.0), 0.01);
  EXPECT_NEAR(course.at(1.0, 1.0), course.rest(), 1e-12);
  EXPECT_LT(course.at(1.0, 0.05), course.at(1.0, 0.02));
}

TEST(Course, EndsAtAStopThatItWouldPass) {
  Course passes{0.1, 4.0, 8.0}, short_of_it = passes, beyond{0.3, 4.0, 8.0}, away{-0.1, 2.0, 8.0};
  passes.keep_between(-1.0, 0.5);
  EXPECT_NEAR(passes.rest(), 0.5, 1e-12);
  EXPECT_EQ(passes.first, 0.1);
  short_of_it.keep_between(-1.0, 1.2);
  EXPECT_EQ(short_of_it.brake, 8.0);
  beyond.keep_between(-1.0, 0.2);
  EXPECT_EQ(beyond.rest(), 0.2);
  away.keep_between(-0.05, 0.5);  // it is there, and comes back
  EXPECT_NEAR(away.rest(), -0.05 + 0.25, 1e-12);
  // Where a joint is beyond its stop the stop is not believed.
  Course lost{-0.1, -4.0, 8.0};
  lost.keep_between(0.01, 0.5);
  EXPECT_EQ(lost.rest(), -1.1);
}

}  // namespace
}  // namespace twinbus
