#include "sim/scene/scene_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/description/load.h"

namespace twinbus {
namespace {

Model half_as_long(const Model& model) {
  Model small = model;
  for (Joint& joint : small.joints) joint.placement.translation() *= 0.5;
  for (Sole& sole : small.soles) {
    sole.frame.translation() *= 0.5;
    sole.front *= 0.5;
    sole.back *= 0.5;
  }
  for (Link& link : small.links) link.mass *= 0.125;
  small.yaml_text += small.yaml_text.find("\nwalking:") == std::string::npos ? "\nwalking: {fastest: 0.4}\n" : "";
  return small;
}

TEST(SceneScale, SpeedsLengthsAndImpulsesFitTheRobot) {
  const Model own = load_robot("hrp1s"), small = half_as_long(own);
  ASSERT_NEAR(leg_length_of(small), 0.5 * leg_length_of(own), 1e-6);
  Scene walk = load_scene("walk_forward"), push = load_scene("push_forward"), steps = load_scene("walk_steps");
  scale_between(walk, own, small);
  EXPECT_LE(walk.walks[0].command.vx, 0.55 * std::sqrt(0.5) + 1e-6);
  EXPECT_LT(walk.criteria.travel_min_m, 5.0);
  EXPECT_NE(walk.scaled.find("leg"), std::string::npos);
  scale_between(push, own, small);
  EXPECT_GT(push.pushes[0].impulse.x(), 0.0);
  EXPECT_LE(push.pushes[0].impulse.x(), 45.0 * 0.125 + 1e-9);
  Model narrow = own;
  for (Sole& sole : narrow.soles) sole.left = sole.right = 0.01;
  Scene left = load_scene("push_left"), forward = load_scene("push_forward");
  scale_between(left, own, narrow);
  scale_between(forward, own, narrow);
  EXPECT_LT(left.pushes[0].impulse.y(), 0.8 * 45.0) << "its outer edges are nearer";
  EXPECT_EQ(forward.pushes[0].impulse.x(), 45.0);
  scale_between(steps, own, small);
  EXPECT_NEAR(steps.steps[0].list.x[0], 0.075, 1e-6);
}

TEST(SceneScale, NothingGrowsAndOwnScenesStay) {
  const Model own = load_robot("hrp1s");
  Scene walk = load_scene("walk_forward");
  scale_between(walk, half_as_long(own), own);  // written for a smaller one
  EXPECT_EQ(walk.walks[0].command.vx, 0.55F);
  Scene same = load_scene("walk_forward");
  scale_to(same, own);
  EXPECT_EQ(same.walks[0].command.vx, 0.55F);
  EXPECT_TRUE(same.scaled.empty());
}

}  // namespace
}  // namespace twinbus
