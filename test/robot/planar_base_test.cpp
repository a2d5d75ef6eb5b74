#include <gtest/gtest.h>

#include "common/math/index.h"
#include "fixtures.h"
#include "robot/description/named_hands.h"
#include "test/carried_arms.h"

namespace twinbus::test {
namespace {

const std::vector<std::string> kBase{"base_x", "base_y", "base_yaw"};

std::vector<std::string> names(const Model& model, const std::vector<int>& joints) {
  std::vector<std::string> found;
  for (const int j : joints) found.push_back(model.joints[at(j)].name);
  return found;
}

TEST(PlanarBase, ThreeJointsMoveTheRootOnThePlane) {
  const Model model = carried_arms(true);
  ASSERT_EQ(names(model, model.plane_joints), kBase);
  EXPECT_FALSE(model.floating_base);
  Configuration c(model);
  c.q[model.plane_joints[0]] = 1.0;
  c.q[model.plane_joints[1]] = -0.5;
  c.q[model.plane_joints[2]] = 0.5;
  Kinematics k(model);
  k.update(c);
  const Eigen::Isometry3d& trolley = k.link_in_world(model.find_link("trolley"));
  EXPECT_NEAR(trolley.translation().x(), 1.0, 1e-12);
  EXPECT_NEAR(trolley.translation().y(), -0.5, 1e-12);
  EXPECT_NEAR(trolley.translation().z(), 0.002, 1e-12) << "its wheels do not rub";
  EXPECT_NEAR(trolley.linear()(1, 0), std::sin(0.5), 1e-12);
  for (const int j : model.plane_joints) {
    const Joint& joint = model.joints[at(j)];
    EXPECT_GT(joint.kp, 0.0);
    EXPECT_GE(model.bus_index[at(j)], 0);
    EXPECT_EQ(joint.velocity, joint.name == "base_yaw" ? 1.0 : 0.5);
    EXPECT_EQ(joint.kind, joint.name == "base_yaw" ? JointKind::kContinuous : JointKind::kPrismatic);
  }
  for (const Hand& hand : model.hands)
    EXPECT_EQ(names(model, hand.carriers), (std::vector<std::string>{"base_x", "base_y", "base_yaw", "lift"}));
}

// A log carries the texts, and who reads them loads them again.
TEST(PlanarBase, IsAddedOnce) {
  const Model once = carried_arms(true);
  const Model again = load_robot_texts({.folder = ".", .yaml = once.yaml_text, .urdf = once.urdf_text, .srdf = once.srdf_text});
  EXPECT_EQ(again.urdf_text, once.urdf_text);
  EXPECT_EQ(again.hash, once.hash);
  EXPECT_NE(carried_arms(false).hash, once.hash);
}

TEST(PlanarBase, ItsAreaAndSpeedsAreThoseOfTheFile) {
  const Model model = load_robot_texts({.folder = ".", .yaml = "urdf: a.urdf\nbase: planar\nplanar: {area: 7, speed: 0.2, turn_speed: 0.4, height: 0.1}\n",
                                        .urdf = carried_arms_urdf(), .srdf = ""});
  const Joint& x = model.joints[at(model.plane_joints[0])];
  EXPECT_EQ(x.upper, 7.0);
  EXPECT_EQ(x.lower, -7.0);
  EXPECT_EQ(x.velocity, 0.2);
  EXPECT_EQ(model.joints[at(model.plane_joints[2])].velocity, 0.4);
  EXPECT_EQ(model.joints[at(model.plane_joints[2])].placement.translation().z(), 0.1);
}

TEST(PlanarBase, WhatDoesNotFitIsRefusedWithItsPlace) {
  const auto error = [](const std::string& yaml, std::string urdf = carried_arms_urdf()) {
    return error_of([&] { (void)load_robot_texts({.folder = ".", .yaml = "urdf: a.urdf\n" + yaml, .urdf = urdf, .srdf = ""}); });
  };
  EXPECT_NE(error("base: fixed\nplanar: {area: 1}\n").find("robot.yaml:3"), std::string::npos);
  EXPECT_NE(error("base: planar\nplanar: {aera: 1}\n").find("area"), std::string::npos);
  EXPECT_NE(error("base: planar\nsoles: {left: {frame: trolley, front: 0.1, back: 0.1, left: 0.1, right: 0.1, stiffness: 1e5, damping: 100, friction: 0.8}}\n")
                .find("soles"), std::string::npos);
  const std::string hand = "hands: {right: {frame: right_hand, joints: [right_elbow_pitch], carried_by: [";
  EXPECT_NE(error("base: fixed\n" + hand + "left_elbow_pitch]}}\n").find("does not hang on joint left_elbow_pitch"), std::string::npos);
  EXPECT_NE(error("base: fixed\n" + hand + "lfit]}}\n").find("lift"), std::string::npos);
  std::string taken = carried_arms_urdf();
  taken.replace(taken.find("name='lift'"), 11, "name='base_x'");
  const std::string why = error("base: planar\n", taken);
  EXPECT_NE(why.find("a.urdf:4"), std::string::npos) << why;
  EXPECT_NE(why.find("joint base_x"), std::string::npos) << why;
}

// The last joint of an arm as if it were a finger.
TEST(NamedArms, HaveGrippersByTheirNames) {
  const Model model = three_arms();
  const auto with = [&](const std::string& gripper) {
    return load_robot_texts({.folder = ".", .yaml = model.yaml_text + "grippers:\n  " + gripper + "\n", .urdf = model.urdf_text, .srdf = ""});
  };
  const Model grips = with("north: {joints: [north_elbow], open: [1.5], closed: [-0.5]}");
  const Gripper gripper = gripper_of(grips, *hand_called(grips, "north"));
  EXPECT_EQ(gripper.joints, std::vector<int>{grips.find_joint("north_elbow")});
  EXPECT_EQ(gripper.open, std::vector<double>{1.5});
  EXPECT_TRUE(gripper_of(grips, grips.more_hands[0]).joints.empty() && grips.grippers[0].joints.empty());
  for (const std::string name : {"nroth", "left"}) {
    const std::string why = error_of([&] { (void)with(name + ": {joints: [north_elbow], open: [1.5], closed: [-0.5]}"); });
    EXPECT_NE(why.find(name), std::string::npos) << why;
    EXPECT_NE(why.find("is of a hand that is not under `hands`"), std::string::npos) << why;
  }
}

TEST(NamedArms, HaveTheNamesAndNumbersOfTheFile) {
  const Model model = three_arms();
  ASSERT_EQ(model.more_hands.size(), 3U);
  EXPECT_EQ(model.more_hands[1].name, "north");
  EXPECT_EQ(hands_of(model).size(), 3U);
  EXPECT_EQ(hand_of(model, 0), &model.more_hands[0]) << "left and right of a robot with neither";
  EXPECT_EQ(hand_of(model, 3), &model.more_hands[1]);
  EXPECT_EQ(hand_of(model, 5), nullptr);
  for (int i = 2; i < 5; ++i) EXPECT_EQ(number_of(model, *hand_of(model, i)), i);
  EXPECT_EQ(number_of(hrp1s(), hrp1s().hands[1]), 1);
  EXPECT_EQ(hand_of(hrp1s(), 2), nullptr);
  EXPECT_EQ(hand_called(model, "north"), &model.more_hands[1]);
  EXPECT_EQ(hand_called(model, "right"), &model.more_hands[0]) << "as hand_of";
  EXPECT_EQ(hand_called(model, "nroth"), nullptr);
  EXPECT_EQ(hand_names(model), "east, north, west");
  EXPECT_EQ(hand_called(hrp1s(), "right"), &hrp1s().hands[1]);
  EXPECT_EQ(hand_called(hrp1s(), ""), nullptr);
  EXPECT_EQ(hand_names(hrp1s()), "left, right");
  std::string many = model.yaml_text;
  for (int i = 0; i < 4; ++i) many += formatted("  more_%d: {frame: post, joints: [west_turn]}\n", i);
  const std::string why = error_of([&] { (void)load_robot_texts({.folder = ".", .yaml = many, .urdf = model.urdf_text, .srdf = ""}); });
  EXPECT_NE(why.find("more_3"), std::string::npos) << why;
  EXPECT_NE(why.find("one too many"), std::string::npos) << why;
}

TEST(PlanarBase, AProposalSaysLiftAndPlane) {
  UrdfRepairs repairs;
  const Model bare = load_repaired_urdf(carried_arms_urdf(), "carried_arms.urdf", {}, repairs);
  const Proposal planar = carried_arms_proposal(bare, true), still = carried_arms_proposal(bare, false);
  EXPECT_NE(planar.yaml.find("\nbase: planar\n"), std::string::npos) << planar.yaml;
  EXPECT_NE(planar.yaml.find("height: 0.0020"), std::string::npos) << planar.yaml;
  EXPECT_NE(planar.yaml.find("carried_by: [lift]"), std::string::npos) << planar.yaml;
  EXPECT_NE(still.yaml.find("\nbase: fixed\n"), std::string::npos);
  EXPECT_EQ(still.yaml.find("planar"), std::string::npos);
  EXPECT_NE(still.yaml.find("carried_by: [lift]"), std::string::npos);
}

}  // namespace
}  // namespace twinbus::test
