// What steps are off is said in the step in which it becomes too much, and nothing is said of what is right; parts of steps that are
// chosen by it.

#include "sim/engine/local_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "both_engines.h"
#include "common/allocation/no_alloc.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/articulated_world.h"
#include "sim/step_watch.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

const double kAllowed = WorldConfig{}.accuracy;

TWINBUS_BOTH_ENGINES(LocalErrorTest);

// A box slides at 2 m/s until friction stops it: of a step h it comes to rest h / 2 times its speed off.
WorldConfig sliding(double step, double friction) {
  WorldConfig config;
  config.step = step;
  config.fixed_base = true;
  config.ground_friction = friction;
  LooseBody box;
  box.name = "box";
  box.solid.size << 0.4, 0.4, 0.02;
  box.friction = friction;
  box.stiffness = 1e6;
  box.damping = 1e3;
  box.start.pose.translation().z() = 0.01 - kGravity / 4e6;
  box.start.velocity.x() = 2.0;
  config.loose = {box};
  return config;
}

// Until which step nothing was wrong by 5 mm, and until which nothing was said; the steps of half a second if it never was.
struct Slide {
  int wrong, said;
  double most;  // error at the end [m]
};
Slide slide(const Model& model, const WorldConfig& config) {
  const auto world = make_world(model, config);
  EXPECT_EQ(world->set(Configuration(model)), Status::kOk);
  StepWatch watch(model, config, 0);
  watch.begin(*world);
  const int steps = static_cast<int>(std::lround(0.5 / config.step));
  const double brake = config.ground_friction * kGravity;
  Slide found{steps, steps, 0.0};
  for (int i = 0; i < steps; ++i) {
    const double t = config.step * (i + 1), until = std::min(t, 2.0 / brake);
    EXPECT_EQ(watch.step(*world, t), Status::kOk);
    found.most = std::abs(world->loose(0).pose.translation().x() - (2.0 * until - 0.5 * brake * until * until));
    if (found.wrong == steps && found.most > 5e-3) found.wrong = i;
    if (found.said == steps && watch.counts().steps[static_cast<std::size_t>(Doubt::kCoarse)] > 0) found.said = i;
  }
  return found;
}

TEST_P(LocalErrorTest, ACoarseStepIsDoubtedInTheStepThatMakesItWrongAndAFineOneNever) {
  const Model model = test::bystander();
  for (const double friction : {0.8, 3.0}) {
    for (const double step : {5e-4, 0.02, 0.05}) {
      WorldConfig config = sliding(step, friction);
      config.engine = GetParam();
      const Slide found = slide(model, config);
      const int steps = static_cast<int>(std::lround(0.5 / step));
      EXPECT_EQ(found.wrong < steps, step > 0.01) << friction << " " << step << " " << found.most;
      EXPECT_EQ(found.said < steps, step > 0.01) << friction << " " << step;
      EXPECT_LE(found.said, found.wrong) << friction << " " << step;
    }
  }
}

TEST(LocalError, OfAHigherOrderLessIsOff) {
  const Model model = test::bystander();
  WorldConfig config = sliding(0.01, 0.8);
  EXPECT_LT(slide(model, config).said, 50);
  config.order = 2;
  const Slide found = slide(model, config);
  EXPECT_EQ(found.said, 50);
  EXPECT_LT(found.most, 2e-3);
}

TEST(LocalError, AWheelThatTurnsEvenlyIsNotOff) {
  LocalError error(1, 0, WorldConfig{});
  const auto at = [](double angle) { return std::vector<Eigen::Vector3d>{{3.0 * std::cos(angle), 3.0 * std::sin(angle), 0.0}}; };
  const std::vector<Eigen::Vector3d> own{{3.0, 0.0, 0.0}};
  error.begin(at(0.0), own);
  for (int i = 1; i < 1000; ++i) EXPECT_FALSE(error.add(at(0.1 * i), own, false));
  EXPECT_LT(error.most(), 1e-12);
  EXPECT_TRUE(error.add({{0.0, 3.0, 0.0}}, {{0.0, 3.0, 0.0}}, false));  // 4 m/s in a step of 2 ms
}

// Of order 2 a long free chain is wrong by 50 mm where the sums are a fiftieth of one.
TEST(LocalError, AMechanismThatNothingTouchesIsAllowedLessTheLongerItIs) {
  for (const int links : {2, 10, 100}) {
    WorldConfig config;
    config.order = 2;
    config.step = 0.006;
    const auto n = static_cast<std::size_t>(links);
    for (const bool touched : {true, false}) {
      LocalError error(n, 0, config);
      std::vector<Eigen::Vector3d> v(n, Eigen::Vector3d::Zero());
      error.begin(v, v);
      bool said = false;
      for (int i = 1; i < 100000 && !said; ++i) {
        v[0].x() = i % 2 == 0 ? 1e-4 : 0.0;
        said = error.add(v, v, touched);
      }
      ASSERT_TRUE(said);
      EXPECT_NEAR(error.most(), touched ? kAllowed : kAllowed / std::max(10, links), 1e-6);
    }
  }
}

