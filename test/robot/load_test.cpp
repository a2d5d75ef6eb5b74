#include "robot/description/load.h"

#include "fixtures.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus::test {
namespace {

const char* const kUrdf = R"(<robot name="r">
<link name="a"><inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="plate"><inertial><origin xyz="0 0 1"/><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><origin xyz="0 0 0.5"/><geometry><box size="1 1 1"/></geometry></collision></link>
<link name="b"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="c"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="jc" type="revolute"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
<joint name="glue" type="fixed"><parent link="a"/><child link="plate"/><origin xyz="1 0 0"/></joint>
<joint name="jb" type="revolute"><parent link="plate"/><child link="b"/><origin xyz="0 0 1"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="10" velocity="2"/></joint>
</robot>)";

struct Folder {
  TemporaryFolder folder;
  std::string urdf = kUrdf, srdf =
                                "<robot name='r'><group_state name='up'><joint name='jb' "
                                "value='0.5'/></group_state></robot>";
  std::string yaml = "urdf: r.urdf\nsrdf: r.srdf\n";
  Model load() const {
    folder.write("r.urdf", urdf);
    folder.write("r.srdf", srdf);
    folder.write("robot.yaml", yaml);
    return load_robot(folder.path());
  }
  std::string error() const {
    return error_of([&] { load(); });
  }
};

TEST(LoadRobot, FixedLinksBecomeOneBody) {
  const Model model = Folder().load();
  ASSERT_EQ(model.link_count(), 3);
  EXPECT_EQ(model.links[0].mass, 4.0);
  EXPECT_TRUE(model.links[0].com.isApprox(Eigen::Vector3d(0.5, 0, 0.5), 1e-12));
  // Two bodies of 2 kg, 0.5 sqrt(2) from the common centre: Steiner about y is 4 kg * 0.5 m^2.
  EXPECT_NEAR(model.links[0].inertia(1, 1), 2.0 + 4.0 * 0.5, 1e-12);
  EXPECT_NEAR(model.links[0].inertia(0, 2), -4.0 * 0.25, 1e-12);
  ASSERT_EQ(model.links[0].collision.size(), 1u);
  EXPECT_TRUE(model.links[0].collision[0].pose.translation().isApprox(Eigen::Vector3d(1, 0, 0.5)));
  EXPECT_TRUE(model.joints[0].placement.translation().isApprox(Eigen::Vector3d(1, 0, 1)));
}

// The model puts parents first; the bus keeps the order of the file.
TEST(LoadRobot, BusOrderIsTheOrderOfTheFile) {
  const Model model = Folder().load();
  EXPECT_EQ(model.joints[0].name, "jb");
  EXPECT_EQ(model.bus_joints, (std::vector<int>{1, 0}));
  EXPECT_EQ(model.bus_index, (std::vector<int>{1, 0}));
  EXPECT_EQ(model.poses[0].q, (std::vector<double>{0.5, 0.0}));
}

TEST(LoadRobot, AGaitOfPointFeetIsRefusedOfARobotWithSoles) {
  Folder folder;
  folder.yaml += "walking:\n  lift: 0.04\n  gait: crawl\n";
  EXPECT_EQ(folder.error(), "");
  folder.yaml += "soles: {left: {frame: b, front: 0.1, back: 0.1, left: 0.05, right: 0.05, stiffness: 1e5, damping: 1e3, friction: 0.8}}\n";
  const std::string error = folder.error();
  EXPECT_NE(error.find("robot.yaml:5"), std::string::npos) << error;
  EXPECT_NE(error.find("gait"), std::string::npos) << error;
  EXPECT_NE(error.find("four point feet"), std::string::npos) << error;
}

TEST(LoadRobot, HashFollowsTheNominalModelOnly) {
  Folder folder;
  const std::int64_t hash = folder.load().hash;
  EXPECT_GT(hash, 0);
  EXPECT_LT(hash, std::int64_t{1} << 53);
  EXPECT_EQ(folder.load().hash, hash);
  folder.yaml += "period: 0.004\nservos: [{joints: [jb], kp: 5}]\n";
  EXPECT_EQ(folder.load().hash, hash);
  folder.urdf.replace(folder.urdf.find("lower=\"-1\""), 10, "lower=\"-2\"");
  EXPECT_NE(folder.load().hash, hash);
}

