#include "control/set_point_track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/brake.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr std::size_t kJoint = 6;
constexpr double kDelay = 0.004;

struct Fixture {
  const Model& model = test::hrp1s();
  SetPointTrack track{model, kDelay};
  RobotState state;
  JointCommand command;
  double brake() const {
    return brake_deceleration(model.joints[static_cast<std::size_t>(model.bus_joints[kJoint])]);
  }
  // One tick: the command is obeyed at once, the joint follows.
  void tick(double q, bool held = false) {
    command.q[kJoint] = q;
    track.follow(state, command, held ? std::int64_t{1} << kJoint : 0);
    state.q[kJoint] = q;
  }
};

TEST(SetPointTrack, AJointAtRestComesToRestWhereItIs) {
  Fixture f;
  for (int i = 0; i < 3; ++i) f.tick(0.02);
  EXPECT_NEAR(f.track.rest_if_obeyed(kJoint), 0.02, 1e-9);
  EXPECT_NEAR(f.track.rest_if_held(kJoint), 0.02, 1e-9);
}

// look_ahead(v) = v delay + v |v| / (2 deceleration)
TEST(SetPointTrack, AMovingJointComesToRestAfterDelayAndBrake) {
  for (const double speed : {0.5, -0.5}) {
    Fixture f;
    double q = 0.0;
    for (int i = 0; i < 50; ++i) f.tick(q += speed * f.model.period());
    const double ahead = speed * kDelay + 0.5 * speed * std::abs(speed) / f.brake();
    EXPECT_NEAR(f.track.rest_if_obeyed(kJoint), q + ahead, 1e-9);
    EXPECT_NEAR(f.track.rest_if_braked(kJoint, q, speed), q + ahead, 1e-12);
  }
}

TEST(SetPointTrack, AHeldSetPointStopsAndStays) {
  Fixture f;
  double q = 0.0;
  for (int i = 0; i < 50; ++i) f.tick(q += 0.001);
  const double rest = f.track.rest_if_held(kJoint);
  for (int i = 0; i < 200; ++i) {
    f.command.q[kJoint] = q += 0.001;
    f.track.follow(f.state, f.command, std::int64_t{1} << kJoint);
  }
  EXPECT_LT(f.track.rest_if_held(kJoint), rest);
  EXPECT_GT(f.track.rest_if_obeyed(kJoint), f.track.rest_if_held(kJoint))
      << "let go it would run after its command";
}

TEST(SetPointTrack, RunningAfterACommandNeverLeadsPastIt) {
  Fixture f;
  f.tick(0.0);
  f.tick(0.0);
  f.command.q[kJoint] = 0.01;
  for (int i = 0; i < 20; ++i) {
    f.track.follow(f.state, f.command, 0);
    if (i > 0) {
      EXPECT_LE(f.track.rest_if_obeyed(kJoint), 0.01 + 1e-12);
    }
  }
  EXPECT_NEAR(f.track.rest_if_obeyed(kJoint), 0.01, 1e-9);
}

TEST(SetPointTrack, AFirstCommandFarFromItsJointIsNotTakenForItsSetPoint) {
  Fixture f;
  f.command.q[kJoint] = -1.5;
  f.track.follow(f.state, f.command, std::int64_t{1} << kJoint);
  EXPECT_GT(f.track.rest_if_held(kJoint), -0.11);
}

}  // namespace
}  // namespace twinbus