// A run whose error was measured is doubted beyond what its own steps added up to.
TEST(LocalError, TheBandIsTheLeastLimitThatDoubtsNoStep) {
  double band = 0.0;
  const auto doubted = [&](double asked, double allowed, bool touched) {
    WorldConfig config;
    config.order = 2;
    config.step = 0.006;
    config.accuracy = asked;
    config.bands.off = allowed;
    LocalError error(3, 1, config);
    std::vector<Eigen::Vector3d> v(4, Eigen::Vector3d::Zero()), own(3, Eigen::Vector3d::Zero());
    error.begin(v, own);
    int count = 0;
    for (int i = 1; i < 2000; ++i) {
      own[0].x() = v[0].x() = i % 2 == 0 ? 1e-3 : 0.0;
      count += error.add(v, own, touched) ? 1 : 0;
    }
    band = error.band();
    return count;
  };
  for (const bool touched : {true, false}) {
    EXPECT_GT(doubted(1e-4, 0.0, touched), 0);
    const double measured = band;
    EXPECT_EQ(doubted(1e-4, measured, touched), 0);
    EXPECT_GT(doubted(1e-4, 0.99 * measured, touched), 0);
    EXPECT_EQ(doubted(measured, 0.0, touched), 0);
  }
}

TEST(LocalError, ADrivenWorldIsWatchedFromCommandToCommandAndBackAtRestItIsRight) {
  WorldConfig config;
  config.step = 0.01;
  config.accuracy = 5e-3;
  LocalError error(1, 1, config);
  std::vector<Eigen::Vector3d> v(2, Eigen::Vector3d::Zero()), own(1, Eigen::Vector3d::Zero());
  error.begin(v, own);
  const auto go = [&](double speed) {
    v[0].x() = v[1].y() = speed;
    own[0] = v[0];
    error.driven();
    return error.add(v, own, true);
  };
  for (int i = 1; i <= 9; ++i) EXPECT_FALSE(go(0.1 * i)) << i;
  EXPECT_TRUE(go(1.01));
  EXPECT_NEAR(error.most(), 0.5 * config.step * 1.01, 1e-12);
  EXPECT_FALSE(go(0.0));  // as far ahead as it was behind
  EXPECT_NEAR(error.most(), 0.0, 1e-12);
}

TEST(LocalError, OfAHigherOrderWhatADrivenWorldIsOffFades) {
  WorldConfig config;
  config.step = 0.01;
  config.order = 2;
  LocalError error(0, 1, config);
  std::vector<Eigen::Vector3d> v{Eigen::Vector3d::Zero()};
  error.begin(v, {});
  double most = 0.0;
  for (int i = 1; i <= 2000; ++i) {
    error.driven();
    v[0].x() = i % 2 == 0 ? 1e-3 : 0.0;
    EXPECT_FALSE(error.add(v, {}, true));
    most = error.most();
  }
  EXPECT_NEAR(most, 3.0 / config.step * config.step / 6.0 * 2e-3, 1e-5);  // as much fades as comes
}

TEST(LocalError, WhatFallsFreelyIsNotOff) {
  WorldConfig config;
  config.step = 0.02;
  for (const Engine engine : {Engine::kArticulated, Engine::kOde}) {
    config.engine = engine;
    LocalError error(0, 1, config);
    std::vector<Eigen::Vector3d> v{{1.0, 2.0, 0.0}};
    error.begin(v, {});
    bool said = false;
    for (int i = 1; i <= 100; ++i) {
      v[0].z() = -kGravity * config.step * i;
      said = error.add(v, {}, false) || said;
    }
    EXPECT_EQ(said, engine == Engine::kOde);
    v[0].z() = 0.0;  // it strikes the ground
    EXPECT_TRUE(error.add(v, {}, false));
  }
}

constexpr double kFall = 1.0;

// A tilted brick that falls from half a metre, and bounces.
WorldConfig falls(double step, int order, double local) {
  WorldConfig config = test::stepped(step, order);
  config.local_error = local;
  Eigen::Isometry3d start = Eigen::Isometry3d::Identity();
  start.translation().z() = 0.5;
  start.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d(0.3, 1.0, 0.2).normalized()).toRotationMatrix();
  config.loose = {test::loose_box("brick", 2.0, {0.2, 0.1, 0.06}, start, 1e5, 60.0)};
  return config;
}

