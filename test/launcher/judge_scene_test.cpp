#include "launcher/run/judge_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "launcher/run/local_stack.h"
#include "launcher/figures/walk_figures.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"

namespace twinbus {
namespace {

Scene resolved(const char* name, const Model& model) {
  Scene scene = load_scene(name);
  resolve_poses(scene, model);
  return scene;
}

TEST(SceneFit, EverySceneIsForItsOwnRobot) {
  for (const std::string& name : scene_names()) {
    const Scene scene = load_scene(name);
    const Model model = load_robot(scene.robot);
    EXPECT_EQ(why_not_for(resolved(name.c_str(), model), model), "") << name;
  }
}

// Said before the run, not by figures that are none after it.
TEST(SceneFit, WhatARobotDoesNotHaveIsSaid) {
  const Model table = load_robot("table");  // no legs, no hands
  EXPECT_NE(why_not_for(resolved("walk_forward", table), table).find("two legs"), std::string::npos);
  EXPECT_NE(why_not_for(resolved("release", table), table).find("left_ankle_pitch"), std::string::npos);
  Scene walk = load_scene("walk_forward");
  EXPECT_THROW(fit_scene(walk, table), std::runtime_error);
  Model handless = load_robot("hrp1s");
  handless.hands = {};
  Scene reach = load_scene("reach");
  reach.goals.resize(2);  // without the pose
  EXPECT_NE(why_not_for(reach, handless).find("left hand"), std::string::npos);
  EXPECT_NE(why_not_for(resolved("tied_hands", handless), handless).find("left_hand"), std::string::npos);
  EXPECT_EQ(why_scene_is_not_for(load_scene("push_left"), handless), "");
  Model arm = load_robot("hrp1s");
  arm.floating_base = false;
  EXPECT_NE(why_not_for(resolved("walk_turn", arm), arm).find("its base is fixed"), std::string::npos);
}

TEST(SceneFit, MarginsAreThoseOfTheSoles) {
  Model model = load_robot("hrp1s");
  Criteria asked;
  asked.zmp_margin_p5_mm = 30.0;
  asked.zmp_margin_min_mm = 40.0;
  asked.slip_max_mm = 2.0;
  EXPECT_EQ(for_robot(asked, model).zmp_margin_p5_mm, 30.0);
  for (Sole& sole : model.soles) sole.left = sole.right = 0.034;  // 68 mm wide
  EXPECT_NEAR(for_robot(asked, model).zmp_margin_p5_mm, 30.0 * 68.0 / 130.0, 1e-9);
  EXPECT_EQ(for_robot(asked, model).zmp_margin_min_mm, 40.0);
  EXPECT_NEAR(for_robot(asked, model, true).zmp_margin_min_mm, 40.0 * 68.0 / 130.0, 1e-9);
  asked.sole_tilt_max_deg = 0.5;
  EXPECT_NEAR(for_robot(asked, model).sole_tilt_max_deg, 0.5 * 130.0 / 68.0, 1e-9) << "its edge yields as far";
  model.soles = {};
  const Criteria none = for_robot(asked, model);
  EXPECT_TRUE(std::isnan(none.zmp_margin_p5_mm) && std::isnan(none.zmp_margin_min_mm) && std::isnan(none.slip_max_mm));
}

// An arm that begins in the ground, and one that reaches only some of its goals.
TEST(SceneFit, AnArmBeginsAboveTheGround) {
  Model model = load_robot("hrp1s");
  model.floating_base = false;
  model.soles = {};
  Scene scene = load_scene("arm_hold");
  EXPECT_NE(why_not_for(scene, model).find("mm in the ground"), std::string::npos);  // the hands hang below the waist
}

TEST(JudgeScene, GoalsThatAreNotReachedAreCounted) {
  const Model model = load_robot("hrp1s");
  Scene scene = load_scene("arm_reach");
  scene.duration = 6.0;
  fit_scene(scene, model);
  scene.goals.resize(2);
  scene.goals[1].at = 4.0;
  for (const double away : {0.0, 3.0}) {
    scene.goals[1].request.position[0] += away;
    OneProcess process(model, scene, {});
    const auto ticks = static_cast<std::int64_t>(scene.duration / model.period());
    while (process.ticks() < ticks && process.tick()) {
    }
    EXPECT_EQ(process.goals().asked(), 2);
    Criteria asked;
    asked.goals_reached_min = 2.0;
    const RunVerdict verdict = judge_scene(process, asked, ticks);
    EXPECT_EQ(verdict.passed, away == 0.0);
    if (away > 0.0) {
      const std::string& said = verdict.failures.front();
      EXPECT_NE(said.find("1 of the arm goals"), std::string::npos);
      EXPECT_NE(said.find("at least 2 were asked: goal 2 ("), std::string::npos) << said;
      EXPECT_NE(said.find("): there was no path"), std::string::npos) << said;
      EXPECT_EQ(said.find("goal 1"), std::string::npos) << said;
    }
  }
}

// Which goal, and by how much or why.
TEST(GoalWatch, KeepsEachGoalThatWasMissed) {
  const auto where = [](ArmSide) { return Eigen::Vector3d(0.0, 0.0, 0.012); };
  const Configuration now;
  ControllerStatus status;
  GoalWatch watch;
  const auto ask = [&](std::int64_t id, bool path) {
    ArmGoal goal;
    goal.goal_id = id;
    goal.side = ArmSide::kLeft;
    watch.ask(goal, path ? std::vector<int>{0} : std::vector<int>{}, Eigen::VectorXd::Zero(path ? 1 : 0));
  };
  const auto follow = [&](double time, std::int64_t id, int state) {
    status.arm_path_id = id;
    status.arm_state = static_cast<decltype(status.arm_state)>(state);
    watch.add(time, status, now, where);
  };
  ask(1, false);
  ask(2, true);
  follow(1.0, 2, 1);
  follow(2.0, 2, 2);
  follow(2.6, 2, 2);
  ask(3, true);
  follow(3.0, 3, 1);
  ask(4, true);
  const std::vector<MissedGoal> missed = watch.missed();
  ASSERT_EQ(missed.size(), 4u);
  const std::array why = {MissedGoal::Why::kNoPath, MissedGoal::Why::kOff, MissedGoal::Why::kUnderWay, MissedGoal::Why::kNotBegun};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(missed[i].number, static_cast<int>(i) + 1);
    EXPECT_EQ(missed[i].why, why[i]) << i;
  }
  EXPECT_NEAR(missed[1].off, 0.012, 1e-12);
  EXPECT_EQ(watch.reached(), 0);
}

// A robot that was proposed is asked for what its legs can, and it is said; our own are asked as ever.
TEST(SceneFit, VelocitiesAreThoseThatTheRobotCan) {
  Model model = load_robot("hrp1s");
  Scene own = load_scene("walk_pivot"), other = own, pads = load_scene("walk_pad");
  fit_scene(own, model);
  EXPECT_EQ(own.walks[0].request.wz, 0.85F);
  ASSERT_EQ(model.walking.fastest, 0.85);
  model.walking.fastest = 0.3;
  ++model.hash;  // another robot
  for (Sole& sole : model.soles) sole.left = sole.right = 0.035;
  fit_scene(other, model);
  EXPECT_LT(other.walks[0].request.wz, 0.6F);
  const double travel = pads.criteria.travel_min_m;
  fit_scene(pads, model);
  EXPECT_LT(pads.criteria.travel_min_m, 0.8 * travel);
}

RunVerdict judged(const char* name, double seconds, bool part, double max_tilt_deg = std::nan("")) {
  Scene scene = load_scene(name);
  const Model model = load_robot(scene.robot);
  fit_scene(scene, model);
  apply_seed(scene, model, 1);
  if (!std::isnan(max_tilt_deg)) scene.criteria.max_tilt_deg = max_tilt_deg;
  OneProcess process(model, scene, {});
  const std::int64_t ticks = std::llround(seconds / model.period());
  while (process.ticks() < ticks && process.tick()) {
  }
  return judge_scene(process, scene.criteria, ticks, part);
}

bool has(const std::vector<std::string>& lines, const char* words) {
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

TEST(PartOfAScene, IsJudgedByWhatCanBeJudgedAndTheRestIsNamed) {
  const RunVerdict whole = judged("walk_forward", 0.6, false);
  EXPECT_TRUE(has(whole.failures, "m from its start, at least 5.00 m")) << testing::PrintToString(whole.failures);
  const RunVerdict part = judged("walk_forward", 0.6, true);
  EXPECT_TRUE(part.passed) << testing::PrintToString(part.failures);
  EXPECT_TRUE(has(part.left_out, "how far the robot ends")) << testing::PrintToString(part.left_out);
  EXPECT_TRUE(has(part.left_out, "the velocity was ? % from the commanded one, at most ")) << testing::PrintToString(part.left_out);
  EXPECT_TRUE(has(part.left_out, " % were asked; the run ended before it could be measured")) << testing::PrintToString(part.left_out);
  const RunVerdict tilted = judged("walk_forward", 0.6, true, 0.0);
  EXPECT_FALSE(tilted.passed);
  EXPECT_TRUE(has(tilted.failures, "the base tilted"));
}

TEST(PartOfAScene, WhereLooseBodiesEndIsLeftOut) {
  const RunVerdict part = judged("bounce_wall", 0.02, true);
  EXPECT_TRUE(part.passed) << testing::PrintToString(part.failures);
  EXPECT_TRUE(has(part.left_out, "ends")) << testing::PrintToString(part.left_out);
}

// Of a robot that flew away, or of a world that is broken.
TEST(WalkFigures, AMarginThatNoMillimetresHoldIsTheFirstOrTheLast) {
  const Model model = load_robot("hrp1s");
  const Scene scene = resolved("walk_forward", model);
  const auto margin_of = [&](float margin) {
    WalkFigures figures(model, scene);
    SimTruth truth;
    truth.zmp_margin = margin;
    figures.add(truth, Mode::kWalk, {0.0, 0.0}, 0.0);
    return figures.margin_percentile(0.0);
  };
  EXPECT_NEAR(margin_of(0.0205F), 0.020, 1e-9);
  EXPECT_NEAR(margin_of(-0.0205F), -0.021, 1e-9);
  EXPECT_NEAR(margin_of(1e30F), 0.5, 1e-9);
  EXPECT_NEAR(margin_of(-1e30F), -0.5, 1e-9);
  EXPECT_NEAR(margin_of(std::numeric_limits<float>::quiet_NaN()), -0.5, 1e-9);
}

}  // namespace
}  // namespace twinbus
