// A robot that walks, sways or stands outlives a controller that dies or stands still: few instants of what bench stalls measures with many.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "launcher/run/local_stack.h"
#include "robot/description/load.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

struct Walked {
  using Settings = std::vector<std::pair<std::string, std::string>>;
  explicit Walked(const char* name, std::uint64_t seed = 3, const Settings& settings = {})
      : scene(load_scene(name)), model(load_robot("hrp1s")) {
    resolve_poses(scene, model);
    apply_seed(scene, model, seed);
    OneProcessConfig config;
    config.seed = seed;
    config.settings = settings;
    run = std::make_unique<OneProcess>(model, scene, config);
  }
  bool go(double seconds) {
    const std::int64_t end = run->ticks() + std::llround(seconds / model.period());
    while (run->ticks() < end && run->tick()) {
      const SimTruth& t = run->truth();
      led = std::max(led, run->state().plan_number);
      if (t.fell) return false;
    }
    return true;
  }
  bool stands() const {
    const SimTruth& t = run->truth();
    return t.foot_force[0][2] > 100.0F && t.foot_force[1][2] > 100.0F &&
           std::hypot(static_cast<double>(t.com_velocity[0]), static_cast<double>(t.com_velocity[1])) < 0.03;
  }
  bool said(const char* what) {
    for (std::string& sentence : run->take_sentences()) heard += sentence;
    return heard.find(what) != std::string::npos;
  }
  Scene scene;
  Model model;
  std::string heard;
  std::unique_ptr<OneProcess> run;
  std::int32_t led = 0;  // the plan that was followed
};

TEST(Stalls, AWalkingRobotWhoseControllerDiesComesToStandAndIsHeld) {
  for (const char* scene : {"walk_forward", "walk_rough", "walk_slope"}) {
    for (const double at : {4.03, 4.21, 4.39, 4.57}) {
      Walked w(scene);
      ASSERT_TRUE(w.go(at));
      w.run->stall_controller(-1.0);
      EXPECT_TRUE(w.go(1.5)) << scene << at;
      EXPECT_NE(w.led, 0);
      EXPECT_EQ(w.run->state().stop_kind, StopKind::kNone) << "held with balance for a second first";
      EXPECT_TRUE(w.go(2.0)) << scene << at;
      EXPECT_TRUE(w.stands()) << scene << at;
      EXPECT_EQ(w.run->state().stop_kind, StopKind::kHold);
      EXPECT_EQ(w.run->source().status().stop_reason, StopReason::kCommandTimeout);
    }
  }
}

// Where the slope leads down again the front foot has its toes in the air at first: the robot leans farther over it than the
// stop foresaw, and steps on.
TEST(Stalls, AStopThatIsAskedForWhereTheSlopeBeginsStands) {
  for (const double at : {14.606, 14.844, 15.262, 15.432}) {
    Walked w("walk_slope", 1);
    ASSERT_TRUE(w.go(at));
    ModeRequest stop;
    stop.mode = Mode::kStop;
    w.run->say(stop);
    EXPECT_TRUE(w.go(4.5)) << at;
    EXPECT_TRUE(w.stands()) << at;
  }
}

TEST(Stalls, AControllerThatStoodStillWalksOn) {
  for (const double stall : {0.02, 0.1, 0.2}) {
    Walked w("walk_forward");
    ASSERT_TRUE(w.go(4.1));
    w.run->stall_controller(stall);
    EXPECT_TRUE(w.go(0.5)) << stall;
    EXPECT_NE(w.led, 0);
    EXPECT_EQ(w.run->state().plan_number, 0);
    const auto before = w.run->truth().base_position;
    EXPECT_TRUE(w.go(1.5)) << stall;
    EXPECT_GT(std::abs(w.run->truth().base_position[0] - before[0]), 0.4) << "walks on";
    EXPECT_EQ(w.run->state().stop_kind, StopKind::kNone);
  }
}

TEST(Stalls, SwayAndSquatGoOnAfterAStallAndAreTakenOverByAnotherController) {
  for (const char* scene : {"sway", "squat"}) {
    for (const double stall : {0.1, 0.5, -1.0}) {
      Walked w(scene);
      ASSERT_TRUE(w.go(4.1));
      w.run->stall_controller(stall);
      EXPECT_TRUE(w.go(0.8)) << scene << stall;
      EXPECT_NE(w.led, 0) << scene << stall;
      if (stall < 0.0) w.run->restart_controller(99);
      EXPECT_TRUE(w.go(2.0)) << scene << stall;
      EXPECT_EQ(w.run->state().stop_kind, StopKind::kNone) << scene << stall;
      EXPECT_EQ(w.run->state().plan_number, 0) << scene << stall;
    }
  }
}

// Nothing moves, and nothing needs a stop: a controller that was late goes on, one that was started anew takes the robot over.
TEST(Stalls, ARobotThatStandsWaitsForALateControllerAndIsHeldWhenThereIsNone) {
  for (const char* scene : {"stand", "reach"}) {
    for (const double stall : {0.05, 0.1, 0.15, 0.2, 0.5}) {
      Walked w(scene);
      ASSERT_TRUE(w.go(2.1));
      const double before = w.run->truth().base_position[0];
      w.run->stall_controller(stall);
      EXPECT_TRUE(w.go(1.5)) << scene << stall;
      EXPECT_NE(w.led, 0) << scene << stall;
      EXPECT_TRUE(w.stands()) << scene << stall;
      EXPECT_NEAR(w.run->truth().base_position[0], before, 0.005) << scene << stall;
      EXPECT_EQ(w.run->state().stop_kind, StopKind::kNone) << scene << stall;
      EXPECT_EQ(w.run->state().plan_number, 0) << scene << stall;
      EXPECT_EQ(w.run->loop().status().mode, Mode::kBalance) << scene << stall;
    }
    Walked dies(scene);
    ASSERT_TRUE(dies.go(2.1));
    dies.run->stall_controller(-1.0);
    EXPECT_TRUE(dies.go(1.0)) << scene;
    EXPECT_EQ(dies.run->state().stop_kind, StopKind::kNone) << scene << ": somebody may come";
    EXPECT_TRUE(dies.go(1.0)) << scene;
    EXPECT_TRUE(dies.stands()) << scene;
    EXPECT_EQ(dies.run->state().stop_kind, StopKind::kHold) << scene;
    EXPECT_EQ(dies.run->source().status().stop_reason, StopReason::kCommandTimeout) << scene;
  }
}

