#include "sim/scene/scene_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "robot/description/load.h"
#include "sim/scene/arm_places.h"

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
  if (!(small.walking.fastest > 0.0)) small.walking.fastest = 0.4;
  return small;
}

TEST(SceneScale, SpeedsLengthsAndImpulsesFitTheRobot) {
  const Model own = load_robot("hrp1s"), small = half_as_long(own);
  ASSERT_NEAR(leg_length_of(small), 0.5 * leg_length_of(own), 1e-6);
  Scene walk = load_scene("walk_forward"), push = load_scene("push_forward"), steps = load_scene("walk_steps");
  scale_between(walk, own, small);
  EXPECT_LE(walk.walks[0].request.vx, 0.55 * std::sqrt(0.5) + 1e-6);
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
  EXPECT_NEAR(steps.steps[0].request.x[0], 0.075, 1e-6);
}

TEST(SceneScale, WhatAHandGripsFromTheStartLiesInThisRobotsHand) {
  const Model own = load_robot("hrp1s"), small = half_as_long(own);
  const Scene before = load_scene("carry_box");
  Scene scene = before;
  scale_between(scene, own, small);
  const Eigen::Vector3d shift = scene.loose[0].start.pose.translation() - before.loose[0].start.pose.translation();
  EXPECT_LT(shift.y(), -0.1) << "its arms are nearer to the middle";
  EXPECT_LT(shift.z(), -0.1) << "and lower";
  EXPECT_NEAR(scene.loose[0].mass, 0.125 * before.loose[0].mass, 1e-9);
  EXPECT_NEAR(scene.criteria.loose[0].position.y(), before.criteria.loose[0].position.y() + shift.y(), 1e-9);
  EXPECT_EQ(scene.criteria.loose[0].position.z(), before.criteria.loose[0].position.z()) << "on the ground, as before";
  EXPECT_LT(scene.modes[1].request.amplitude, before.modes[1].request.amplitude) << "it sways less";
}

TEST(SceneScale, NothingGrowsAndOwnScenesStay) {
  const Model own = load_robot("hrp1s");
  Scene walk = load_scene("walk_forward");
  scale_between(walk, half_as_long(own), own);  // written for a smaller one
  EXPECT_EQ(walk.walks[0].request.vx, 0.55F);
  Scene same = load_scene("walk_forward");
  scale_to(same, own);
  EXPECT_EQ(same.walks[0].request.vx, 0.55F);
  EXPECT_TRUE(same.scaled.empty());
}