TEST(LoadRobot, TheImuIsAFrameOrAPlaceInOne) {
  Folder named, placed, zero;
  named.yaml += "imu: plate\n";
  placed.yaml += "imu: {frame: plate, at: [0.1, 0, 0.2], rpy: [0, 0, 0.5]}\n";
  zero.yaml += "imu: {frame: plate}\n";
  const Model at_frame = named.load(), at_place = placed.load();
  EXPECT_EQ(at_frame.hash, zero.load().hash);
  EXPECT_TRUE(at_place.imu.translation().isApprox(Eigen::Vector3d(1.1, 0, 0.2), 1e-12));
  EXPECT_NEAR(at_place.imu.linear()(1, 0), std::sin(0.5), 1e-12);
  EXPECT_NE(at_place.hash, at_frame.hash);
  for (const char* bad : {"{frame: tail}", "{at: [0, 0, 0]}", "{frame: plate, at: [0, .nan, 0]}", "{frame: plate, at: [99, 0, 0]}",
                          "{frame: plate, rpy: [0, 0, 9]}", "{frame: plate, side: left}", "[plate]"}) {
    Folder folder;
    folder.yaml += std::string("imu: ") + bad + "\n";
    EXPECT_NE(folder.error().find("imu"), std::string::npos) << bad << ": " << folder.error();
  }
}

TEST(LoadRobot, FixedInRobotYamlLeavesTheBus) {
  Folder folder;
  folder.yaml += "fixed_joints: [jc]\n";
  const Model model = folder.load();
  EXPECT_EQ(model.joint_count(), 1);
  EXPECT_EQ(model.links[1].mass, 2.0);
}

TEST(LoadRobot, MimicJointsAreNotOnTheBus) {
  Folder folder;
  folder.urdf.replace(folder.urdf.find("</joint>"), 8,
                      "<mimic joint='jb' multiplier='2' offset='0.1'/></joint>");
  const Model model = folder.load();
  EXPECT_EQ(model.bus_joints, (std::vector<int>{0}));
  EXPECT_EQ(model.bus_index, (std::vector<int>{0, -1}));
  EXPECT_EQ(model.joints[1].mimic, 0);
  EXPECT_NEAR(model.poses[0].q[1], 1.1, 1e-12);
}

TEST(LoadRobot, ErrorsNameFileAndRemedy) {
  const auto error = [](const std::string& yaml) {
    Folder folder;
    folder.yaml = yaml;
    return folder.error();
  };
  EXPECT_NE(error("urdf: r.urdf\nperiodd: 1\n")
                .find("robot.yaml:2: key periodd is not known; did you mean period?"),
            std::string::npos);
  EXPECT_NE(error("urdf: x.urdf\n").find("x.urdf: no such file"), std::string::npos);
  EXPECT_NE(error("urdf: ../r.urdf\n").find("must be a file of the robot's folder"),
            std::string::npos);
  EXPECT_NE(error("urdf: r.urdf\nimu: heat\n").find("no link heat"), std::string::npos);
  EXPECT_NE(error("urdf: r.urdf\nfixed_joints: [jx]\n").find("no joint jx; did you mean"),
            std::string::npos);
  EXPECT_NE(error("urdf: r.urdf\nservos: [{joints: [jx], kp: 1}]\n").find("no moving joint jx"),
            std::string::npos);
  EXPECT_NE(error("urdf: r.urdf\nservos: [{joints: [jb], kp: -1}]\n").find("out of range"),
            std::string::npos);
  EXPECT_NE(error("srdf: r.srdf\n").find("urdf is missing"), std::string::npos);
  EXPECT_NE(error_of([] { load_robot("nosuch"); }).find("known: "), std::string::npos);
  EXPECT_NE(error_of([] { load_robot("hrp1"); }).find("did you mean hrp1s"), std::string::npos);
  EXPECT_NE(error_of([] { load_robot(""); }), "");

  Folder folder;
  folder.srdf =
      "<robot name='r'><group_state name='up'><joint name='jb' value='5'/></group_state></robot>";
  EXPECT_NE(folder.error().find("outside its limits"), std::string::npos);
  Folder two_roots;
  std::string& urdf = two_roots.urdf;
  urdf.replace(urdf.find("<link name=\"c\">"), 15, "<link name=\"c\"/><link name=\"d\">");
  EXPECT_NE(two_roots.error().find("roots"), std::string::npos);
}

