#include "robot/onboarding/proposal.h"

#include <array>

#include "fixtures.h"
#include "robot/onboarding/base_turn.h"
#include "robot/onboarding/known_srdf.h"
#include "robot/description/shape_inertia.h"
#include "robot/lint/model_lint.h"
#include "robot/onboarding/rest_pairs.h"
#include "robot/names/asset_path.h"
#include "common/math/index.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::test {
namespace {

// The URDF of hrp1s without its robot.yaml.
Model bare_hrp1s() { return load_urdf(hrp1s().folder + "/hrp1s.urdf", {}); }

TEST(Anatomy, FindsWhatPeopleWroteDownForHrp1s) {
  const Model& known = hrp1s();
  const Anatomy found = find_anatomy(bare_hrp1s());
  for (std::size_t side = 0; side < 2; ++side) {
    EXPECT_EQ(found.soles[side].link, known.soles[side].link);
    EXPECT_TRUE(found.soles[side].frame.isApprox(known.soles[side].frame, 1e-9));
    EXPECT_NEAR(found.soles[side].front, known.soles[side].front, 1e-9);
    EXPECT_NEAR(found.soles[side].back, known.soles[side].back, 1e-9);
    EXPECT_EQ(found.hands[side].link, known.hands[side].link);
    EXPECT_EQ(found.hands[side].joints, known.hands[side].joints);
  }
  EXPECT_EQ(found.leg_joints.size(), 12u);
  EXPECT_EQ(found.imu_frame, "IMU");
  EXPECT_TRUE(found.doubts.empty()) << found.doubts.front();
}

TEST(Proposal, IsAFolderThatLoadsAndStands) {
  std::vector<std::pair<std::string, std::string>> robots = {
      {"hrp1s", hrp1s().folder + "/hrp1s.urdf"}};
  if (!data_folder().empty())
    robots.emplace_back("jvrc1", data_folder() + "/robots/jvrc1/jvrc1.urdf");
  for (const auto& [name, urdf] : robots) {
    ProposalSource source;
    source.urdf_name = name + ".urdf";
    source.packages = find_packages(urdf);
    const Model bare = load_urdf(urdf, source.packages);
    const Proposal proposal = propose(bare, source);
    TemporaryFolder folder;
    folder.write("robot.yaml", proposal.yaml);
    folder.write(name + ".srdf", proposal.srdf);
    folder.write(name + ".urdf", bare.urdf_text);
    const Model model = load_robot(folder.path());
    ASSERT_GE(model.soles[0].link, 0);
    ASSERT_GE(model.hands[0].link, 0);
    // It does not tip over on the springs of its soles, to no side.
    const double tips = 9.8 * model.total_mass() * find_anatomy(bare).hip_height;
    const Sole& sole = model.soles[0];
    EXPECT_GT(sole.stiffness * 0.25 * std::pow(sole.left + sole.right, 2), 3.8 * tips) << name;
    EXPECT_GT(sole.stiffness * 0.25 * std::pow(sole.front + sole.back, 2), 5.7 * tips) << name;
    for (const int j : model.bus_joints)
      EXPECT_GT(model.joints[static_cast<std::size_t>(j)].kp, 0.0);
    const int pose = model.find_pose("half_sitting");
    ASSERT_GE(pose, 0);
    Configuration c(model);
    const auto& q = model.poses[static_cast<std::size_t>(pose)].q;
    c.q = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
    Kinematics k(model);
    k.update(c);
    const Eigen::Isometry3d left = k.link_in_world(model.soles[0].link) * model.soles[0].frame;
    const Eigen::Isometry3d right = k.link_in_world(model.soles[1].link) * model.soles[1].frame;
    EXPECT_LT(rotation_vector(left.linear()).norm(), 1e-3) << name << ": the soles are flat";
    EXPECT_NEAR(left.translation().z(), right.translation().z(), 1e-4) << name;
    const double middle =
        left.translation().x() + 0.5 * (model.soles[0].front - model.soles[0].back);
    const double length = model.soles[0].front + model.soles[0].back;
    EXPECT_NEAR(k.com().x(), middle - std::min(0.02, 0.085 * length), 2e-3) << name << ": the centre of mass is a little behind their middle";
    EXPECT_TRUE(find_missing(model).empty()) << name << ": " << find_missing(model).front().what;
  }
}

TEST(Proposal, TakesRotorsAndFrictionOfATrainingWhereTheFilesSayNothing) {
  Model bare = bare_hrp1s();
  bare.joints[1].rotor_inertia = 0.3;
  ProposalSource source;
  source.urdf_name = "hrp1s.urdf";
  source.srdf_text = "<robot name='hrp1s'><rotor_params><joint name='" + bare.joints[2].name + "' mass='0.1' gear_ratio='1'/></rotor_params></robot>";
  for (const std::size_t j : {0U, 1U, 2U}) source.trained.push_back({.joint = bare.joints[j].name, .rotor_inertia = 0.02});
  source.trained[0].friction = 0.4;
  const Proposal proposal = propose(bare, source);
  const Model model = load_robot_texts({.folder = hrp1s().folder, .yaml = proposal.yaml, .urdf = bare.urdf_text, .srdf = proposal.srdf});
  const auto joint = [&](std::size_t j) { return model.joints[at(model.find_joint(bare.joints[j].name))]; };
  EXPECT_EQ(joint(0).rotor_inertia, 0.02);
  EXPECT_EQ(joint(0).friction, 0.4);
  EXPECT_EQ(proposal.yaml.find("rotor_inertia"), proposal.yaml.rfind("rotor_inertia"));  // the others have their own
}

// Friction leaves a servo off by friction / kp: a light wrist with it, or with strong gears, gets more than its weight asks for;
// an effort that no joint has makes no servo that a tick cannot follow.
TEST(Proposal, ServosOfArmsOvercomeFriction) {
  Model bare = load_urdf(hrp1s().folder + "/hrp1s.urdf", find_packages(hrp1s().folder + "/hrp1s.urdf"));
  const int wrist = hrp1s().hands[0].joints.back();
  ProposalSource source;
  source.urdf_name = "hrp1s.urdf";
  TemporaryFolder folder;
  folder.write("hrp1s.urdf", bare.urdf_text);
  const auto stiffness = [&](double friction, double effort) {
    bare.joints[static_cast<std::size_t>(wrist)].effort = effort;
    bare.joints[static_cast<std::size_t>(wrist)].friction = friction;
    const Proposal proposal = propose(bare, source);
    folder.write("robot.yaml", proposal.yaml);
    folder.write("hrp1s.srdf", proposal.srdf);
    return load_robot(folder.path()).joints[static_cast<std::size_t>(wrist)].kp;
  };
  EXPECT_LT(stiffness(0.0, 1.0), 150.0);
  EXPECT_GE(stiffness(1.0, 1.0), 200.0);
  EXPECT_GE(stiffness(0.0, 200.0), 400.0);
  EXPECT_LT(stiffness(0.0, 1e9), 1e5);
}

// Nothing to see or touch on feet, as on simple_humanoid: the ankle still says where they are.
TEST(Anatomy, ASoleThatLiesBesideItsAnkleCarriesOnBothSidesOfItsFrame) {
  Model model = bare_hrp1s();
  const Anatomy before = find_anatomy(model);
  const auto move = [&](double by) {
    for (std::size_t side = 0; side < 2; ++side) {
      for (Shape& shape : model.links[at(before.soles[side].link)].collision) shape.pose.translation().y() += side == 0 ? by : -by;
    }
    return find_anatomy(model).soles[0];
  };
  const double width = before.soles[0].left + before.soles[0].right;
  const Sole near = move(0.02);  // still well above it: the frame stays below the ankle
  EXPECT_NEAR(near.frame.translation().y(), before.soles[0].frame.translation().y(), 1e-9);
  EXPECT_NEAR(near.left - near.right, 0.04, 1e-9);
  const Sole beside = move(0.4 * width - 0.02);
  EXPECT_NEAR(beside.left, 0.5 * width, 1e-9);
  EXPECT_NEAR(beside.right, 0.5 * width, 1e-9);
  EXPECT_NEAR(beside.frame.translation().y() - before.soles[0].frame.translation().y(), 0.4 * width, 1e-9);
}

TEST(Anatomy, FeetWithoutGeometryHangOnTheAnkles) {
  Model model = bare_hrp1s();
  for (const Sole& sole : hrp1s().soles) {
    model.links[static_cast<std::size_t>(sole.link)].collision.clear();
    model.links[static_cast<std::size_t>(sole.link)].visual.clear();
  }
  const Anatomy guessed = find_anatomy(model);
  std::array<SrdfFoot, 2> feet;
  feet.fill({true, 0.25, 0.14, 0.02, 0.0, 0.105});
  const Anatomy told = find_anatomy(model, feet);
  for (std::size_t side = 0; side < 2; ++side) {
    for (const Anatomy* found : {&guessed, &told}) {
      EXPECT_EQ(found->soles[side].link, hrp1s().soles[side].link);
      EXPECT_EQ(found->leg_joints.size(), 12u);
      EXPECT_NE(found->doubts.front().find("has no geometry"), std::string::npos);
    }
    const Sole& sole = told.soles[side];
    EXPECT_NEAR(sole.front + sole.back, 0.25, 1e-12);
    EXPECT_NEAR(sole.back - sole.front, 0.04, 1e-12);
    EXPECT_NEAR(sole.left, 0.07, 1e-12);
    EXPECT_NEAR(sole.frame.translation().z(), -0.105, 1e-9);
  }
  Eigen::VectorXd q;
  model.soles = guessed.soles;
  EXPECT_TRUE(find_standing_posture(model, q));
  EXPECT_EQ(why_it_falls(model, q), "");
}

// Fingers are of the hand, whether its file has joints for them or not.
TEST(Anatomy, AHandIsAsLargeWithFingersThatMoveAsWithOthers) {
  const Model bare = bare_hrp1s();
  const std::array<Hand, 2> alone = find_anatomy(bare).hands;
  Eigen::Vector3d middle[2];
  for (const std::string kind : {"prismatic", "fixed"}) {
    std::string text = bare.urdf_text;
    for (const Hand& hand : alone) {
      const std::string& palm = bare.links[at(hand.link)].name;
      const std::string finger = &hand == alone.data() ? "left_finger" : "right_finger";
      text.insert(text.rfind("</robot>"),
                  "<link name='" + finger + "'><inertial><mass value='0.1'/>"
                  "<inertia ixx='1e-4' iyy='1e-4' izz='1e-4' ixy='0' ixz='0' iyz='0'/></inertial>"
                  "<collision><geometry><box size='0.02 0.02 0.12'/></geometry></collision></link>"
                  "<joint name='" + finger + "_slide' type='" + kind + "'><origin xyz='0 0 -0.1'/>"
                  "<parent link='" + palm + "'/><child link='" + finger + "'/><axis xyz='0 1 0'/>"
                  "<limit lower='0' upper='0.04' effort='20' velocity='0.1'/></joint>");
    }
    UrdfRepairs repairs;
    const Hand hand = find_anatomy(load_repaired_urdf(text, bare.folder + "/hrp1s.urdf", {}, repairs)).hands[1];
    EXPECT_EQ(hand.link < 0 ? "" : "a hand", std::string("a hand")) << kind;
    middle[kind == "fixed"] = hand.frame.translation();
  }
  EXPECT_LT((middle[0] - middle[1]).norm(), 1e-9);
  EXPECT_GT((middle[0] - alone[1].frame.translation()).norm(), 0.01);
}

// A trunk with arms only: what hangs lowest is not a leg when it is called a wrist.
TEST(Anatomy, HangingArmsAreNoLegs) {
  Model model = bare_hrp1s();
  for (Link& link : model.links) {
    if (link.name.find("LEG") == std::string::npos) continue;
    link.mass = 0.01;
    link.collision.clear();
    link.visual.clear();
  }
  for (Joint& joint : model.joints) {
    if (joint.name.find("LEG") != std::string::npos)
      joint.placement.translation() = Eigen::Vector3d(0.0, 0.0, 0.05);
  }
  for (const Sole& sole : find_anatomy(model).soles) EXPECT_LT(sole.link, 0);
}

TEST(BaseTurn, ABaseThatLiesOrLooksBackIsSetUpright) {
  const Model straight = bare_hrp1s();
  EXPECT_TRUE(find_base_turn(straight).isIdentity(1e-12));
  EXPECT_EQ(side_of_name("l_ankle"), 1);
  EXPECT_EQ(side_of_name("RLEG_LINK5"), -1);
  EXPECT_EQ(side_of_name("LLEG_ANKLE_R"), 1);
  EXPECT_EQ(side_of_name("left_ankle_roll_link"), 1);
  EXPECT_EQ(side_of_name("pelvis"), 0);
  const double pi = 3.14159265358979323846;
  for (const Eigen::Matrix3d& turn :
       {rotation_z(pi), Eigen::Matrix3d(rotation_about(Eigen::Vector3d::UnitX(), -0.5 * pi))}) {
    const auto upright = [](const Model& model, const Eigen::Matrix3d& by) {
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() = by;
      return with_root_above(model.urdf_text, model.links.front().name, "upright_base", pose, "z up");
    };
    const std::string text = upright(straight, turn);
    UrdfRepairs repairs;
    const std::string file = straight.folder + "/hrp1s.urdf";
    const Model turned = load_repaired_urdf(text, file, {}, repairs);
    const Eigen::Matrix3d back = find_base_turn(turned);
    EXPECT_TRUE((back * turn).isIdentity(1e-9)) << back;
    // Once more on top, and it is as it was.
    const Model again = load_repaired_urdf(upright(straight, back * turn), file, {}, repairs);
    EXPECT_TRUE(find_base_turn(again).isIdentity(1e-9));
    EXPECT_TRUE(repairs.fixed_joints.empty());
    // Legs of five joints are legs.
    std::string five = text;
    for (const char* ankle : {"\"LLEG_ANKLE_R\" type=\"revolute\"", "\"RLEG_ANKLE_R\" type=\"revolute\""}) {
      const std::size_t found = five.find(ankle);
      ASSERT_NE(found, std::string::npos);
      five.replace(five.find("revolute", found), 8, "fixed");
    }
    EXPECT_TRUE((find_base_turn(load_repaired_urdf(five, file, {}, repairs)) * turn).isIdentity(1e-9));
  }
}

// The legs hang below a waist of the base: a link above them all, and a joint between.
TEST(Anatomy, JointsBetweenTheBaseAndTheLegsAreNamedAndFixedOnRequest) {
  const Model straight = bare_hrp1s();
  EXPECT_TRUE(joints_above_legs(straight).empty());
  std::string text = straight.urdf_text;
  text.insert(text.rfind("</robot>"),
              "<link name='top'><inertial><mass value='5'/><inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link>"
              "<joint name='waist_turn' type='revolute'><parent link='top'/><child link='" + straight.links.front().name +
              "'/><axis xyz='0 0 1'/><limit lower='-1' upper='1' effort='100' velocity='5'/></joint>");
  UrdfRepairs repairs;
  const std::string file = straight.folder + "/hrp1s.urdf";
  const Model model = load_repaired_urdf(text, file, {}, repairs);
  EXPECT_EQ(model.joint_count(), straight.joint_count() + 1);
  const std::vector<std::string> above = joints_above_legs(model);
  ASSERT_EQ(above, std::vector<std::string>{"waist_turn"});
  repairs.fixed_joints = above;
  const Model fixed = load_repaired_urdf(text, file, {}, repairs);
  EXPECT_EQ(repairs.fixed_joints, above);  // once
  EXPECT_EQ(fixed.joint_count(), straight.joint_count());
  EXPECT_NEAR(fixed.total_mass(), straight.total_mass() + 5.0, 1e-9);
  EXPECT_TRUE(joints_above_legs(fixed).empty());
}

TEST(Proposal, KeepsWhatFitsOfAnSrdfThatIsThere) {
  const Model bare = bare_hrp1s();
  ProposalSource source;
  source.urdf_name = "hrp1s.urdf";
  source.srdf_file = "there.srdf";
  source.srdf_text = hrp1s().srdf_text;
  source.srdf_text.insert(source.srdf_text.rfind("</robot>"),
                          "<disable_collisions link1='CHEST' link2='RLEG_KNEE'/>");
  EXPECT_TRUE(propose(bare, source).doubts.empty());
  EXPECT_NE(propose(bare, source).srdf.find("said by the SRDF that was there"), std::string::npos);
  const auto doubts = [&](const std::string& states) {
    source.srdf_text = "<robot name='r'>" + states + "</robot>";
    std::string all;
    for (const std::string& doubt : propose(bare, source).doubts) all += doubt + "\n";
    return all;
  };
  const std::string begin = "<group_state name='half_sitting' group='all'>";
  EXPECT_NE(
      doubts(begin + "<joint name='RLEG_KNEE' value='9'/></group_state>").find("its limits are"),
      std::string::npos);
  EXPECT_NE(doubts(begin + "<joint name='RLEG_KNEE' value='0.6'/></group_state>")
                .find("half_sitting of the SRDF that was there is not used"),
            std::string::npos);
  EXPECT_NE(
      doubts(begin + "<joint name='Thumb' value='1'/><joint name='Toe' value='1'/></group_state>")
          .find("names 2 joints that do not move here, the first Thumb"),
      std::string::npos);
  EXPECT_NE(doubts("<group_state").find("is not used"), std::string::npos);
}

TEST(Proposal, WhatHasNoMassIsFixedOrFilled) {
  const std::string link =
      "<inertial><mass value='2'/><inertia ixx='0.1' iyy='0.1' izz='0.1' "
      "ixy='0' ixz='0' iyz='0'/></inertial>";
  const std::string bare =
      "<inertial><mass value='3'/><inertia ixx='0' iyy='0' izz='0' ixy='0' "
      "ixz='0' iyz='0'/></inertial><collision><geometry><box size='0.6 0.2 "
      "0.1'/></geometry></collision>";
  const auto joint = [](const std::string& name, const std::string& from, const std::string& to) {
    return "<joint name='" + name + "' type='revolute'><parent link='" + from + "'/><child link='" +
           to +
           "'/><axis xyz='1 0 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>";
  };
  const std::string text = "<robot name='r'><link name='a'>" + link + "</link><link name='b'>" +
                           bare + "</link><link name='v'/><link name='c'>" + link +
                           "</link><link name='tip'/>" + joint("ab", "a", "b") +
                           joint("bv", "b", "v") + joint("vc", "v", "c") + joint("ct", "c", "tip") +
                           "</robot>";
  UrdfRepairs repairs;
  const Model model = load_repaired_urdf(text, "/tmp/r.urdf", {}, repairs);
  EXPECT_EQ(repairs.fixed_joints, std::vector<std::string>{"ct"});
  EXPECT_EQ(repairs.inertia_from_shape, (std::vector<std::string>{"b", "v"}));
  const Link& box = model.links[static_cast<std::size_t>(model.find_link("b"))];
  EXPECT_EQ(box.mass, 3.0);
  EXPECT_NEAR(box.inertia(0, 0), 3.0 / 12.0 * (0.04 + 0.01), 1e-12);
  EXPECT_NEAR(box.inertia(2, 2), 3.0 / 12.0 * (0.36 + 0.04), 1e-12);
  for (const Link& l : model.links) EXPECT_FALSE(lacks_inertia(l)) << l.name;

  TemporaryFolder folder;  // and the yaml says the same
  folder.write("r.urdf", text);
  folder.write("robot.yaml", "urdf: r.urdf\nfixed_joints: [ct]\ninertia_from_shape: [b, v]\n");
  const Model loaded = load_robot(folder.path());
  for (std::size_t i = 0; i < loaded.links.size(); ++i)
    EXPECT_TRUE(loaded.links[i].inertia.isApprox(model.links[i].inertia));
}

TEST(Proposal, ACopyOfTheUrdfFindsItsMeshes) {
  const TemporaryFolder folder;
  std::vector<std::pair<std::string, std::string>> packages;
  const std::string text =
      "<mesh filename=\"meshes/a.stl\"/><mesh filename='package://p/b.stl'/><texture "
      "filename='c.png'/>";
  const std::string out = with_packages(text, folder.path() + "/r.urdf", packages);
  ASSERT_EQ(packages.size(), 1u);
  const std::string own = "package://" + packages[0].first + "/";
  EXPECT_EQ(std::filesystem::weakly_canonical(folder.path()), packages[0].second);
  EXPECT_NE(out.find("\"" + own + "meshes/a.stl\""), std::string::npos) << out;
  EXPECT_NE(out.find("'package://p/b.stl'"), std::string::npos) << out;
  EXPECT_NE(out.find("'c.png'"), std::string::npos) << out;
}

// urdf/ beside meshes/ is how most robots come.
TEST(Proposal, MeshesMayLieBesideTheFolderOfTheUrdf) {
  const TemporaryFolder folder;
  const std::filesystem::path root = std::filesystem::weakly_canonical(folder.path());
  std::vector<std::pair<std::string, std::string>> packages;
  const std::string text = "<mesh scale='1 1 1' filename='../meshes/a.stl'/><mesh filename=\"./b.stl\"/>";
  const std::string out = with_packages(text, folder.path() + "/urdf/r.urdf", packages);
  ASSERT_EQ(packages.size(), 1u);
  EXPECT_EQ(packages[0].second, root);
  const std::string own = "package://" + packages[0].first + "/";
  EXPECT_NE(out.find("'" + own + "meshes/a.stl'"), std::string::npos) << out;
  EXPECT_NE(out.find("\"" + own + "urdf/b.stl\""), std::string::npos) << out;
  const AssetRoots roots{folder.path() + "/copy", packages};
  EXPECT_EQ(resolve_asset(own + "meshes/a.stl", roots, "here"), root / "meshes/a.stl");
  // No farther up than three folders: what is named there is not the robot's.
  packages.clear();
  const std::string far = with_packages("<mesh filename='../../../../../etc/a.stl'/>", "/a/b/c/d/e/r.urdf", packages);
  ASSERT_EQ(packages.size(), 1u);
  EXPECT_EQ(packages[0].second, "/a/b");
  EXPECT_THROW(resolve_asset(far.substr(16, far.size() - 19), {"/a/b/c", packages}, "here"), std::runtime_error);
}

TEST(Proposal, MeshesAreFoundByTheEndOfTheirNameInARenamedFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path root = std::filesystem::weakly_canonical(folder.path()) / "renamed";
  for (const char* file : {"urdf/meshes/a.stl", "meshes/a.stl", "meshes/b.stl"}) {
    std::filesystem::create_directories((root / file).parent_path());
    std::ofstream(root / file) << "solid";
  }
  const auto made = [&](const std::string& name) {
    std::vector<std::pair<std::string, std::string>> packages{{"here", root.string()}};
    const std::string out = with_packages("<mesh filename='" + name + "'/>", (root / "urdf/r.urdf").string(), packages);
    return packages.back().second + " " + out.substr(16, out.size() - 19);
  };
  const std::string top = root.string() + " package://here/", own = (root / "urdf").string() + " package://urdf/";
  EXPECT_EQ(made("package://here/meshes/b.stl"), top + "meshes/b.stl");                   // it is there
  EXPECT_EQ(made("package://my_robot/meshes/b.stl"), top + "meshes/b.stl");               // no such package
  EXPECT_EQ(made("package://here/old/place/meshes/b.stl"), top + "meshes/b.stl");         // no such file in it
  EXPECT_EQ(made("package://my_robot/meshes/B.STL"), top + "meshes/b.stl");               // written on a system that takes both
  EXPECT_EQ(made("../meshes/B.stl"), top + "meshes/b.stl");
  EXPECT_EQ(made("package://my_robot/meshes/a.stl"), own + "meshes/a.stl");               // the nearest
  EXPECT_EQ(made("package://x/renamed/meshes/a.stl"), folder.path() + " package://" + folder.path().substr(folder.path().rfind('/') + 1) + "/renamed/meshes/a.stl");
  EXPECT_EQ(made((root / "meshes/a.stl").string()), top + "meshes/a.stl");  // there, though another one is nearer
  EXPECT_EQ(made("file://" + (root / "meshes/a.stl").string()), top + "meshes/a.stl");
  EXPECT_EQ(made("file:///ws/src/my_robot/meshes/b.stl"), top + "meshes/b.stl");
  EXPECT_EQ(made("/ws/src/my_robot/meshes/b.stl"), top + "meshes/b.stl");
  EXPECT_EQ(made("package://my_robot/meshes/gone.stl"), top.substr(0, top.find(' ')) + " package://my_robot/meshes/gone.stl");
}

Model with_anatomy(const Anatomy& anatomy) {
  Model model = bare_hrp1s();
  model.soles = anatomy.soles;
  model.hands = anatomy.hands;
  return model;
}

// Hands beside the thighs, as many a zero posture has them.
TEST(Proposal, ArmsThatHangBesideTheLegsAreHeldOut) {
  const Anatomy anatomy = find_anatomy(bare_hrp1s());
  const Model model = with_anatomy(anatomy);
  Eigen::VectorXd q = neutral_posture(model);
  ASSERT_LT(arms_to_legs(model, anatomy, q), 0.08);
  const double before = arms_to_legs(model, anatomy, q);
  const double turned = hold_arms_out(model, anatomy, q);
  EXPECT_GT(turned, 0.0);
  EXPECT_GT(arms_to_legs(model, anatomy, q), before + 0.02);
  EXPECT_GT(q[model.find_joint("LARM_SHOULDER_R")], 0.0);
  EXPECT_LT(q[model.find_joint("RARM_SHOULDER_R")], 0.0);
  Eigen::VectorXd again = q;
  if (arms_to_legs(model, anatomy, q) >= 0.08) {
    EXPECT_EQ(hold_arms_out(model, anatomy, again), 0.0);
  }
  ASSERT_TRUE(find_standing_posture(model, q));
  EXPECT_GT(q[model.find_joint("LARM_SHOULDER_R")], 0.0) << "the legs leave the arms where they are";
}

// Knobs on the insides of the thighs that all but touch at rest.
TEST(Proposal, LegsThatAllButTouchStandApart) {
  Model model = with_anatomy(find_anatomy(bare_hrp1s()));
  Eigen::VectorXd before;
  ASSERT_TRUE(find_standing_posture(model, before));
  const Kinematics k = at_rest(model);
  for (std::size_t side = 0; side < 2; ++side) {
    const double to_middle = side == 0 ? -1.0 : 1.0;
    const int thigh = model.links[at(model.joints[at(model.find_joint(side == 0 ? "LLEG_KNEE" : "RLEG_KNEE"))].child)].parent;
    const Eigen::Isometry3d place = k.link_in_world(thigh);
    Shape knob;
    knob.kind = ShapeKind::kSphere;
    knob.size = {0.02, 0.0, 0.0};
    const Eigen::Vector3d inside(place.translation().x(), -to_middle * 0.022, place.translation().z() - 0.2);
    knob.pose.translation() = place.inverse() * inside;
    model.links[at(thigh)].collision.push_back(knob);
  }
  ASSERT_LT(leg_to_leg(model, model.soles, neutral_posture(model)), 0.005);
  ASSERT_LT(leg_to_leg(model, model.soles, before), 0.015);
  Eigen::VectorXd apart;
  ASSERT_TRUE(find_standing_posture(model, apart));
  EXPECT_GE(leg_to_leg(model, model.soles, apart), 0.015);
  EXPECT_EQ(why_it_falls(model, apart), "");
}

TEST(RestPairs, ATouchAtRestIsExemptedWithItsMirrorImage) {
  Model model = hrp1s();
  const std::vector<int> images = mirror_images(model);
  const int left = model.find_link("LLEG_LINK3") >= 0 ? model.find_link("LLEG_LINK3") : model.joints[at(model.find_joint("LLEG_KNEE"))].child;
  const int right = model.joints[at(model.find_joint("RLEG_KNEE"))].child;
  EXPECT_EQ(images[at(left)], right);
  EXPECT_EQ(images[at(right)], left);
  EXPECT_EQ(images[0], 0);
  const std::vector<double>& pose = model.poses[at(model.find_pose("half_sitting"))].q;
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(pose.data(), static_cast<Eigen::Index>(pose.size()));
  const std::size_t clean = pairs_at_rest(model, {q}).size();
  // A ball on the left shank that reaches into the left hand.
  Configuration c(model);
  c.q = q;
  Kinematics k(model);
  k.update(c);
  Shape ball;
  ball.kind = ShapeKind::kSphere;
  ball.size = {0.05, 0.0, 0.0};
  const int hand = model.hands[0].link;
  ball.pose.translation() = k.link_in_world(left).inverse() * k.link_in_world(hand).translation();
  model.links[at(left)].collision.push_back(ball);
  const std::vector<RestPair> pairs = pairs_at_rest(model, {q});
  EXPECT_GT(pairs.size(), clean);
  const auto find = [&](int a, int b) {
    return std::find_if(pairs.begin(), pairs.end(), [&](const RestPair& p) {
      return p.link_a == std::min(a, b) && p.link_b == std::max(a, b);
    });
  };
  ASSERT_NE(find(left, hand), pairs.end());
  EXPECT_EQ(find(left, hand)->why, "touch in a proposed posture");
  ASSERT_NE(find(right, model.hands[1].link), pairs.end());
  EXPECT_NE(find(right, model.hands[1].link)->why.find("mirror image"), std::string::npos);
  for (const RestPair& p : pairs) model.disabled_pairs.push_back({p.link_a, p.link_b});
  EXPECT_TRUE(pairs_at_rest(model, {q}).empty());
}

// A knob above the ankle that a shank's own knob is 20 mm from moves by little when ankles err; a hand by much.
TEST(RestPairs, PairsThatAreNearByDesignHaveMarginsOfTheirOwn) {
  Model model = hrp1s();
  model.disabled_pairs.clear();
  const std::vector<double>& pose = model.poses[at(model.find_pose("half_sitting"))].q;
  Configuration c(model);
  c.q = Eigen::Map<const Eigen::VectorXd>(pose.data(), static_cast<Eigen::Index>(pose.size()));
  Kinematics k(model);
  k.update(c);
  const int shank = model.joints[at(model.find_joint("LLEG_KNEE"))].child, foot = model.soles[0].link, hand = model.hands[0].link;
  const auto knob = [&](int link, const Eigen::Vector3d& place) {
    Shape ball;
    ball.kind = ShapeKind::kSphere;
    ball.size = {0.005, 0.0, 0.0};
    ball.pose.translation() = k.link_in_world(link).inverse() * place;
    model.links[at(link)].collision.push_back(ball);
  };
  for (Link& link : model.links) link.collision.clear();
  const Eigen::Vector3d above = k.link_in_world(foot).translation() + Eigen::Vector3d(0.1, 0.0, 0.3);
  knob(model.links[at(foot)].parent, k.link_in_world(foot).translation());  // or shank and foot were neighbours
  knob(foot, above);
  knob(shank, above + Eigen::Vector3d(0.0, 0.0, 0.03));
  knob(hand, above + Eigen::Vector3d(0.0, 0.03, 0.0));
  const std::vector<NearByDesign> pairs = pairs_near_by_design(model, {c.q}, {});
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].link_a, shank);
  EXPECT_EQ(pairs[0].link_b, foot);
  EXPECT_GE(pairs[0].margin, 0.003);
  EXPECT_LT(pairs[0].margin, 0.010);
  EXPECT_NE(pairs[0].why.find("20.0 mm apart at rest"), std::string::npos) << pairs[0].why;
  EXPECT_TRUE(pairs_near_by_design(model, {c.q}, {{shank, foot, "touch"}}).empty()) << "what is left out has no margin";
}

TEST(Proposal, AnSrdfNearbyIsFound) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() + "/urdf");
  std::filesystem::create_directories(folder.path() + "/srdf");
  const std::string urdf = folder.write("urdf/r.urdf", "<robot/>");
  EXPECT_EQ(find_srdf(urdf), "");
  const std::string other = folder.write("srdf/other.srdf", "<robot/>");
  EXPECT_TRUE(std::filesystem::equivalent(find_srdf(urdf), other));
  const std::string own = folder.write("srdf/r.srdf", "<robot/>");
  EXPECT_TRUE(std::filesystem::equivalent(find_srdf(urdf), own));
}

}  // namespace
}  // namespace twinbus::test
