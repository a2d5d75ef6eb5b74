// What `check --mend` puts right in a URDF, and that it leaves alone what is right.

#include "robot/lint/mend.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "robot/description/load.h"
#include "robot/lint/model_lint.h"

namespace twinbus {
namespace {

std::string link(const std::string& name, const std::string& inertia) {
  return "<link name='" + name + "'><inertial><mass value='2'/><inertia " + inertia +
         "/></inertial><collision><geometry><box size='0.3 0.2 0.1'/></geometry></collision></link>";
}
const std::string kGood = "ixx='0.01' iyy='0.02' izz='0.02' ixy='0' ixz='0' iyz='0'";

std::string joint(const std::string& name, const std::string& parent, const std::string& child, const std::string& limit,
                  const std::string& axis = "0 0 1") {
  return "<joint name='" + name + "' type='revolute'><origin xyz='0 0 0.2'/><parent link='" + parent +
         "'/><child link='" + child +
         "'/><axis xyz='" + axis + "'/><limit " + limit + "/></joint>";
}

Model loaded(const std::string& text) {
  UrdfRepairs repairs;
  return load_repaired_urdf(text, "/tmp/mend.urdf", {}, repairs);
}

TEST(Mend, PutsRightWhatIsWrongAndSaysIt) {
  const std::string text =
      "<robot name='r'>" + link("base", kGood) + link("antenna", "ixx='-0.01' iyy='0.02' izz='0.02' ixy='0' ixz='0' iyz='0'") +
      link("fat", "ixx='0.01' iyy='0.01' izz='0.05' ixy='0' ixz='0' iyz='0'") + link("left_hand", kGood) +
      link("right_hand", kGood) +
      joint("turned", "base", "antenna", "lower='1' upper='-1' effort='20' velocity='2'") +
      joint("degrees", "antenna", "fat", "lower='-180' upper='90' effort='30' velocity='3'", "0 0 2") +
      joint("left_wrist", "fat", "left_hand", "lower='-1' upper='1' effort='7' velocity='2'") +
      joint("right_wrist", "fat", "right_hand", "lower='-1' upper='1' effort='0'") + "</robot>";
  EXPECT_THROW(loaded(text), std::runtime_error);
  std::vector<std::string> changes;
  const std::string mended = mend_urdf(text, "mend.urdf", changes);
  std::string all;
  for (const std::string& change : changes) all += change + "\n";
  EXPECT_EQ(changes.size(), 7U) << all;
  for (const char* said : {"link antenna: a principal moment of -0.01", "link fat: its largest moment",
                           "joint turned: lower 1 was above upper -1",
                           "joint degrees: axis 0 0 2", "joint degrees: its range of -180 to 90 is in degrees",
                           "joint right_wrist: its effort limit of 0 N m is none: that of left_wrist is taken, 7 N m",
                           "joint right_wrist: it has no velocity limit: that of left_wrist is taken, 2 rad/s"})
    EXPECT_NE(all.find(said), std::string::npos) << said << "\n" << all;
  const Model model = loaded(mended);
  const auto& joint_of = [&](const char* name) { return model.joints[static_cast<std::size_t>(model.find_joint(name))]; };
  EXPECT_NEAR(joint_of("degrees").lower, -3.14159, 1e-4);
  EXPECT_NEAR(joint_of("degrees").upper, 1.5708, 1e-4);
  EXPECT_EQ(joint_of("turned").lower, -1.0);
  const Link& fat = model.links[static_cast<std::size_t>(model.find_link("fat"))];
  const Eigen::Vector3d moments = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(fat.inertia).eigenvalues();
  EXPECT_GE(moments[0] + moments[1], moments[2]);
  EXPECT_NEAR(moments[2], 0.05, 1e-6);
  // Of the antenna a box of its size and mass.
  const Link& antenna = model.links[static_cast<std::size_t>(model.find_link("antenna"))];
  EXPECT_NEAR(antenna.inertia(0, 0), 2.0 / 12.0 * (0.04 + 0.01), 1e-9);
  for (const Suspicion& s : find_suspicions(model)) EXPECT_EQ(s.what.find("inertia"), std::string::npos) << s.about << s.what;
}

// A file for drawing alone, with a macro that was not expanded and contact points of no size.
TEST(Mend, GivesMassesAndSizesWhereThereAreNone) {
  const std::string shape = "<collision><geometry><sphere radius='0.0'/></geometry></collision>"
                            "<visual><geometry><box size='0.3 0 0.1'/></geometry><xacro:grey/></visual>";
  const std::string text = "<robot name='r' xmlns:xacro='x'><link name='base'>" + shape + "</link><link name='frame'/>" +
                           "<link name='arm'>" + shape + "</link>" +
                           joint("j", "base", "arm", "lower='-1' upper='1' effort='20' velocity='2'") +
                           "<joint name='f' type='fixed'><parent link='arm'/><child link='frame'/></joint></robot>";
  EXPECT_THROW(loaded(text), std::runtime_error);
  std::vector<std::string> changes;
  const Model model = loaded(mend_urdf(text, "mend.urdf", changes));
  EXPECT_EQ(changes.size(), 6U);
  EXPECT_EQ(model.links[1].mass, 1.0);
  EXPECT_GT(model.links[1].inertia(0, 0), 0.0);
  EXPECT_EQ(model.links[1].collision.front().size.x(), 0.001);
}

// What is only drawn is touched where it is drawn; a file that has one shape to touch knows what it leaves out.
TEST(Mend, WhatCannotBeTouchedIsTouchedWhereItIsDrawn) {
  const std::string drawn = "<visual><origin xyz='0 0 0.1'/><geometry><box size='0.3 0.2 0.1'/></geometry><material name='red'/></visual>";
  const std::string body = "<inertial><mass value='2'/><inertia " + kGood + "/></inertial>";
  const auto file = [&](const std::string& more) {
    return "<robot name='r'><link name='base'>" + body + drawn + "</link><link name='arm'>" + body + drawn + more + "</link>" +
           joint("j", "base", "arm", "lower='-1' upper='1' effort='20' velocity='2'") + "</robot>";
  };
  std::vector<std::string> changes;
  const Model model = loaded(mend_urdf(file(""), "mend.urdf", changes));
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NE(changes[0].find("the 2 that are drawn are touched"), std::string::npos) << changes[0];
  for (const Link& link : model.links) {
    ASSERT_EQ(link.collision.size(), 1U);
    EXPECT_EQ(link.collision[0].pose.translation().z(), 0.1);
  }
  changes.clear();
  const std::string one = file("<collision><geometry><sphere radius='0.1'/></geometry></collision>");
  EXPECT_EQ(mend_urdf(one, "mend.urdf", changes), one);
  EXPECT_TRUE(changes.empty());
}

TEST(Mend, LeavesWhatIsRightAsItIsToTheLetter) {
  const std::string text = "<robot name='r'><!-- kept -->" + link("base", kGood) + link("a", kGood) +
                           joint("j", "base", "a", "lower='-3' upper='3' effort='20' velocity='2'") + "</robot>";
  std::vector<std::string> changes;
  EXPECT_EQ(mend_urdf(text, "mend.urdf", changes), text);
  EXPECT_EQ(mend_sides(text, "mend.urdf", loaded(text), changes), text);
  EXPECT_TRUE(changes.empty());
}

// kg cm^2, as drawing programs write it.
TEST(Mend, AnInertiaOfAnotherUnitBecomesThatOfABox) {
  const auto robot = [](double unit) {
    std::string moments;
    for (const char* key : {"ixx", "iyy", "izz"}) moments += std::string(key) + "='" + std::to_string(0.01 * unit) + "' ";
    return "<robot name='r'>" + link("base", kGood) + link("a", moments + "ixy='0' ixz='0' iyz='0'") +
           joint("j", "base", "a", "lower='-3' upper='3' effort='20' velocity='2'") + "</robot>";
  };
  std::vector<std::string> changes;
  EXPECT_EQ(mend_far_inertias(robot(1.0), "mend.urdf", loaded(robot(1.0)), changes), robot(1.0));
  const std::string mended = mend_far_inertias(robot(1e4), "mend.urdf", loaded(robot(1e4)), changes);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NE(changes[0].find("link a: its inertia is that of a shell of radius"), std::string::npos) << changes[0];
  const Model model = loaded(mended);
  const double expected = 2.0 / 12.0 * (0.2 * 0.2 + 0.1 * 0.1);  // of 2 kg, 0.3 x 0.2 x 0.1 m
  EXPECT_NEAR(model.links[static_cast<std::size_t>(model.find_link("a"))].inertia(0, 0), expected, 1e-9);
}

TEST(Mend, LeftAndRightExchangedAreExchangedBack) {
  const Model right = load_robot("hrp1s");
  const Model bare = load_urdf(right.folder + "/hrp1s.urdf", {});
  std::vector<std::string> changes;
  EXPECT_EQ(mend_sides(bare.urdf_text, "hrp1s.urdf", bare, changes), bare.urdf_text);
  // All of the left called right and the other way round.
  std::string wrong = bare.urdf_text;
  for (std::size_t i = 0; i + 4 < wrong.size(); ++i) {
    const bool quoted = wrong[i] == '"' && (wrong[i + 1] == 'L' || wrong[i + 1] == 'R');
    if (quoted && (wrong.compare(i + 2, 3, "LEG") == 0 || wrong.compare(i + 2, 3, "ARM") == 0 ||
                   wrong.compare(i + 2, 3, "HAN") == 0))
      wrong[i + 1] = wrong[i + 1] == 'L' ? 'R' : 'L';
  }
  ASSERT_NE(wrong, bare.urdf_text);
  UrdfRepairs repairs;
  const std::string file = right.folder + "/hrp1s.urdf";
  const Model crosswise = load_repaired_urdf(wrong, file, {}, repairs);
  const std::string back = mend_sides(wrong, file, crosswise, changes);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NE(changes[0].find("left and right are exchanged"), std::string::npos);
  const Model mended = load_repaired_urdf(back, file, {}, repairs);
  ASSERT_EQ(mended.link_count(), bare.link_count());
  for (const Joint& j : bare.joints) {
    const int found = mended.find_joint(j.name);
    ASSERT_GE(found, 0) << j.name;
    EXPECT_TRUE(mended.joints[static_cast<std::size_t>(found)].placement.isApprox(j.placement)) << j.name;
  }
}

// An angle that was written as a place.
TEST(Mend, AMeshThatIsTouchedFarFromWhereItIsDrawnIsPutThere) {
  const std::string mesh = "<geometry><mesh filename='nub.stl'/></geometry>";
  const auto nub = [&](const std::string& touched) {
    return "<robot name='r'><link name='nub'><inertial><origin xyz='0 0 -0.02'/><mass value='1'/><inertia " + kGood +
           "/></inertial><visual><origin rpy='0 1.57 0' xyz='0 0 0'/>" + mesh + "</visual><collision><origin xyz='" + touched + "'/>" + mesh +
           "</collision></link></robot>";
  };
  std::vector<std::string> changes;
  const std::string mended = mend_urdf(nub("0 1.57 0"), "mend.urdf", changes);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes.front(), "link nub, collision: its mesh lies 1.57 m from where the same mesh is drawn: it is put there");
  EXPECT_NE(mended.find("<origin rpy=\"0 1.57 0\" xyz=\"0 0 0\">", mended.find("<collision>")), std::string::npos) << mended;
  EXPECT_EQ(mend_urdf(nub("0 0.1 0"), "mend.urdf", changes), nub("0 0.1 0"));
}

TEST(Mend, CommasBetweenThreeNumbersBecomeSpaces) {
  std::vector<std::string> changes;
  const std::string mended =
      mend_urdf("<robot name='r'><joint name='j' type='fixed'><origin rpy='1.57, 0 0.5' xyz='0,5 0 0'/></joint></robot>", "m.urdf", changes);
  ASSERT_EQ(changes.size(), 1U);  // 0,5 0 0 would be four
  EXPECT_EQ(changes.front(), "joint j: origin rpy=\"1.57, 0 0.5\" has commas between its numbers: spaces");
  EXPECT_NE(mended.find("rpy=\"1.57  0 0.5\" xyz=\"0,5 0 0\""), std::string::npos) << mended;
}

TEST(Mend, ACollisionWithoutAShapeIsLeftOut) {
  std::string text = "<robot name='r'>" + link("base", kGood) + "</robot>";
  text.insert(text.find("</link>"), "<collision>\n</collision><visual><geometry/></visual>");
  EXPECT_THROW(loaded(text), std::runtime_error);
  std::vector<std::string> changes;
  EXPECT_EQ(loaded(mend_urdf(text, "mend.urdf", changes)).links.front().collision.size(), 1U);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_NE(changes.front().find("link base: a <collision> or <visual> without a shape is left out"), std::string::npos);
}

// As in the descriptions of arms that say no effort at all: 0.
TEST(Mend, AnEffortThatNoJointSaysCarriesTheArmStretchedOut) {
  const std::string none = "lower='-1' upper='1' effort='0' velocity='2'";
  std::string text = "<robot name='r'>" + link("base", kGood) + link("upper", kGood) + link("fore", kGood) +
                     joint("shoulder", "base", "upper", none) + joint("elbow", "upper", "fore", none) + "</robot>";
  text.replace(text.find("<mass value='2'/>", text.find("fore")), 17, "<mass value='200'/>");
  std::vector<std::string> changes;
  const Model model = loaded(mend_urdf(text, "mend.urdf", changes));
  const auto effort = [&](const char* name) { return model.joints[static_cast<std::size_t>(model.find_joint(name))].effort; };
  EXPECT_NEAR(effort("shoulder"), 2.0 * 9.81 * 200.0 * 0.2, 1e-2);  // the forearm's centre of mass is 0.2 m beyond
  EXPECT_NEAR(effort("elbow"), 100.0, 1e-9);
  EXPECT_EQ(changes.size(), 2U);
}

}  // namespace
}  // namespace twinbus