// A joint may move a link without mass, as long as something behind it has one.
TEST(LoadRobot, MovingLinksNeedMassInThemOrBehindThem) {
  Folder between;
  const std::size_t b = between.urdf.find("<link name=\"b\">");
  between.urdf.replace(b, between.urdf.find("</link>", b) + 7 - b, "<link name=\"b\"/>");
  EXPECT_EQ(between.load().links[1].mass, 0.0);
  Folder folder;
  const std::size_t at = folder.urdf.find("<link name=\"c\">");
  folder.urdf.replace(at, folder.urdf.find("</link>", at) + 7 - at, "<link name=\"c\"/>");
  EXPECT_NE(folder.error().find("link c moves but has no mass; give it an <inertial>, or name "
                                "joint jc under fixed_joints"),
            std::string::npos)
      << folder.error();
}

TEST(Hrp1s, IsTheRobotOfThePaperClass) {
  const Model& model = hrp1s();
  EXPECT_EQ(model.joint_count(), 29);
  EXPECT_EQ(model.bus_count(), 29);
  EXPECT_NEAR(model.total_mass(), 130.8, 1e-9);
  EXPECT_EQ(model.period_ns, 2'000'000);
  const auto on_bus = [&](int k) {
    return model.joints[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])]
        .name;
  };
  EXPECT_EQ(on_bus(0), "RLEG_HIP_R");
  EXPECT_EQ(on_bus(6), "RARM_SHOULDER_P");
  EXPECT_EQ(on_bus(13), "LLEG_HIP_R");
  EXPECT_EQ(on_bus(19), "LARM_SHOULDER_P");
  EXPECT_EQ(on_bus(28), "CHEST");
  EXPECT_EQ(model.leg_joints.size(), 12u);
  for (std::size_t i = 1; i < model.links.size(); ++i) {
    EXPECT_LT(model.links[i].parent, static_cast<int>(i));
    EXPECT_EQ(model.joints[i - 1].parent, model.links[i].parent);
  }
  for (const char* pose : {"zero", "initial", "half_sitting"})
    EXPECT_GE(model.find_pose(pose), 0) << pose;
}

TEST(OurRobots, AreAsLargeAsTheyAreSaidToBe) {
  const struct {
    const char* name;
    int joints;
    double mass;
  } robots[] = {{"hrp1s", 29, 130.8}, {"hrp2p", 30, 58.0}, {"biped12", 12, 58.0}};
  for (const auto& robot : robots) {
    const Model model = load_robot(robot.name);
    EXPECT_EQ(model.bus_count(), robot.joints) << robot.name;
    EXPECT_NEAR(model.total_mass(), robot.mass, 1e-9) << robot.name;
    EXPECT_EQ(model.leg_joints.size(), 12u) << robot.name;
    for (const char* pose : {"zero", "initial", "half_sitting"})
      EXPECT_GE(model.find_pose(pose), 0) << robot.name;
  }
  EXPECT_NEAR(find_anatomy(load_robot("hrp2p")).height, 1.54, 0.005);
}

// In half sitting the soles are flat, level and under the hips, and the centre of mass is well
// inside them.
TEST(Hrp1s, HalfSittingStands) {
  const Model& model = hrp1s();
  Configuration c(model);
  const auto& q = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
  c.q = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
  Kinematics k(model);
  k.update(c);
  for (const Sole& sole : model.soles) {
    const Eigen::Isometry3d frame = k.link_in_world(sole.link) * sole.frame;
    EXPECT_LT(rotation_vector(frame.linear()).norm(), 2e-3);
    const double x = k.com().x() - frame.translation().x();
    EXPECT_GT(x, -sole.back + 0.06);
    EXPECT_LT(x, sole.front - 0.06);
  }
  EXPECT_NEAR(k.com().y(), 0.0, 1e-9);
}

