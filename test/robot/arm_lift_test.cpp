#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>
#include <string>
#include <utility>

#include "fixtures.h"
#include "robot/description/load.h"
#include "robot/dynamics/gravity_load.h"
#include "robot/onboarding/anatomy.h"
#include "robot/onboarding/base_turn.h"
#include "robot/onboarding/proposal.h"

namespace twinbus {
namespace {

constexpr double kWeight = 4.0 * 0.3 * 9.80665;  // times the lever of the whole arm [N m]

// 4 kg, 0.3 m ahead of a shoulder 1 m above the ground.
Model heavy_arm(double effort) {
  Model model;
  model.floating_base = false;
  model.links.resize(2);
  model.links[1].parent = 0;
  model.links[1].mass = 4.0;
  model.links[1].com = {0.3, 0.0, 0.0};
  Joint shoulder;
  shoulder.name = "shoulder";
  shoulder.parent = 0;
  shoulder.child = 1;
  shoulder.placement.translation().z() = 1.0;
  shoulder.axis = Eigen::Vector3d::UnitY();
  shoulder.lower = -2.0;
  shoulder.upper = 2.0;
  shoulder.effort = effort;
  model.joints.push_back(shoulder);
  model.hands[1].link = 1;
  model.hands[1].joints = {0};
  return model;
}

TEST(ArmLift, WhatAJointCarriesIsAShareOfItsLimit) {
  const Model model = heavy_arm(20.0);
  Configuration there(model);
  GravityLoad load(model);
  GravityLoad::Worst worst = load.of(there, {0});
  EXPECT_EQ(worst.joint, 0);
  EXPECT_NEAR(worst.effort, kWeight, 1e-2);
  EXPECT_NEAR(worst.share, kWeight / 20.0, 1e-3);
  there.q[0] = 1.0;
  EXPECT_NEAR(load.of(there, {0}).effort, kWeight * std::cos(1.0), 1e-2);
  EXPECT_EQ(load.of(there, {}).joint, -1);
}

TEST(ArmLift, AnArmThatItsJointsCannotHoldBeginsWhereTheyCan) {
  Anatomy anatomy;
  for (const double effort : {20.0, 10.0}) {
    const Model model = heavy_arm(effort);
    anatomy.hands = model.hands;
    Eigen::VectorXd q = neutral_posture(model);
    const std::string said = lift_arms(model, anatomy, q);
    const double share = kWeight * std::cos(q[0]) / effort;
    EXPECT_LE(share, 0.8) << effort;
    EXPECT_EQ(said.empty(), effort == 20.0) << said;
    if (said.empty()) {
      EXPECT_EQ(q[0], 0.0);
    } else {
      EXPECT_GT(kWeight * std::cos(std::abs(q[0]) - 0.1) / effort, 0.8) << "no farther than it must";
    }
  }
}

// A box of 2 kg whose middle is at xyz of its link.
std::string box(const std::string& name, const std::string& size, const std::string& xyz) {
  const std::string at = "<origin xyz='" + xyz + "'/>";
  return "<link name='" + name + "'><inertial>" + at +
         "<mass value='2'/><inertia ixx='0.02' iyy='0.02' izz='0.02' ixy='0' ixz='0' iyz='0'/></inertial><collision>" + at +
         "<geometry><box size='" + size + "'/></geometry></collision></link>";
}

std::string hinge(const std::string& name, const std::string& parent, const std::string& child, const std::string& xyz,
                  const std::string& axis) {
  return "<joint name='" + name + "' type='revolute'><origin xyz='" + xyz + "'/><parent link='" + parent + "'/><child link='" + child +
         "'/><axis xyz='" + axis + "'/><limit lower='-1.5' upper='1.5' effort='90' velocity='2'/></joint>";
}

// Three boxes in a row below a shoulder, or ahead of a knuckle.
std::string limb(const std::string& name, const std::string& on, const std::string& xyz, const std::string& size, const std::string& step) {
  const std::string a = name + "_upper", b = name + "_middle", c = name + "_end";
  return box(a, size, "0 0 0") + box(b, size, "0 0 0") + box(c, size, "0 0 0") + hinge(name + "_1", on, a, xyz, "1 0 0") +
         hinge(name + "_2", a, b, step, "0 1 0") + hinge(name + "_3", b, c, step, "0 1 0");
}

Model arm_of(const std::string& text) {
  UrdfRepairs repairs;
  return load_repaired_urdf(text, "/tmp/robot.urdf", {}, repairs);
}

std::string torso(const std::string& trunk, const std::string& shoulders) {
  std::string text = "<robot name='torso'>" + trunk;
  for (const auto& [side, y] : {std::pair("left", " 0.3 "), std::pair("right", " -0.3 ")})
    text += limb(std::string(side) + "_arm", "trunk", "0" + std::string(y) + shoulders, "0.1 0.1 0.2", "0 0 -0.25");
  return text + "</robot>";
}

// Its hand 5 mm beside the trunk, four joints away.
TEST(ArmLift, AnArmThatTheRobotBoxesInBeginsClearOfIt) {
  const auto folded = [](const std::string& back) {
    return arm_of("<robot name='arm'>" + box("trunk", "0.2 0.2 0.2", "0 0 0.1") + box("upper", "0.02 0.02 0.02", "0 0 0") +
                  box("fore", "0.02 0.02 0.02", "0 0 0") + box("wrist", "0.02 0.02 0.02", "0 0 0") + box("hand", "0.1 0.1 0.1", "0 0 0") +
                  hinge("j1", "trunk", "upper", "0 0 0.4", "0 1 0") + hinge("j2", "upper", "fore", "0.3 0 0", "0 1 0") +
                  hinge("j3", "fore", "wrist", "0 0 -0.3", "0 1 0") + hinge("j4", "wrist", "hand", back + " 0 0", "0 1 0") + "</robot>");
  };
  const auto lifted = [](const Model& model) {
    Anatomy anatomy;
    anatomy.hands[1].link = 4;
    anatomy.hands[1].joints = {0, 1, 2, 3};
    Eigen::VectorXd q = neutral_posture(model);
    return lift_arms(model, anatomy, q);
  };
  EXPECT_EQ(lifted(folded("-0.1")), "");
  EXPECT_NE(lifted(folded("-0.145")).find("rad"), std::string::npos);
}

// The ground of scenes is at z = 0.
TEST(Stand, WhatReachesBelowItsBaseIsRaised) {
  const std::string above = box("trunk", "0.3 0.3 0.6", "0 0 0.3"), below = box("trunk", "0.3 0.3 1.0", "0 0 -0.4");
  EXPECT_EQ(height_of_stand(arm_of(torso(above, "0.8"))), 0.0);
  EXPECT_NEAR(height_of_stand(arm_of(torso(below, "0.1"))), 0.9, 1e-9);  // to its foot
  const std::string hangs = torso(above, "0.4");
  const double height = height_of_stand(arm_of(hangs));
  EXPECT_NEAR(height, 0.25, 1e-9);  // hands 0.2 m below the base, 0.05 m above the ground
  Eigen::Isometry3d raised = Eigen::Isometry3d::Identity();
  raised.translation().z() = height;
  const Model model = arm_of(with_root_above(hangs, "trunk", "stand", raised, "the ground is at z = 0"));
  EXPECT_EQ(model.links.front().name, "stand");
  EXPECT_EQ(height_of_stand(model), 0.0);
}

// Joints that follow others are not the arm's own.
TEST(Stand, AnArmThatOnlyFollowsTheOtherIsNoHandAndStillRaisesTheBase) {
  std::string text = torso(box("trunk", "0.3 0.3 0.6", "0 0 0.3"), "0.4");
  for (const std::string number : {"1", "2", "3"}) {
    const std::size_t joint = text.find("<joint name='right_arm_" + number + "'");
    ASSERT_NE(joint, std::string::npos);
    text.insert(text.find("</joint>", joint), "<mimic joint='left_arm_" + number + "'/>");
  }
  const Model model = arm_of(text);
  const Anatomy found = find_anatomy(model);
  EXPECT_EQ(found.hands[0].joints.size(), 3U);
  EXPECT_LT(found.hands[1].link, 0);
  EXPECT_TRUE(found.hands[1].joints.empty());
  EXPECT_NEAR(height_of_stand(model), 0.25, 1e-9);
}

TEST(Stand, TheNewLinkAndItsJointHaveNamesThatNobodyHas) {
  const auto name_beside = [](const std::string& parts) {
    return free_root_name("<robot name='stand'><link name='trunk'/>" + parts + "</robot>", "robot.urdf", "stand");
  };
  EXPECT_EQ(name_beside("<link name='stand_of_it'/>"), "stand");
  EXPECT_EQ(name_beside("<link name='stand'/>"), "stand_2");
  EXPECT_EQ(name_beside("<link name = \"stand\"/>"), "stand_2");
  EXPECT_EQ(name_beside("<joint name='stand_joint'/>"), "stand_2");
  EXPECT_EQ(name_beside("<link name='stand'/><joint name='stand_2_joint'/>"), "stand_3");
}

// As large as a hand, but for what its parts are called.
TEST(Anatomy, ASmallUpperBodyIsNoHand) {
  const auto body = [](const std::string& arm, const std::string& top) {
    const std::string size = "0.05 0.05 0.05";
    std::string text = "<robot name='body'>" + box("trunk", "0.2 0.2 0.3", "0 0 0.15");
    for (const auto& [side, xyz] : {std::pair("left_", "0 0.15 0.3"), std::pair("right_", "0 -0.15 0.3")})
      text += limb(side + arm, "trunk", xyz, size, "0 0 -0.1");
    text += box(top + "_low", size, "0 0 0") + box(top + "_high", size, "0 0 0");
    text += hinge(top + "_1", "trunk", top + "_low", "0 0 0.33", "0 0 1") +
            hinge(top + "_2", top + "_low", top + "_high", "0 0 0.1", "0 1 0");
    return find_anatomy(arm_of(text + "</robot>"));
  };
  EXPECT_LT(body("digit", "post").hands[0].link, 0);  // without names of arms or a head
  for (const auto& [arm, top] : {std::pair("arm", "neck"), std::pair("arm", "Head"), std::pair("shoulder", "post")}) {
    const Anatomy found = body(arm, top);
    for (const Hand& hand : found.hands) EXPECT_EQ(hand.joints.size(), 3U) << arm << " " << top;
  }
}

TEST(Anatomy, FingersOfAPalmAreNoArms) {
  const auto hand = [](const std::string& finger, const std::string& step) {
    std::string text = "<robot name='hand'>" + box("palm", "0.1 0.1 0.02", "0 0 0");
    for (const auto& [name, xyz] : {std::pair("1", "0.04 0.04 0"), std::pair("2", "0.04 0 0"), std::pair("3", "0.04 -0.04 0")})
      text += limb(finger + name, "palm", xyz, "0.02 0.02 0.02", step);
    return text + "</robot>";
  };
  const Anatomy found = find_anatomy(arm_of(hand("finger", "0.04 0 0")));
  EXPECT_LT(std::max(found.hands[0].link, found.hands[1].link), 0);
  ASSERT_FALSE(found.doubts.empty());
  EXPECT_EQ(found.doubts.front().find("a hand without an arm: 3 fingers on its base"), 0U) << found.doubts.front();
  ASSERT_EQ(found.more_hands.size(), 3U);
  EXPECT_EQ(found.more_hands[2].name, "finger_3");
  EXPECT_GE(found.more_hands[2].joints.size(), 2U);
  // Arms as long as people's are arms.
  const auto says_hand = [](const Anatomy& anatomy) {
    return std::any_of(anatomy.doubts.begin(), anatomy.doubts.end(), [](const std::string& d) { return d.find("hand without") != std::string::npos; });
  };
  EXPECT_FALSE(says_hand(find_anatomy(arm_of(hand("finger", "0.3 0 0")))));
  EXPECT_FALSE(says_hand(find_anatomy(arm_of(hand("leg", "0.04 0 0")))));
  EXPECT_FALSE(says_hand(find_anatomy(arm_of(torso(box("trunk", "0.3 0.3 0.6", "0 0 0.3"), "0.8")))));
}

// hrp1s with two fingers a hand that slide, proposed.
Proposal proposed_with_fingers(const char* effort, std::string& slide) {
  const Model bare = load_urdf(test::hrp1s().folder + "/hrp1s.urdf", {});
  std::string text = bare.urdf_text;
  for (const Hand& hand : find_anatomy(bare).hands) {
    const std::string& palm = bare.links[static_cast<std::size_t>(hand.link)].name;
    for (const std::string& y : {std::string("0.03"), std::string("-0.03")}) {
      const std::string finger = palm + "_finger_" + y;
      text.insert(text.rfind("</robot>"),
                  "<link name='" + finger + "'><inertial><mass value='0.1'/><inertia ixx='1e-4' iyy='1e-4' izz='1e-4' ixy='0' ixz='0' "
                  "iyz='0'/></inertial><collision><geometry><box size='0.02 0.02 0.12'/></geometry></collision></link>"
                  "<joint name='" + finger + "_slide' type='prismatic'><origin xyz='0 " + y + " -0.1'/><parent link='" + palm +
                  "'/><child link='" + finger + "'/><axis xyz='0 1 0'/><limit lower='0' upper='0.04' effort='" + effort +
                  "' velocity='0.1'/></joint>");
    }
  }
  slide = bare.links[static_cast<std::size_t>(find_anatomy(bare).hands[0].link)].name + "_finger_0.03_slide";
  ProposalSource source;
  source.urdf_name = "hrp1s.urdf";
  source.srdf_text = "<robot name='r'><rotor_params><joint name='" + slide + "' mass='0.01' gear_ratio='1'/>"
                     "<joint name='RLEG_KNEE' mass='0.02' gear_ratio='1'/></rotor_params></robot>";
  return propose(load_repaired_urdf(text, bare.folder + "/hrp1s.urdf", {}, source.repairs), source);
}

// Fingers that no motor moves are fixed to their hand in a proposal, so nothing else is said of their joints.
TEST(Proposal, RotorsOfFixedFingersAreLeftOut) {
  std::string slide;
  const Proposal found = proposed_with_fingers("0", slide);
  EXPECT_NE(found.yaml.find(slide), std::string::npos) << found.yaml;  // under fixed_joints
  EXPECT_EQ(found.yaml.find("grippers:"), std::string::npos) << found.yaml;
  EXPECT_EQ(found.srdf.find("\"" + slide + "\" mass"), std::string::npos) << found.srdf;
  EXPECT_NE(found.srdf.find("\"RLEG_KNEE\" mass"), std::string::npos) << found.srdf;
}

TEST(Proposal, FingersOfARobotThatStandsMoveAsOneGroup) {
  std::string slide;
  const Proposal found = proposed_with_fingers("20", slide);
  const std::size_t grippers = found.yaml.find("grippers:");
  ASSERT_NE(grippers, std::string::npos) << found.yaml;
  EXPECT_NE(found.yaml.find("soles:"), std::string::npos);
  EXPECT_GT(found.yaml.find(slide), grippers) << "not under fixed_joints";
  EXPECT_NE(found.yaml.find("- {joints: [" + slide), std::string::npos) << "it has a servo";
  EXPECT_NE(found.srdf.find("\"" + slide + "\" mass"), std::string::npos) << found.srdf;
}

}  // namespace
}  // namespace twinbus
