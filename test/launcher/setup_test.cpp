#include "launcher/up/setup.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "launcher/up/robot_copy.h"
#include "launcher/up/setup_wish.h"
#include "robot/description/load.h"
#include "test/error_of.h"
#include "test/temporary_folder.h"

namespace twinbus::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

const char* const kMoved = R"({"scene": "stand", "save": 3, "limbs": {
  "soles": {"left": {"frame": "LFOOT_SOLE", "at": [0.012, -0.003, 0.001], "rpy": [0, 0, 0.05], "front": 0.11, "back": 0.09, "left": 0.05, "right": 0.06}},
  "hands": {"right": {"frame": "RHAND", "at": [0, 0, -0.02], "rpy": [0.1, -0.2, 0.3]}},
  "imu": {"frame": "IMU", "at": [0, 0.01, 0], "rpy": [0, 0, 1.5]}}})";

// The pose of a frame of the URDF in its moving link.
Eigen::Isometry3d in_link(const Model& model, const std::string& name) {
  for (const Frame& frame : model.frames) {
    if (frame.name == name) return frame.in_link;
  }
  ADD_FAILURE() << name;
  return Eigen::Isometry3d::Identity();
}

TEST(Setup, SavedLimbsAreReadBackWhereTheyWerePut) {
  const TemporaryFolder folder;
  const Model before = load_robot("hrp2p");
  const auto setup = save_robot(kMoved, "hrp2p", folder.path());
  const Model after = load_robot(setup.robot);
  EXPECT_EQ(fs::path(setup.robot).parent_path(), folder.path() + "/saved");
  EXPECT_EQ(after.hash, setup.model_hash);
  EXPECT_NE(after.hash, before.hash);
  const Sole& sole = after.soles[0];
  EXPECT_EQ(sole.link, before.soles[0].link);
  EXPECT_TRUE((in_link(after, "LFOOT_SOLE").inverse() * sole.frame).translation().isApprox(Eigen::Vector3d(0.012, -0.003, 0.001), 1e-9));
  EXPECT_NEAR((in_link(after, "LFOOT_SOLE").inverse() * sole.frame).linear()(1, 0), std::sin(0.05), 1e-9);
  EXPECT_EQ(sole.front, 0.11);
  EXPECT_EQ(sole.right, 0.06);
  EXPECT_TRUE(sole.sensor.isApprox(before.soles[0].sensor, 1e-12));  // the sensor stays where it is
  EXPECT_NEAR((in_link(after, "RHAND").inverse() * after.hands[1].frame).translation().z(), -0.02, 1e-9);
  EXPECT_NEAR((in_link(after, "IMU").inverse() * after.imu).translation().y(), 0.01, 1e-9);
  // What was not named is as it was, pairs and gains too.
  EXPECT_TRUE(after.soles[1].frame.isApprox(before.soles[1].frame, 1e-12));
  EXPECT_EQ(after.disabled_pairs, before.disabled_pairs);
  EXPECT_EQ(after.joints[0].kp, before.joints[0].kp);
}

TEST(Setup, AStartWithMovedLimbsRunsThatRobot) {
  const TemporaryFolder folder;
  const auto setup = write_setup(kMoved, "hrp2p", folder.path());
  EXPECT_EQ(load_robot(setup.robot).soles[0].front, 0.11);
  EXPECT_EQ(setup.model_hash, load_robot(setup.robot).hash);
  EXPECT_FALSE(fs::exists(folder.path() + "/.draft"));
}

const char* const kStarted = R"({"scene": "stand", "joints": {"LARM_ELBOW": -1}, "limbs": {"imu": {"at": [0, 0.02, 0]}}})";

// A stack of a simulator that runs.
Stack simulated_stack() {
  StackProcess simulator;
  simulator.name = "simulator";
  simulator.program = "twinbus_simulator";
  Stack stack;
  stack.activate = simulator.name;
  stack.processes.push_back(simulator);
  return stack;
}

// The supervisor may start a process again with what it was started with: its robot and its pose are as they were.
TEST(Setup, ASaveLeavesWhatRunsAndWhatBeginsAnewAsItIs) {
  const TemporaryFolder folder;
  SetupWishes wishes(folder.path(), {.scene = "stand", .robot = "hrp2p", .engine = "", .model_hash = 0});
  const Stack stack = simulated_stack();
  const StackProcess* const active = stack.find(stack.activate);
  const auto started = wishes.prepare(kStarted, "hrp2p", stack, active);
  const std::string written = text_of(started.robot + "/robot.yaml");
  bool saved = false;
  const std::string said = wishes.save(kMoved, "hrp2p", saved);
  EXPECT_TRUE(saved) << said;
  EXPECT_NE(said.find(folder.path() + "/saved/"), std::string::npos) << said;
  EXPECT_EQ(text_of(started.robot + "/robot.yaml"), written);
  EXPECT_EQ(load_robot(started.robot).hash, started.model_hash);
  EXPECT_GE(load_robot(started.robot).find_pose(kPagePose), 0);
  const auto again = wishes.prepare(R"({"again": true})", "hrp2p", stack, active);
  EXPECT_EQ(again.robot, started.robot);
  EXPECT_EQ(again.model_hash, started.model_hash);
  // The next that starts does not touch what was saved.
  wishes.prepare(kStarted, "hrp2p", stack, active);
  EXPECT_EQ(load_robot(said.substr(said.find('/'))).soles[0].front, 0.11);
}

