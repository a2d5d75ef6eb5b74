// What is read of MuJoCo models, on small texts: numbers follow from the words of the MJCF reference.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "common/text/strict_yaml.h"
#include "robot/description/load.h"
#include "robot/description/srdf.h"
#include "robot/mjcf/geom_inertia.h"
#include "robot/mjcf/mjcf_to_urdf.h"
#include "test/temporary_folder.h"

namespace twinbus::test {
namespace {

constexpr double kPi = std::numbers::pi;

MjcfModel read(const std::string& inside) { return read_mjcf_model_text("<mujoco>" + inside + "</mujoco>", "t.xml"); }

MjcfRobot robot(const std::string& inside) {
  const MjcfModel model = read(inside);
  return robot_of_mjcf(model, "t.xml");
}

// The URDF made of it, as the rest of twinbus reads it.
Model loaded(const MjcfRobot& made) {
  UrdfRepairs repairs;
  return load_repaired_urdf(made.urdf, "t.urdf", {}, repairs);
}

constexpr const char* kArm =
    "<worldbody><body name='upper' pos='0 0 1'><joint name='shoulder' axis='0 2 0' range='-90 45' damping='0.5'"
    " frictionloss='0.2' armature='0.03'/><geom type='capsule' size='0.05 0.2' pos='0 0 -0.2'/>"
    "<body name='lower' pos='0 0 -0.5'><joint name='elbow' axis='0 1 0' pos='0 0 0.1'/><geom type='box' size='0.1 0.2 0.3'"
    " mass='2'/></body></body></worldbody>";

TEST(MjcfRead, JointsLimitsAndMassesComeAsWritten) {
  const Model model = loaded(robot(kArm));
  ASSERT_EQ(model.joint_count(), 2);
  const Joint& shoulder = model.joints[0];
  EXPECT_EQ(shoulder.kind, JointKind::kRevolute);
  EXPECT_NEAR(shoulder.lower, -0.5 * kPi, 1e-12);
  EXPECT_NEAR(shoulder.upper, 0.25 * kPi, 1e-12);
  EXPECT_NEAR((shoulder.axis - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-12);
  EXPECT_EQ(shoulder.damping, 0.5);
  EXPECT_EQ(shoulder.friction, 0.2);
  EXPECT_NEAR(shoulder.placement.translation().z(), 1.0, 1e-12);
  EXPECT_EQ(model.joints[1].kind, JointKind::kContinuous);
  // The link's frame is where its joint is anchored, 0.1 m above the body's.
  EXPECT_NEAR(model.joints[1].placement.translation().z(), -0.4, 1e-12);
  EXPECT_NEAR(model.links[2].com.z(), -0.1, 1e-12);
  EXPECT_NEAR(model.links[2].mass, 2.0, 1e-12);
  EXPECT_NEAR(model.links[2].inertia(0, 0), 2.0 / 3.0 * (0.04 + 0.09), 1e-12);
  const double volume = kPi * 0.0025 * 0.4 + 4.0 / 3.0 * kPi * 0.000125;
  EXPECT_NEAR(model.links[1].mass, 1000.0 * volume, 1e-9);
}

TEST(MjcfRead, ArmatureBecomesARotor) {
  const MjcfRobot made = robot(kArm);
  const Srdf srdf = parse_srdf(made.srdf, "t.srdf");
  ASSERT_EQ(srdf.rotors.size(), 1u);
  EXPECT_EQ(srdf.rotors[0].joint, "shoulder");
  EXPECT_EQ(srdf.rotors[0].reflected_inertia, 0.03);
}

TEST(MjcfRead, DefaultsComeFromTheClassTheChildclassAndTheTop) {
  const MjcfModel model = read(
      "<default><joint damping='1' armature='0.1'/><default class='leg'><joint damping='2'/><default class='knee'>"
      "<joint axis='0 1 0'/></default></default></default><worldbody><body name='a'><joint name='top'/><geom size='0.1'/>"
      "<body name='b' childclass='leg'><joint name='leg'/><geom size='0.1'/><body name='c'><joint name='knee' class='knee'"
      " armature='0.5'/><geom size='0.1'/></body></body></body></worldbody>");
  const auto joint = [&](int body) { return model.bodies[at(body)].joints[0]; };
  EXPECT_EQ(joint(1).damping, 1.0);
  EXPECT_EQ(joint(2).damping, 2.0);
  EXPECT_EQ(joint(2).armature, 0.1);
  EXPECT_EQ(joint(3).damping, 2.0);
  EXPECT_EQ(joint(3).armature, 0.5);
  EXPECT_NEAR(joint(3).axis.y(), 1.0, 1e-12);
}

TEST(MjcfRead, AllWordsForAnOrientationSayTheSame) {
  // 90 degrees about z, in every way that MJCF has.
  for (const char* word : {"quat='1 0 0 1'", "axisangle='0 0 3 90'", "euler='0 0 90'", "xyaxes='0 2 0 -1 0.5 0'"}) {
    const MjcfModel model = read(std::string("<worldbody><body ") + word + "/></worldbody>");
    EXPECT_NEAR((model.bodies[1].place.linear() - rotation_z(0.5 * kPi)).norm(), 0.0, 1e-12) << word;
  }
  const MjcfModel model = read("<worldbody><body zaxis='1 0 0'/></worldbody>");
  EXPECT_NEAR((model.bodies[1].place.linear().col(2) - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12);
}

TEST(MjcfRead, EulerSequencesOfCapitalsTurnAboutFixedAxes) {
  const Eigen::Matrix3d x = rotation_about(Eigen::Vector3d::UnitX(), 0.3);
  const Eigen::Matrix3d z = rotation_z(0.5);
  const auto turned = [](const char* sequence) {
    return Eigen::Matrix3d(read(std::string("<compiler angle='radian' eulerseq='") + sequence +
                                "'/><worldbody><body euler='0.3 0 0.5'/></worldbody>")
                               .bodies[1]
                               .place.linear());
  };
  EXPECT_NEAR((turned("xyz") - x * z).norm(), 0.0, 1e-12);
  EXPECT_NEAR((turned("XYZ") - z * x).norm(), 0.0, 1e-12);
}

TEST(MjcfRead, AFrameMovesWhatIsInIt) {
  const MjcfModel model = read(
      "<worldbody><frame pos='1 0 0' euler='0 0 90'><body name='a' pos='1 0 0'><joint name='j' axis='1 0 0'/>"
      "<frame pos='0 0 2'><geom size='0.1' pos='0 0 1'/></frame></body></frame></worldbody>");
  EXPECT_NEAR((model.bodies[1].place.translation() - Eigen::Vector3d(1, 1, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(model.bodies[1].geoms[0].place.translation().z(), 3.0, 1e-12);
}

TEST(MjcfRead, SeveralJointsOfABodyAreLinksInARow) {
  const Model model = loaded(robot(
      "<worldbody><body name='a'><joint name='x' type='slide' axis='1 0 0'/><joint name='turn' axis='0 0 1' pos='0.2 0 0'/>"
      "<geom size='0.1'/></body></worldbody>"));
  ASSERT_EQ(model.joint_count(), 2);
  EXPECT_EQ(model.joints[0].kind, JointKind::kPrismatic);
  EXPECT_EQ(model.joints[0].lower, -kMjcfTravel);
  EXPECT_NEAR(model.joints[1].placement.translation().x(), 0.2, 1e-12);
  EXPECT_NEAR(model.links[2].com.x(), -0.2, 1e-12);
  EXPECT_GT(model.links[1].mass, 0.0);
  EXPECT_LT(model.links[1].mass, 1e-5 * model.links[2].mass);
}

TEST(MjcfRead, ActuatorsGiveGainsAndEfforts) {
  const MjcfRobot made = robot(
      "<worldbody><body name='a'><joint name='p' actuatorfrcrange='-7 7'/><geom size='0.1'/><body name='b'>"
      "<joint name='m'/><geom size='0.1'/><body name='c'><joint name='g'/><geom size='0.1'/><body name='d'><joint name='none'/>"
      "<geom size='0.1'/></body></body></body></body></worldbody><actuator><position joint='p' kp='20' kv='3' gear='2'"
      " forcerange='-5 5'/><motor joint='m' gear='10' ctrlrange='-1 1'/><general joint='g' gaintype='fixed' biastype='affine'"
      " gainprm='50' biasprm='0 -50 -4'/></actuator>");
  const Model model = loaded(made);
  ASSERT_EQ(made.servos.size(), 2u);
  EXPECT_EQ(made.servos[0].joint, "p");
  EXPECT_EQ(made.servos[0].kp, 80.0);  // gear squared
  EXPECT_EQ(made.servos[0].kd, 12.0);
  EXPECT_EQ(made.servos[1].kp, 50.0);
  EXPECT_EQ(made.servos[1].kd, 4.0);
  const auto effort = [&](const char* name) { return model.joints[at(model.find_joint(name))].effort; };
  EXPECT_EQ(effort("p"), 7.0);  // the joint's own limit is the smaller one
  EXPECT_EQ(effort("m"), 10.0);
  EXPECT_EQ(effort("g"), kMjcfEffort);
  EXPECT_EQ(effort("none"), 0.0);
}

TEST(MjcfRead, KeyframesArePosesThatCountFromRef) {
  const MjcfRobot made = robot(
      "<worldbody><body name='base'><freejoint/><geom size='0.1'/><body name='leg'><joint name='hip' ref='10' range='0 40'/>"
      "<geom size='0.1'/></body></body></worldbody><keyframe><key name='rest' qpos='0 0 1 1 0 0 0 0'/>"
      "<key name='home' qpos='0 0 1 1 0 0 0 0.5'/></keyframe>");
  EXPECT_TRUE(made.floating);
  const double ref = 10.0 * kPi / 180.0;
  const Srdf srdf = parse_srdf(made.srdf, "t.srdf");
  ASSERT_EQ(srdf.poses.size(), 3u);
  EXPECT_EQ(srdf.poses[2].name, "half_sitting");
  EXPECT_NEAR(srdf.poses[2].joints[0].second, 0.5 - ref, 1e-12);
  const Model model = loaded(made);
  EXPECT_NEAR(model.joints[0].lower, -ref, 1e-12);
  EXPECT_NEAR(model.joints[0].upper, 3.0 * ref, 1e-12);
}

TEST(MjcfRead, WhatIsNotReadOfManyIsSaidOnce) {
  std::string servos;
  for (const char* joint : {"a", "b", "c"}) servos += std::string("<position name='") + joint + "' joint='" + joint + "' dampratio='1'/>";
  const MjcfRobot made = robot("<worldbody><body><joint name='a'/><geom size='0.1'/><body><joint name='b'/><geom size='0.1'/><body><joint name='c'/>"
                               "<geom size='0.1'/></body></body></body></worldbody><actuator>" + servos + "</actuator>");
  const auto about = [](const std::string& note) { return note.find("dampratio") != std::string::npos; };
  ASSERT_EQ(std::count_if(made.notes.begin(), made.notes.end(), about), 1);
  EXPECT_NE(std::find_if(made.notes.begin(), made.notes.end(), about)->find("position a and 2 others: dampratio is not read"), std::string::npos);
}

TEST(MjcfRead, ThreeSlidesAndABallAreAFreeJoint) {
  const std::string slides = "<joint type='slide' axis='1 0 0'/><joint type='slide' axis='0 1 0'/><joint type='slide' axis='0 0 1'",
                    rest = "/><joint type='ball'/><geom size='0.1'/><body name='leg'><joint name='hip'/><geom size='0.1'/></body></body></worldbody>";
  const MjcfRobot made = robot("<worldbody><body name='base'>" + slides + rest + "<keyframe><key name='home' qpos='0 0 0 1 0 0 0 0.5'/></keyframe>");
  EXPECT_TRUE(made.floating);
  const Model model = loaded(made);
  ASSERT_EQ(model.joint_count(), 1);
  const Srdf srdf = parse_srdf(made.srdf, "t.srdf");
  ASSERT_FALSE(srdf.poses.empty());
  EXPECT_NEAR(srdf.poses.back().joints[0].second, 0.5, 1e-12) << "its numbers come behind seven of the base";
  EXPECT_THROW(robot("<worldbody><body name='base'>" + slides + " range='0 1' limited='true'" + rest), std::runtime_error);
}

TEST(MjcfRead, SitesOfAGyroAreTheImuAndExcludedBodiesNeverTouch) {
  const MjcfRobot made = robot(
      "<worldbody><body name='base'><freejoint/><geom size='0.1'/><site name='imu' pos='0 0 0.3'/><body name='leg'>"
      "<joint name='hip'/><geom size='0.1' friction='0.4'/></body></body></worldbody><contact><exclude body1='base' body2='leg'/>"
      "</contact><sensor><gyro site='imu'/></sensor>");
  EXPECT_EQ(made.imu, "imu");
  const Srdf srdf = parse_srdf(made.srdf, "t.srdf");
  ASSERT_EQ(srdf.disabled.size(), 1u);
  EXPECT_EQ(srdf.disabled[0].link_b, "leg");
  ASSERT_EQ(made.friction.size(), 2u);
  EXPECT_EQ(made.friction[1].second, 0.4);
  const Model model = loaded(made);
  EXPECT_EQ(model.frames.back().name, "imu");
  EXPECT_NEAR(model.frames.back().in_link.translation().z(), 0.3, 1e-12);
}

TEST(MjcfRead, GeomsThatTouchNothingAreOnlySeen) {
  const Model model = loaded(robot(
      "<worldbody><geom type='plane' size='1 1 1'/><body name='a'><joint name='j'/><geom size='0.1'/>"
      "<geom name='skin' type='box' size='0.1 0.1 0.1' contype='0' conaffinity='0'/><geom name='pad' type='cylinder'"
      " size='0.1 0.1' contype='0' conaffinity='0'/><geom type='capsule' size='0.1 0.2'/></body></worldbody>"
      "<contact><pair geom1='pad' geom2='skin_of_ground'/></contact>"));
  EXPECT_EQ(model.links[1].visual.size(), 1u);
  EXPECT_EQ(model.links[1].collision.size(), 1u + 1u + 3u);  // ball, pad of a pair, capsule
}

TEST(MjcfRead, APairWithTheGroundHasItsOwnFriction) {
  const auto friction = [](const std::string& pairs) {
    const MjcfRobot made = robot(
        "<default><pair friction='0.5 0.5 0 0 0'/></default><worldbody><geom name='floor' type='plane' size='1 1 1'/>"
        "<body name='a'><joint name='j'/><geom name='foot' size='0.1' friction='0.9'/></body>"
        "<body name='b'><joint name='k'/><geom name='hand' size='0.1' friction='0.8'/></body></worldbody><contact>" +
        pairs + "</contact>");
    return std::pair{made.friction.at(0).second, made.friction.at(1).second};
  };
  EXPECT_EQ(friction(""), (std::pair{0.9, 0.8}));
  EXPECT_EQ(friction("<pair geom1='foot' geom2='floor' friction='0.6'/>"), (std::pair{0.6, 0.8}));
  EXPECT_EQ(friction("<pair geom1='floor' geom2='foot'/>"), (std::pair{0.5, 0.8}));  // by its default
  EXPECT_EQ(friction("<pair geom1='foot' geom2='other_file' friction='0.6'/><pair geom1='foot' geom2='floor' friction='0.7'/>"),
            (std::pair{0.7, 0.8}));
  EXPECT_EQ(friction("<pair geom1='foot' geom2='hand' friction='0.1'/>"), (std::pair{0.9, 0.8}));
}

TEST(MjcfRead, ContactsWithTheGroundAreThoseThatMuJoCoMakesOfBoth) {
  const auto contacts = [](const std::string& floor, const std::string& foot, const std::string& pairs = "") {
    return robot("<worldbody><geom name='floor' type='plane' size='1 1 1' " + floor + "/><body name='a'><joint name='j'/>"
                 "<geom name='foot' size='0.1' " + foot + "/></body></worldbody><contact>" + pairs + "</contact>").mujoco.contacts;
  };
  const auto only = [&](const std::string& floor, const std::string& foot, const std::string& pairs = "") {
    const std::vector<MujocoContact> all = contacts(floor, foot, pairs);
    EXPECT_EQ(all.size(), 1u);
    EXPECT_EQ(all.front().links, std::vector<std::string>{"a"});
    return all.front();
  };
  // The larger friction and condim, the mean of solref.
  const MujocoContact both = only("friction='0.3' condim='1' solref='0.04 1'", "friction='0.7 0.02' condim='4'");
  EXPECT_EQ(both.friction, (std::array{0.7, 0.02, 0.0001}));
  EXPECT_EQ(both.condim, 4);
  EXPECT_NEAR(both.solref[0], 0.03, 1e-15);
  // All of the one with priority: what the foot says of its softness does not count.
  const MujocoContact floor = only("friction='0.6' priority='1'", "friction='1' condim='1' solimp='0.8 0.9 0.023'");
  EXPECT_EQ(floor.friction[0], 0.6);
  EXPECT_EQ(floor.condim, 3);
  EXPECT_EQ(floor.solimp, MujocoContact{}.solimp);
  EXPECT_EQ(only("solmix='0'", "solimp='0.8 0.9 0.023'").solimp, (std::array{0.8, 0.9, 0.023, 0.5, 2.0}));
  EXPECT_EQ(only("solref='-500 -20'", "solref='0.02 1'").solref, (std::array{-500.0, -20.0}));
  // A pair says it for both.
  const MujocoContact pair =
      only("friction='0.9' condim='1'", "condim='1'", "<pair geom1='floor' geom2='foot' friction='0.6 0.6 0.1 0.2' condim='6' solref='0.01 2'/>");
  EXPECT_EQ(pair.friction, (std::array{0.6, 0.1, 0.2}));
  EXPECT_EQ(pair.condim, 6);
  EXPECT_EQ(pair.solref, (std::array{0.01, 2.0}));
  // What it leaves out is MuJoCo's default, not that of the geoms; a later pair takes nothing from an earlier one.
  const std::string bare = "<pair geom1='floor' geom2='foot'/>", some = "<pair geom1='floor' geom2='foot' friction='1.5 1.5'/>";
  EXPECT_TRUE(only("condim='1'", "condim='6' friction='0.3 0.2' solref='0.05 1'", bare).same_but_links(MujocoContact{}));
  EXPECT_EQ(only("", "friction='0.3 0.2'", bare + some).friction, (std::array{1.5, 0.005, 0.0001}));
  EXPECT_TRUE(contacts("", "contype='0' conaffinity='0'").empty());
}

TEST(MjcfRead, TheSolverOfTheFileGoesWithTheRobot) {
  const MjcfRobot made = robot(std::string("<option iterations='1' ls_iterations='5' cone='elliptic' impratio='10'/>") + kArm);
  EXPECT_EQ(made.mujoco.iterations, 1);
  EXPECT_EQ(made.mujoco.ls_iterations, 5);
  EXPECT_TRUE(made.mujoco.elliptic);
  EXPECT_EQ(made.mujoco.impratio, 10.0);
  const std::string yaml = mujoco_yaml(made.mujoco);
  const MujocoConfig again = read_mujoco_config(ConfigNode::parse(yaml, "t.yaml").map("mujoco"));
  EXPECT_EQ(again.iterations, 1);
  EXPECT_TRUE(again.elliptic);
  ASSERT_EQ(again.contacts.size(), made.mujoco.contacts.size());
  EXPECT_TRUE(again.contacts[0].same_but_links(made.mujoco.contacts[0]));
  EXPECT_EQ(again.contacts[0].links, (std::vector<std::string>{"upper", "lower"}));
}

TEST(MjcfRead, ALinearEqualityIsAMimic) {
  const Model model = loaded(robot(
      "<worldbody><body name='a'><joint name='one'/><geom size='0.1'/></body><body name='b'><joint name='two'/>"
      "<geom size='0.1'/></body></worldbody><equality><joint joint1='two' joint2='one' polycoef='0.1 -2 0 0 0'/></equality>"));
  const Joint& two = model.joints[at(model.find_joint("two"))];
  EXPECT_EQ(two.mimic, model.find_joint("one"));
  EXPECT_EQ(two.mimic_multiplier, -2.0);
  EXPECT_EQ(two.mimic_offset, 0.1);
}

// A cube as triangles has the mass and inertia of a box, by either word for it.
TEST(MjcfRead, MassOfAMeshIsThatOfTheBodyInside) {
  TemporaryFolder folder;
  folder.write("cube.obj",
               "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
               "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\n");
  for (const char* word : {"exact", "legacy", "convex"}) {
    const std::string file = folder.write(
        std::string(word) + ".xml",
        std::string("<mujoco><asset><mesh name='cube' file='cube.obj' scale='0.1 0.2 0.3' inertia='") + word +
            "'/></asset><worldbody><body name='a'><joint/><geom type='mesh' mesh='cube' pos='1 0 0'/></body></worldbody></mujoco>");
    const MjcfModel model = read_mjcf_model(file);
    const MjcfInertia inertia = body_inertia(model.bodies[1], model);
    EXPECT_NEAR(inertia.mass, 1000.0 * 8.0 * 0.006, 1e-9) << word;
    EXPECT_NEAR((inertia.com - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-12) << word;
    EXPECT_NEAR(inertia.about_com(0, 0), inertia.mass / 3.0 * (0.04 + 0.09), 1e-9) << word;
    EXPECT_NEAR(inertia.about_com(1, 1), inertia.mass / 3.0 * (0.01 + 0.09), 1e-9) << word;
  }
}

TEST(MjcfRead, TheCompilerScalesBoundsAndBalancesMasses) {
  const MjcfRobot made = robot(
      "<compiler settotalmass='10'/><worldbody><body name='a'><joint/><geom size='0.1' mass='1'/><body name='b' pos='0 0 1'>"
      "<joint/><geom size='0.1' mass='3'/></body></body></worldbody>");
  const Model model = loaded(made);
  EXPECT_NEAR(model.links[1].mass, 2.5, 1e-12);
  EXPECT_NEAR(model.links[2].inertia(0, 0), 7.5 * 0.4 * 0.01, 1e-12);
}

TEST(MjcfRead, IncludesAreOneModel) {
  TemporaryFolder folder;
  folder.write("body.xml", "<mujocoinclude><body name='a'><joint name='j'/><geom size='0.1'/></body></mujocoinclude>");
  folder.write("defaults.xml", "<mujoco model='x'><default><joint damping='3'/></default></mujoco>");
  const std::string file = folder.write(
      "main.xml", "<mujoco><include file='defaults.xml'/><worldbody><include file='body.xml'/></worldbody></mujoco>");
  const MjcfModel model = read_mjcf_model(file);
  ASSERT_EQ(model.bodies.size(), 2u);
  EXPECT_EQ(model.bodies[1].joints[0].damping, 3.0);
}

TEST(MjcfRead, OtherBodiesAreScenery) {
  const MjcfRobot made = robot(
      "<worldbody><body name='crate'><freejoint/><geom size='0.1'/></body><body name='wall'><geom size='0.1'/></body>"
      "<body name='base'><freejoint/><geom size='0.1'/><body name='leg'><joint name='hip'/><geom size='0.1'/></body></body>"
      "</worldbody><keyframe><key name='home' qpos='9 9 9 1 0 0 0  0 0 1 1 0 0 0  0.7'/></keyframe>");
  EXPECT_EQ(loaded(made).joint_count(), 1);
  EXPECT_NEAR(parse_srdf(made.srdf, "t.srdf").poses[0].joints[0].second, 0.7, 1e-12);
}

}  // namespace
}  // namespace twinbus::test
