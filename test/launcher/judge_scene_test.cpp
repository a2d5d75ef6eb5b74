#include "launcher/run/judge_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/description/load.h"

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
  model.soles = {};
  const Criteria none = for_robot(asked, model);
  EXPECT_TRUE(std::isnan(none.zmp_margin_p5_mm) && std::isnan(none.zmp_margin_min_mm) && std::isnan(none.slip_max_mm));
}

}  // namespace
}  // namespace twinbus