// A robot behind the bridge that is simulated: it begins anew as it was, and is set up otherwise only beside a simulator.
TEST(Setup, AStandInRobotBeginsAnewAndARealOneNever) {
  const TemporaryFolder folder;
  const std::string again = R"({"again": true})";
  for (const char* name : {"bridge", "both", "twin"}) {
    Stack stack = load_stack(name);
    SetupWishes wishes(folder.path() + "/" + name, {.scene = "stand", .robot = "hrp2p", .engine = "", .model_hash = 0}, stack);
    EXPECT_TRUE(fs::exists(folder.path() + "/" + name + "/stand_in")) << name;
    const auto refusal = [&](const std::string& wish, const char* active) {
      return error_of([&] { (void)wishes.prepare(wish, "hrp2p", stack, stack.find(active)); });
    };
    EXPECT_EQ(refusal(again, "bridge"), "") << name;
    EXPECT_EQ(active_anew(again, stack, stack.find("bridge")), stack.shadow == "bridge" ? "simulator" : "bridge") << name;
    EXPECT_NE(refusal(kStarted, "bridge"), "") << name;
    EXPECT_NE(refusal(again, "nobody's"), "") << name;
    for (StackProcess& process : stack.processes) {
      if (process.name == "bridge") process.arguments = {"--adaptor", "of_a_robot"};
    }
    EXPECT_NE(refusal(again, "bridge"), "") << name;
    for (StackProcess& process : stack.processes) process.hardware = process.name == "bridge";
    EXPECT_NE(refusal(again, "simulator").find("real robot"), std::string::npos) << name;
  }
  const Stack alone = load_stack("sim");
  const SetupWishes wishes(folder.path() + "/sim", {.scene = "stand", .robot = "hrp2p", .engine = "", .model_hash = 0}, alone);
  EXPECT_FALSE(fs::exists(folder.path() + "/sim/stand_in"));
}

TEST(Setup, AnAnswerThatCannotBeWrittenIsToldAndEndsNothing) {
  const TemporaryFolder folder;
  SetupWishes wishes(folder.path(), {.scene = "stand", .robot = "hrp2p", .engine = "", .model_hash = 0});
  for (const char* name : {"/saved.json", "/answer"}) fs::create_directories(folder.path() + name + "/full");
  bool saved = false;
  std::string said = wishes.save(kMoved, "hrp2p", saved);
  EXPECT_TRUE(saved);
  EXPECT_NE(said.find("robot saved as"), std::string::npos) << said;
  EXPECT_NE(said.find("the page is not told"), std::string::npos) << said;
  said = wishes.answer(kStarted, "");
  EXPECT_NE(said.find("the page is not told"), std::string::npos) << said;
}

TEST(Setup, AWrongNumberOfASaveIsRefusedAndNothingStarts) {
  const TemporaryFolder folder;
  SetupWishes wishes(folder.path(), {.scene = "stand", .robot = "hrp2p", .engine = "", .model_hash = 0});
  for (const char* number : {"-1", "\"x\"", "1.5", "null", "9007199254740993", "[1]"}) {
    const std::string wish = std::string(R"({"scene": "stand", "save": )") + number + "}";
    EXPECT_TRUE(only_saves(wish)) << number;
    bool saved = true;
    EXPECT_NE(wishes.save(wish, "hrp2p", saved).find("robot not saved: "), std::string::npos) << number;
    EXPECT_FALSE(saved) << number;
    EXPECT_FALSE(fs::exists(folder.path() + "/saved")) << number;
    EXPECT_NE(text_of(folder.path() + "/saved.json").find("\"ok\":false"), std::string::npos) << number;
  }
}