struct Fall {
  std::vector<Eigen::Vector3d> at;  // every 20 ms
  double work = 0.0;                // [solves]
};

Fall fall(const WorldConfig& config) {
  ArticulatedWorld world(test::bystander(), config);
  EXPECT_EQ(world.set(Configuration(test::bystander())), Status::kOk);
  Fall fall;
  const long steps = std::lround(kFall / config.step), every = std::lround(0.02 / config.step);
  for (long i = 1; i <= steps; ++i) {
    EXPECT_EQ(world.step(), Status::kOk);
    if (i % every == 0) fall.at.push_back(world.loose(0).pose.translation());
  }
  fall.work = world.work();
  return fall;
}

double apart(const Fall& a, const Fall& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.at.size(); ++i) most = std::max(most, (a.at[i] - b.at[i]).norm());
  return most;
}

TEST(LocalParts, AFallIsSteppedCoarselyAndItsImpactFinely) {
  const Fall converged = fall(falls(1e-5, 3, 0.0));
  double before = 1.0;
  for (const double local : {10.0, 3.0, 0.3}) {
    const Fall parts = fall(falls(2e-3, 3, local));
    const double off = apart(parts, converged);
    EXPECT_LT(off, before);
    before = off;
    // No fixed step that is as near takes as little work.
    int nearer = 0;
    for (const int order : {2, 3}) {
      for (const double step : {2e-3, 1e-3, 5e-4, 2e-4, 1e-4}) {
        const Fall fixed = fall(falls(step, order, 0.0));
        if (!(apart(fixed, converged) <= off)) continue;
        ++nearer;
        EXPECT_GT(fixed.work, (local < 1.0 ? 4.0 : 1.0) * parts.work) << local << " against order " << order << " at " << step;
      }
    }
    EXPECT_GT(nearer, 0);
  }
  EXPECT_LT(before, 6e-4);
}

// Where the error asked for is never reached, nothing is divided that is smooth.
TEST(LocalParts, AnErrorThatIsWideAllowsWholeSteps) {
  WorldConfig wide = falls(2e-3, 2, 1e3);
  wide.loose[0].start.pose.translation().z() = 8.0;  // it does not land
  WorldConfig whole = wide;
  whole.local_error = 0.0;
  const Fall a = fall(wide), b = fall(whole);
  EXPECT_LE(a.work, b.work * (1.0 + 1e-9));
  EXPECT_EQ(apart(a, b), 0.0);
}

// Links that may touch one another keep the robot in the one solve of all.
TEST(LocalParts, ARobotThatStandsIsNotDividedForWhatFallsBesideIt) {
  const Model model = test::block();
  double work[2], height[2];
  Eigen::Vector3d brick[2];
  for (const bool together : {false, true}) {
    WorldConfig config = falls(2e-3, 3, 0.3);
    config.self_contact = together;
    config.loose[0].start.pose.translation().x() = 1.0;
    ArticulatedWorld world(model, config);
    ASSERT_EQ(world.set(test::standing_block(model)), Status::kOk);
    ASSERT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 100, .kd = 10}), Status::kOk);
    test::step_without_allocation(world, 300);  // meanwhile it has come down
    work[together] = world.work();
    height[together] = world.link_in_world(0).translation().z();
    brick[together] = world.loose(0).pose.translation();
  }
  EXPECT_LT(work[0], 0.8 * work[1]);
  EXPECT_NEAR(height[0], height[1], 1e-6);
  EXPECT_LT((brick[0] - brick[1]).norm(), 1e-4);
}

TEST(LocalParts, ARunRepeatsItselfAndAllocatesNothing) {
  const WorldConfig config = falls(2e-3, 3, 0.3);
  EXPECT_EQ(apart(fall(config), fall(config)), 0.0);
  ArticulatedWorld world(test::bystander(), config);
  ASSERT_EQ(world.set(Configuration(test::bystander())), Status::kOk);
  test::step_without_allocation(world, 300);
}

TEST(LocalParts, WhatCannotHaveThemIsRefused) {
  WorldConfig config = falls(2e-3, 1, 0.3);
  EXPECT_THROW((void)make_world(test::bystander(), config), std::runtime_error);
  config.order = 2;
  EXPECT_NO_THROW((void)make_world(test::bystander(), config));
  config.engine = Engine::kOde;
  EXPECT_THROW((void)make_world(test::bystander(), config), std::runtime_error);
}

}  // namespace
}  // namespace twinbus