TEST(LoadRobot, EverySharedRobotMakesAModel) {
  if (data_folder().empty()) GTEST_SKIP() << "no shared data; set TWINBUS_DATA";
  for (const char* name : {"simple_humanoid", "bolt", "panda", "jvrc1"}) {
    TemporaryFolder parent;
    const auto folder = std::filesystem::path(parent.path()) / name;
    std::filesystem::copy(data_folder() + "/robots/" + name, folder,
                          std::filesystem::copy_options::recursive);
    std::ofstream(folder / "robot.yaml") << "urdf: " << name << ".urdf\nbase: fixed\n";
    Model model;
    EXPECT_EQ(error_of([&] { model = load_robot(folder.string()); }), "") << name;
    EXPECT_GT(model.bus_count(), 5) << name;
  }
}

TEST(Load, AServoNumberGivenTwiceIsRefused) {
  const std::string last = "    kd: 6\n";
  ASSERT_NE(hrp1s().yaml_text.find(last), std::string::npos);
  const auto load = [&](const std::string& more) {
    std::string yaml = hrp1s().yaml_text;
    yaml.insert(yaml.find(last) + last.size(), more);
    return error_of([&] {
      load_robot_texts({.folder = hrp1s().folder,
                        .yaml = yaml,
                        .urdf = hrp1s().urdf_text,
                        .srdf = hrp1s().srdf_text});
    });
  };
  EXPECT_EQ(load(""), "");
  EXPECT_EQ(load("  - {joints: [CHEST], damping: 0.1}\n"), "");
  const std::string twice = load("  - {joints: [CHEST], kp: 5}\n");
  EXPECT_NE(twice.find("CHEST"), std::string::npos) << twice;
  EXPECT_NE(twice.find("a second time"), std::string::npos) << twice;
}

TEST(Load, PairsThatAreNearByDesignAreNamedWithAMarginBelowTheGuards) {
  const auto load = [](const std::string& pair) {
    Folder robot;
    robot.yaml += "near_pairs:\n  - {" + pair + "}\n";
    return error_of([&] { robot.load(); });
  };
  EXPECT_EQ(load("links: [a, c], margin: 0.004"), "");
  EXPECT_NE(load("links: [a, d], margin: 0.004").find("there is no link d"), std::string::npos);
  EXPECT_EQ(load("links: [a, plate], margin: 0.004"), "") << "a fixed joint makes them one";
  EXPECT_NE(load("links: [a, a], margin: 0.004").find("twice"), std::string::npos);
  EXPECT_NE(load("links: [a], margin: 0.004").find("two links"), std::string::npos);
  for (const char* margin : {"0", "-0.004", "0.011", ".nan", "much"})
    EXPECT_NE(load(std::string("links: [a, c], margin: ") + margin).find("margin"), std::string::npos) << margin;
  EXPECT_NE(load("links: [a, c]").find("margin"), std::string::npos);
}

// Whoever reads them, what is wrong with them is said when the robot is loaded.
TEST(Load, LoopsToolsAndMujocoAreChecked) {
  const auto load = [](const std::string& more) {
    Folder robot;
    robot.yaml += more;
    return error_of([&] { robot.load(); });
  };
  EXPECT_EQ(load("loops:\n  - {link: c, to: world}\n"), "");
  EXPECT_NE(load("loops:\n  - {link: c, to: d}\n").find("loops: there is no link d"), std::string::npos);
  EXPECT_EQ(load("tools:\n  pen: {frame: plate, at: [0, 0, 0.1]}\n"), "");
  EXPECT_NE(load("tools:\n  pen: {frame: d}\n").find("there is no link d"), std::string::npos);
  EXPECT_NE(load("tools:\n  pen: {frame: plate, ta: [0, 0, 0.1]}\n").find("ta"), std::string::npos);
  EXPECT_EQ(load("mujoco:\n  contacts: [{links: [plate]}]\n"), "");
  EXPECT_NE(load("mujoco:\n  contacts: [{links: [nose]}]\n").find("there is no link nose"), std::string::npos);
  EXPECT_NE(load("mujoco:\n  iteration: 1\n").find("iterations"), std::string::npos);
}

}  // namespace
}  // namespace twinbus::test