TEST(Setup, DeepBracketsAreRefusedBeforeTheyAreCopied) {
  const TemporaryFolder folder;
  SetupWishes wishes(folder.path(), {.scene = "stand", .robot = "hrp2p", .engine = "", .model_hash = 0});
  for (const std::size_t depth : {std::size_t{8}, std::size_t{500'000}}) {
    const std::string brackets = std::string(depth, '[') + std::string(depth, ']');
    for (const char* key : {"limbs", "pushes", "unchecked", "save"}) {
      const std::string wish = std::string(R"({"scene": "stand", "save": 1, ")") + key + "\": " + brackets + "}";
      EXPECT_TRUE(only_saves(wish));
      bool saved = true;
      EXPECT_NE(wishes.save(wish, "hrp2p", saved).find("8 brackets deep"), std::string::npos) << key;
      EXPECT_NE(error_of([&] { write_setup(wish, "hrp2p", folder.path()); }).find("8 brackets deep"), std::string::npos) << key;
    }
  }
  // Brackets in a text are none.
  EXPECT_EQ(save_number(R"({"save": 5, "pose": "[[[[[[[[[[\"[[[["})"), 5);
}

TEST(Setup, ALimbPutBackIsTheRobotItWas) {
  const TemporaryFolder folder;
  const auto moved = save_robot(kMoved, "hrp2p", folder.path() + "/first");
  const auto back = save_robot(R"({"limbs": {"soles": {"left": {"at": [0, 0, 0], "rpy": [0, 0, 0], "front": 0.14, "back": 0.1, "left": 0.069,
    "right": 0.069}}, "hands": {"right": {"at": [0, 0, 0], "rpy": [0, 0, 0]}}, "imu": {"at": [0, 0, 0], "rpy": [0, 0, 0]}}})",
                                moved.robot, folder.path() + "/second");
  EXPECT_EQ(back.model_hash, load_robot("hrp2p").hash);
}

TEST(Setup, WhatNoRobotCanBeIsRefusedWithOneSentenceAndNothingIsWritten) {
  const TemporaryFolder folder;
  const std::string good = save_robot(kMoved, "hrp2p", folder.path()).robot;
  const std::string written = text_of(good + "/robot.yaml");
  const auto refused = [&](const std::string& limbs, const std::string& why) {
    for (const auto& write : {&save_robot, &write_setup}) {
      const std::string error = error_of<std::runtime_error>(
          [&] { write(R"({"scene": "stand", "save": 4, "limbs": )" + limbs + "}", "hrp2p", folder.path()); });
      EXPECT_NE(error.find(why), std::string::npos) << limbs << ": " << error;
      EXPECT_FALSE(error.empty()) << limbs;
      EXPECT_EQ(error.find('\n'), std::string::npos) << error;
      EXPECT_EQ(text_of(good + "/robot.yaml"), written) << limbs;
      EXPECT_FALSE(fs::exists(folder.path() + "/.draft"));
      EXPECT_FALSE(fs::exists(folder.path() + "/saved/.draft"));
      EXPECT_FALSE(fs::exists(folder.path() + "/scene.yaml"));
    }
  };
  refused(R"({"soles": {"left": {"at": [null, 0, 0]}}})", "soles: left: at must be a finite number");  // NaN, as JSON writes it
  refused(R"({"soles": {"left": {"at": [1e300, 0, 0]}}})", "must be within 10 m");
  refused(R"({"soles": {"left": {"at": [1e400, 0, 0]}}})", "");  // no JSON at all
  refused(R"({"soles": {"left": {"at": [0, 0]}}})", "three numbers");
  refused(R"({"soles": {"left": {"rpy": [1e9, 0, 0]}}})", "rpy");
  refused(R"({"soles": {"left": {"front": 40}}})", "out of range");
  refused(R"({"soles": {"left": {"front": -0.1}}})", "out of range");
  refused(R"({"soles": {"left": {"front": "wide"}}})", "finite number");
  refused(R"({"soles": {"left": {"frame": "TAIL"}}})", "TAIL");
  refused(R"({"soles": {"left": {"frame": "a\n- b: c"}}})", "control characters");
  refused(R"({"soles": {"left": {"frame": "a}, b: {c"}}})", "a}, b: {c");
  refused(R"({"soles": {"left": {"frame": 7}}})", "name of a link");
  refused(R"({"soles": {"middle": {}}})", "'middle' is not known");
  refused(R"({"soles": {"left": {"stiffness": 1}}})", "'stiffness' is not known");
  refused(R"({"tail": {}})", "'tail' is not known");
  refused(R"({"imu": {"frame": "TAIL"}})", "TAIL");
  refused(R"({"imu": {"at": [99, 0, 0]}})", "within 10 m");
  refused(R"([1])", "must be an object");
}

TEST(Setup, OnlyAWishWithANumberSaves) {
  EXPECT_EQ(save_number(kMoved), 3);
  EXPECT_EQ(save_number(R"({"save": 9007199254740992})"), std::int64_t{1} << 53);
  for (const char* wish : {"", "{}", "[]", R"({"again": true})"}) EXPECT_FALSE(only_saves(wish)) << wish;
}

TEST(RobotCopy, ASensorOfTheOldFrameIsLeftOutWithIt) {
  const std::string yaml = "urdf: r.urdf\nsoles:\n  left: {frame: A, sensor: S, front: 0.1}\nimu: B\n";
  const std::string moved = edited_robot_yaml(yaml, R"({"soles": {"left": {"frame": "C", "at": [0.1, 0, 0]}}, "imu": {"frame": "B", "rpy": [0, 0, 1]}})");
  EXPECT_EQ(moved.find("sensor"), std::string::npos) << moved;
  EXPECT_NE(moved.find("frame: C"), std::string::npos) << moved;
  EXPECT_NE(moved.find("imu: {frame: B, rpy: [0, 0, 1]}"), std::string::npos) << moved;
  EXPECT_NE(edited_robot_yaml(yaml, R"({"imu": {"frame": "D"}})").find("imu: D"), std::string::npos);
  EXPECT_NE(edited_robot_yaml(yaml, R"({"soles": {"left": {"frame": "A"}}})").find("sensor: S"), std::string::npos);
}

TEST(RobotCopy, ANamedArmIsMovedAsALeftOne) {
  const std::string yaml = "urdf: r.urdf\nhands:\n  north: {frame: A, at: [0, 0, 0]}\n";
  EXPECT_NE(edited_robot_yaml(yaml, R"({"hands": {"north": {"frame": "A", "at": [0.1, 0, 0]}}})").find("at: [0.1, 0, 0]"), std::string::npos);
  for (const char* hands : {R"({"hands": {"south": {"frame": "A"}}})", R"({"hands": {"left": {"frame": "A"}}})"}) {
    const std::string why = error_of([&] { (void)edited_robot_yaml(yaml, hands); });
    EXPECT_NE(why.find("the robot has none"), std::string::npos) << why;
  }
}

// Meshes of a folder beside the robot's are found from the copy, too.
TEST(RobotCopy, PackagesAreFoundFromTheCopy) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() + "/robots/one");
  fs::create_directories(folder.path() + "/meshes");
  folder.write("meshes/cube.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  folder.write("robots/one/one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const auto link = [](const std::string& name, const std::string& mesh) {
    return "<link name='" + name + "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>"
           "<collision><geometry><mesh filename='" + mesh + "'/></geometry></collision></link>";
  };
  folder.write("robots/one/one.urdf", "<robot name='../hostile name'>" + link("a", "package://things/cube.obj") + link("b", "package://one/one.obj") +
               "<joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
               "<limit lower='-1' upper='1' effort='10' velocity='2'/></joint></robot>");
  folder.write("robots/one/robot.yaml", "urdf: one.urdf\npackages: {things: ../../meshes}\n");
  const auto setup = save_robot(R"({"limbs": {"imu": {"frame": "b", "at": [0, 0, 0.1]}}})", folder.path() + "/robots/one", folder.path() + "/run/setup");
  EXPECT_EQ(fs::path(setup.robot).parent_path(), folder.path() + "/run/setup/saved");  // whatever the file calls the robot
  const Model model = load_robot(setup.robot);
  EXPECT_EQ(model.imu_link, 1);
  EXPECT_EQ(model.imu.translation().z(), 0.1);
}

// Whatever lies in setup/ beside it.
TEST(Setup, ARobotMayHaveTheNameOfAFileOfTheSetup) {
  for (const std::string name : {"draft", ".draft", "saved", "answer"}) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() + "/one");
    const std::string inertia =
        "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";
    folder.write("one/one.urdf", "<robot name='" + name + "'><link name='a'>" + inertia + "</link><link name='b'>" + inertia +
                 "</link><joint name='j' type='revolute'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/>"
                 "<limit lower='-1' upper='1' effort='10' velocity='2'/></joint></robot>");
    folder.write("one/robot.yaml", "urdf: one.urdf\n");
    const std::string up = folder.path() + "/setup";
    SetupWishes wishes(up, {.scene = "stand", .robot = "one", .engine = "", .model_hash = 0});
    bool saved = false;
    const std::string first = wishes.save(R"({"save": 1, "limbs": {"imu": {"frame": "b"}}})", folder.path() + "/one", saved);
    EXPECT_TRUE(saved) << first;
    const std::string robot = first.substr(first.find('/'));
    EXPECT_EQ(load_robot(robot).imu_link, 1) << name;
    wishes.answer("{}", "");
    const std::string start = R"({"scene": "stand", "joints": {"j": 0.1}, "limbs": {"imu": {"frame": "b"}}})";
    EXPECT_EQ(load_robot(write_setup(start, folder.path() + "/one", up).robot).imu_link, 1) << name;
    EXPECT_EQ(load_robot(robot).imu_link, 1) << name;
    EXPECT_NE(text_of(up + "/answer"), "") << name;
  }
}

}  // namespace
}  // namespace twinbus::test