// An arm of 0.7 m on a column: pan, shoulder, elbow, wrist, and a roll along the hand.  Its links weigh 0.5 kg each.
Model arm_on_column(double pan, double effort) {
  Model model;
  model.name = "arm";
  model.floating_base = false;
  model.links.resize(1);
  model.links[0].name = "column";
  const auto add = [&](const char* name, const Eigen::Vector3d& from, const Eigen::Vector3d& axis, double limit) {
    Joint joint;
    joint.name = name;
    joint.parent = model.link_count() - 1;
    joint.child = model.link_count();
    joint.placement.translation() = from;
    joint.axis = axis;
    joint.lower = -limit;
    joint.upper = limit;
    joint.velocity = 3.0;
    joint.effort = effort;
    Link& link = model.links.emplace_back();
    link.name = std::string(name) + "_link";
    link.parent = joint.parent;
    link.mass = 0.5;
    link.com = {0.1, 0.0, 0.0};
    model.hands[1].joints.push_back(static_cast<int>(model.joints.size()));
    model.joints.push_back(joint);
  };
  add("pan", {0.0, 0.0, 0.5}, Eigen::Vector3d::UnitZ(), pan);
  add("shoulder", {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitY(), 1.3);
  add("elbow", {0.3, 0.0, 0.0}, Eigen::Vector3d::UnitY(), 2.5);
  add("wrist", {0.3, 0.0, 0.0}, Eigen::Vector3d::UnitY(), 2.5);
  add("roll", {0.0, 0.0, 0.0}, Eigen::Vector3d::UnitX(), 3.0);
  model.hands[1].link = model.link_count() - 1;
  model.hands[1].frame.translation().x() = 0.1;
  return model;
}

Scene with_goals(std::initializer_list<Eigen::Vector3d> places) {
  Scene scene;
  scene.name = "places";
  scene.start_pose.clear();
  scene.in_arm_lengths = true;
  for (const Eigen::Vector3d& place : places) {
    TimedGoal& timed = scene.goals.emplace_back();
    timed.request.kind = ArmGoalKind::kPosition;
    timed.request.side = ArmSide::kRight;
    timed.request.speed = 0.5F;
    timed.of_reach = true;
    timed.reach = place;
  }
  return scene;
}

std::string refusal(Scene scene, const Model& model) {
  try {
    measure_by_arm(scene, model);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(ArmPlaces, PlacesBehindAnArmThatCannotTurnThereAreTurned) {
  const Eigen::Vector3d place(-0.3, 0.4, 0.1);
  Scene free = with_goals({place});
  measure_by_arm(free, arm_on_column(3.0, 100.0));
  EXPECT_TRUE(free.goals[0].reach.isApprox(place, 1e-9)) << "where it can, nothing is";
  EXPECT_EQ(free.scaled, "");
  Scene narrow = with_goals({place});
  measure_by_arm(narrow, arm_on_column(1.0, 100.0));
  const Eigen::Vector3d& reach = narrow.goals[0].reach;
  EXPECT_NEAR(reach.norm(), place.norm(), 1e-9);
  EXPECT_NE(narrow.scaled.find("turned"), std::string::npos) << narrow.scaled;
  EXPECT_LT(std::abs(std::atan2(reach.y(), reach.x())), 1.0);
}

TEST(ArmPlaces, AHandPointsAsItsJointsAllow) {
  Scene down = with_goals({{0.5, 0.2, 0.0}});
  down.goals[0].request.kind = ArmGoalKind::kPose;
  down.goals[0].request.orientation = {0.0, 1.0, 0.0, 0.0};
  Scene stiff = down;
  Model arm = arm_on_column(3.0, 100.0);
  measure_by_arm(down, arm);
  EXPECT_EQ(down.scaled, "");
  arm.joints[4].lower = -0.02;  // without the roll it points down, turned as the pan joint says
  arm.joints[4].upper = 0.02;
  measure_by_arm(stiff, arm);
  EXPECT_NE(stiff.scaled.find("turned about where it points"), std::string::npos) << stiff.scaled;
  const auto& [w, x, y, z] = stiff.goals[0].request.orientation;
  const Eigen::Vector3d along = Eigen::Quaterniond(w, x, y, z) * Eigen::Vector3d::UnitX();
  EXPECT_LT(along.z(), -0.999) << along.transpose();
}

TEST(ArmPlaces, WhatNoPlaceHelpsIsRefusedWithItsCause) {
  EXPECT_NE(refusal(with_goals({{1.0, 1.0, 1.0}}), arm_on_column(3.0, 100.0)).find("misses goal 1 by"), std::string::npos);
  EXPECT_NE(refusal(with_goals({{0.9, 0.0, 0.0}}), arm_on_column(3.0, 1.0)).find("goal 1"), std::string::npos);
  Scene ahead = with_goals({{0.5, 0.0, 0.0}});
  EXPECT_EQ(begins_too_heavy(ahead, arm_on_column(3.0, 100.0)), "");
  EXPECT_NE(begins_too_heavy(ahead, arm_on_column(3.0, 2.0)).find("joint shoulder needs"), std::string::npos);
}

// Stretched out it is too heavy: from above it comes back to where it began, but not down.
TEST(ArmPlaces, AWayBackThatIsTooHeavyIsNone) {
  Model arm = arm_on_column(3.0, 8.0);
  arm.poses = {{"up", {0.0, -1.3, 0.0, 0.0, 0.0}}, {"down", {0.0, 1.3, 0.0, 0.0, 0.0}}};
  Scene scene = with_goals({{0.15, 0.0, 0.85}});
  scene.start_pose = "up";
  TimedGoal& back = scene.goals.emplace_back(scene.goals[0]);
  back.request.kind = ArmGoalKind::kJoints;
  back.of_reach = false;
  back.pose = "up";
  EXPECT_EQ(refusal(scene, arm), "");
  back.pose = "down";
  EXPECT_NE(refusal(scene, arm).find("is too heavy for shoulder"), std::string::npos) << refusal(scene, arm);
}

TEST(ArmPlaces, WhatAHandHoldsIsPartOfIt) {
  Scene scene = with_goals({{0.4, 0.3, 0.2}, {0.4, -0.3, 0.2}});
  for (TimedGoal& timed : scene.goals) {
    timed.request.kind = ArmGoalKind::kPose;
    timed.request.orientation = {0.0, 1.0, 0.0, 0.0};
  }
  scene.goals[0].at = 1.0;
  scene.goals[1].at = 5.0;
  LooseBody& body = scene.loose.emplace_back();
  body.name = "box";
  body.solid.size.setConstant(0.1);
  body.start.pose.translation() = Eigen::Vector3d(0.4, 0.3, 0.0);
  Obstacle& table = scene.obstacles.emplace_back();  // below the second goal, where only what is held would touch it
  table.shape = ObstacleShape::kBox;
  table.size = {0.2, 0.2, 0.02};
  table.pose.translation() = Eigen::Vector3d(0.4, -0.3, -0.05);
  const Model arm = arm_on_column(3.0, 100.0);
  EXPECT_EQ(refusal(scene, arm), "");
  Grasp& grasp = scene.grasps.emplace_back();
  grasp.link = "right_hand";
  grasp.to = "box";
  grasp.at = 3.0;
  grasp.until = 9.0;
  Scene held = scene;
  EXPECT_NE(refusal(held, arm).find("within 12 mm at goal 2"), std::string::npos) << refusal(held, arm);
}

TEST(ArmPlaces, ALiftIsNoPartOfTheArmAndHasItsOwnTime) {
  Model model = arm_on_column(3.0, 100.0);
  const auto span_of = [](const Model& arm) { return arm_in_scene(with_goals({}), arm, arm.hands[1]); };
  const ArmSpan before = span_of(model);
  model.hands[1].joints.erase(model.hands[1].joints.begin());
  EXPECT_NEAR(span_of(model).length, before.length, 1e-9);
  Model lifted = arm_on_column(3.0, 100.0);
  lifted.joints[0].kind = JointKind::kPrismatic;
  lifted.joints[0].upper = 0.4;
  lifted.joints[0].lower = 0.0;
  lifted.joints[0].velocity = 0.1;
  lifted.joints[1].placement.translation() = Eigen::Vector3d(0.2, 0.0, 0.3);
  EXPECT_NEAR(span_of(lifted).length, before.length, 1e-9);
  EXPECT_TRUE(span_of(lifted).shoulder.isApprox(Eigen::Vector3d(0.2, 0.0, 0.8), 1e-9));
  Scene scene = with_goals({{0.5, 0.0, 0.1}});
  scene.goals[0].at = 1.0;
  scene.duration = 6.0;
  measure_by_arm(scene, lifted);
  EXPECT_NEAR(scene.duration, 6.0 * (2.0 + 0.4 / (0.1 * 0.5)) / 5.0, 1e-6);
  // A path of the planner takes 0.6 s more than its way at full speed, and the arm half a second to rest, before it counts as there.
  EXPECT_GT(scene.duration - scene.goals[0].at, 0.4 / (0.1 * 0.5) + 0.6 + 0.5 + 0.5);
}

}  // namespace
}  // namespace twinbus