// Of a robot that stands a stop says no more than its plan: it is held at once.
TEST(Stalls, AHoldThatIsAskedForOfAStandingRobotIsMadeAtOnce) {
  Walked w("stand");
  ASSERT_TRUE(w.go(2.1));
  StopRequest stop;
  stop.kind = StopKind::kHold;
  stop.reason = StopReason::kOperator;
  w.run->say(stop);
  EXPECT_TRUE(w.go(0.5));
  EXPECT_EQ(w.led, 0);
  EXPECT_EQ(w.run->state().stop_kind, StopKind::kHold);
}

// `stop hold` in a walk: the robot comes to stand along the plan, and is held there.
TEST(Stalls, AHoldThatIsAskedForInAWalkEndsStanding) {
  for (const double at : {4.03, 4.21, 4.39}) {
    Walked w("walk_forward");
    ASSERT_TRUE(w.go(at));
    StopRequest stop;
    stop.kind = StopKind::kHold;
    stop.reason = StopReason::kOperator;
    w.run->say(stop);
    EXPECT_TRUE(w.go(4.0)) << at;
    EXPECT_NE(w.led, 0) << at;
    EXPECT_TRUE(w.stands()) << at;
    EXPECT_EQ(w.run->state().stop_kind, StopKind::kHold) << at;
  }
}

// Half a second is too long to take the walk up again: the plan ends, and balance begins on tiles of different height, where
// torques that were kept for long tilted the robot.
TEST(Stalls, AControllerThatStoodStillForLongBalancesWhereThePlanEnds) {
  for (const char* scene : {"walk_rough", "walk_slope"}) {
    for (const double at : {4.986, 6.266, 6.982}) {
      Walked w(scene, 1);
      ASSERT_TRUE(w.go(at));
      w.run->stall_controller(0.5);
      double tilt = 0.0;
      for (int i = 0; i < 30; ++i) {
        EXPECT_TRUE(w.go(0.1)) << scene << at;
        const SimTruth& t = w.run->truth();
        const auto x = static_cast<double>(t.base_attitude[1]), y = static_cast<double>(t.base_attitude[2]);
        tilt = std::max(tilt, std::acos(std::clamp(1.0 - 2.0 * (x * x + y * y), -1.0, 1.0)));
      }
      EXPECT_TRUE(w.stands()) << scene << at;
      EXPECT_LT(tilt, 0.17) << scene << at;
      EXPECT_EQ(w.run->state().stop_kind, StopKind::kNone);
      EXPECT_EQ(w.run->state().plan_number, 0);
    }
  }
}

// Attitude alone keeps it on its feet where the ground is flat.
TEST(Stalls, ARobotWhoseFeetFeelNothingWalksSlowlyAndOnFlatGroundOnly) {
  const Walked::Settings unfelt{{"sensor.foot_forces", "0"}};
  for (const double at : {4.03, 4.25, 4.47}) {
    Walked w("walk_forward", 3, unfelt);
    ASSERT_TRUE(w.go(at));
    EXPECT_TRUE(w.said("no force sensors"));
    const double before = w.run->truth().base_position[0];
    ASSERT_TRUE(w.go(1.2));  // two steps
    EXPECT_NEAR(w.run->truth().base_position[0] - before, 1.2 * 0.4 * 0.85, 0.05) << "two fifths of its fastest instead of 0.55 m/s";
    w.run->stall_controller(-1.0);
    EXPECT_TRUE(w.go(3.5)) << at;
    EXPECT_TRUE(w.stands()) << at;
    EXPECT_NE(w.led, 0);
  }
  Walked slope("walk_slope", 3, unfelt);
  EXPECT_TRUE(slope.go(12.0));
  EXPECT_TRUE(slope.said("the ground is not flat"));
  EXPECT_TRUE(slope.stands());

  Walked::Settings tilted = unfelt;
  tilted.emplace_back("sensor.bias.pitch", "0.05");  // as on a slope
  Walked refused("walk_forward", 3, tilted);
  EXPECT_TRUE(refused.go(3.0));
  EXPECT_TRUE(refused.said("on flat ground only"));
  EXPECT_NE(refused.run->loop().status().mode, Mode::kWalk);
}

TEST(Stalls, AnotherControllerTakesTheRobotOverWhereThePlanEnds) {
  Walked w("walk_forward");
  ASSERT_TRUE(w.go(4.1));
  w.run->stall_controller(-1.0);
  EXPECT_TRUE(w.go(0.5));
  w.run->restart_controller(99);
  EXPECT_TRUE(w.go(0.2));
  EXPECT_NE(w.run->state().plan_number, 0) << "not before";
  EXPECT_TRUE(w.go(2.0));
  EXPECT_TRUE(w.stands());
  EXPECT_EQ(w.run->state().stop_kind, StopKind::kNone);
  EXPECT_EQ(w.run->source().status().controller_id, 99);
}

}  // namespace
}  // namespace twinbus
