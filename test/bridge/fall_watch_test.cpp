// A fall in any mode latches a stop, and says what led to it.

#include "bridge/source/fall_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "bridge/source/source.h"
#include "lcmtypes/msg/messages.h"
#include "test/bridge/small_robot.h"

namespace twinbus {
namespace {

using namespace test;

Model floating() {
  Model model = small_model();
  model.floating_base = true;
  return model;
}

void tilt_to(RobotState& state, double roll) {
  state.attitude = {static_cast<float>(std::cos(0.5 * roll)), static_cast<float>(std::sin(0.5 * roll)), 0.0F, 0.0F};
}

RobotState tilted(double roll) {
  RobotState state;
  state.sensor_flags = kEncodersValid | kImuValid;
  tilt_to(state, roll);
  return state;
}

// Ticks until a fall is seen, of a robot that tilts from upright to `roll`; -1: none in 10 s.
int ticks_to_fall(FallWatch& watch, double roll, float rate, const FallContext& context) {
  (void)watch.look(tilted(0.0), context);
  (void)watch.look(tilted(0.5 * roll), context);
  RobotState state = tilted(roll);
  state.gyro[0] = rate;
  for (int i = 0; i < 5000; ++i) {
    if (watch.look(state, context)) return i;
  }
  return -1;
}

TEST(FallWatch, ARobotThatLiesHasFallenOnce) {
  const Model model = floating();
  FallWatch watch(model);
  const int still = ticks_to_fall(watch, 1.4, 0.0F, {});
  EXPECT_GT(still, 150);
  EXPECT_LT(still, 250);
  for (int i = 0; i < 5000; ++i) ASSERT_FALSE(watch.look(tilted(1.4), {})) << "told already";
  EXPECT_LT(ticks_to_fall(watch, 1.4, 3.0F, {}), 2000) << "it rolls and rolls: seen all the same";
}

TEST(FallWatch, ALeanIsNoFallAndARobotThatBeginsOnTheGroundHasNotFallen) {
  const Model model = floating();
  FallWatch watch(model);
  EXPECT_EQ(ticks_to_fall(watch, 0.6, 0.0F, {}), -1);
  FallWatch lying(model);
  for (int i = 0; i < 5000; ++i) ASSERT_FALSE(lying.look(tilted(1.5), {}));
  const Model fixed = small_model();
  FallWatch bolted(fixed);
  EXPECT_EQ(ticks_to_fall(bolted, 1.4, 0.0F, {}), -1) << "an arm on a table";
}

TEST(FallWatch, AnImuThatIsMountedTiltedSeesTheSame) {
  Model model = floating();
  model.imu.linear() = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  FallWatch watch(model);
  EXPECT_FALSE(watch.look(tilted(M_PI / 2), {}));  // upright
  int ticks = 0;
  while (ticks < 5000 && !watch.look(tilted(0.0), {})) ++ticks;
  EXPECT_LT(ticks, 250);
}

TEST(FallWatch, ARobotThatNobodySteersHasFallenAsSoonAsItTiltsTooFar) {
  const Model model = floating();
  FallWatch watch(model);
  EXPECT_EQ(ticks_to_fall(watch, 0.8, 3.0F, {.stop = StopKind::kHold, .reason = StopReason::kCommandTimeout}), 0);
  EXPECT_EQ(ticks_to_fall(watch, 0.8, 3.0F, {.plan_runs = true}), 0);
  EXPECT_EQ(ticks_to_fall(watch, 0.6, 3.0F, {.stop = StopKind::kHold}), -1);
  EXPECT_GT(ticks_to_fall(watch, 0.8, 3.0F, {.stop = StopKind::kBalanced}), 1000) << "its controller braces it";
}

TEST(FallWatch, TheCauseIsWhatWasSoWhenItBeganToTilt) {
  const Model model = floating();
  const auto cause = [&](const FallContext& context) {
    FallWatch watch(model);
    EXPECT_GE(ticks_to_fall(watch, 1.4, 0.0F, context), 0);
    return std::string(watch.cause().data());
  };
  EXPECT_NE(cause({.mode = Mode::kIdle, .mode_age = 0.8}).find("0.8 s after it went into mode idle"), std::string::npos);
  EXPECT_NE(cause({.mode = Mode::kWalk, .mode_age = 30.0}).find("in mode walk, by a push"), std::string::npos);
  EXPECT_NE(cause({.mode = Mode::kBalance, .stop = StopKind::kHold, .reason = StopReason::kOperator})
                .find("after stop 'hold' by the operator"),
            std::string::npos);
  EXPECT_NE(cause({.mode = Mode::kWalk, .silent = 0.6}).find("no command came for 600 ms"), std::string::npos);
  EXPECT_NE(cause({.mode = Mode::kWalk, .silent = 0.6, .slept = 0.6}).find("no time on its processor for 600 ms"),
            std::string::npos);
}

TEST(FallWatch, APushThatFellsIsTheCauseAndLateCommandsFollowIt) {
  Model model = floating();
  for (Link& link : model.links) link.mass = 10.0;
  const auto cause = [&](double force, int ticks_before, const FallContext& context) {
    FallWatch watch(model);
    SimTruth truth;
    const auto ticks = [&](int count) {
      for (int i = 0; i < count; ++i) {
        watch.see_push(&truth);
        (void)watch.look(tilted(0.0), context);
      }
    };
    truth.push_force = {0.0F, static_cast<float>(-force), 0.0F};
    ticks(100);
    truth.push_force = {};
    ticks(ticks_before);
    EXPECT_GE(ticks_to_fall(watch, 1.4, 0.0F, context), 0);
    return std::string(watch.cause().data());
  };
  const FallContext late{.mode = Mode::kBalance, .mode_age = 30.0, .silent = 0.06};
  EXPECT_EQ(cause(400.0, 250, late),
            "the robot has fallen: it was pushed with 400 N, until 0.5 s before it tilted; no command came for 60 ms");
  FallContext plan = late;
  plan.plan_runs = true;
  EXPECT_NE(cause(400.0, 250, plan).find("pushed with 400 N"), std::string::npos);
  EXPECT_NE(cause(400.0, 250, {.mode = Mode::kBalance, .slept = 0.2}).find("pushed with 400 N"), std::string::npos);
  EXPECT_NE(cause(400.0, 2500, {.mode = Mode::kBalance, .mode_age = 30.0, .silent = 0.6}).find("no command came for 600 ms"),
            std::string::npos) << "long over";
  EXPECT_NE(cause(0.5, 250, {.mode = Mode::kBalance, .mode_age = 30.0, .silent = 0.6}).find(": no command came for 600 ms"),
            std::string::npos) << "nobody felt it";
  // A push that nobody measured: a silence that the controller rides out is told, but is not the cause.
  FallWatch unseen(model);
  EXPECT_GE(ticks_to_fall(unseen, 1.4, 0.0F, late), 0);
  EXPECT_STREQ(unseen.cause().data(),
               "the robot has fallen: in mode balance, by a push or by what it stands on; no command came for 60 ms");
}

class LeaningRobot : public PointRobot {
 public:
  Status read(RobotState& state, double timeout) override {
    const Status status = PointRobot::read(state, timeout);
    state.sensor_flags |= kImuValid;
    tilt_to(state, roll);
    return status;
  }
  double roll = 0.0;
};

// No controller at all: whatever it did would not matter.
TEST(FallWatch, AFallLatchesStopOffWithAReasonOfItsOwnAndAClearObeysAgain) {
  const Model model = floating();
  LeaningRobot robot;
  SourceConfig config;
  config.pace = Pace::kFreeRun;
  Source source(model, robot, config);
  std::int64_t now = 10'000 * kMs;
  const auto run = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      now += kPeriodNs;
      source.begin_tick(now);
      source.on_command(command_for(source.state()), now);
      source.end_tick(now + kPeriodNs / 2);
    }
  };
  SourceRequest r;
  r.sender_id = 5;
  r.sequence = 1;
  r.action = SourceAction::kActivate;
  r.target_run_id = 1;
  run(1);
  source.on_source_request(r, now);
  run(100);
  ASSERT_EQ(source.state().role, Role::kActive);
  robot.roll = 1.4;
  run(100);
  EXPECT_EQ(source.status().stop_kind, StopKind::kNone) << "it still falls";
  run(400);
  EXPECT_EQ(source.state().stop_kind, StopKind::kOff);
  EXPECT_EQ(source.status().stop_reason, StopReason::kFallen);
  EXPECT_EQ(robot.written.kp[0], 0.0F) << "let go";
  std::array<char, 200> cause{};
  EXPECT_TRUE(source.take_fall(cause));
  EXPECT_NE(std::string(cause.data()).find("fallen"), std::string::npos);
  EXPECT_FALSE(source.take_fall(cause)) << "told once";

  robot.roll = 0.0;
  StopRequest clear;
  clear.stop_nonce = source.state().stop_nonce;
  source.on_stop(clear, now);
  run(1000);
  EXPECT_EQ(source.state().role, Role::kActive) << "on its feet again, and it obeys";
}

}  // namespace
}  // namespace twinbus
