#include "sim/scene/scene.h"
#include "sim/scene/scene_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <utility>

#include "robot/description/load.h"
#include "test/collision/post_and_arm.h"
#include "sim/scene/scene_obstacle.h"
#include "sim/scene/scene_ties.h"

namespace twinbus {
namespace {

Scene from_text(const std::string& text) {
  const auto path =
      std::filesystem::temp_directory_path() /
      ("twinbus_scene_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "_" +
       ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml");
  std::ofstream(path) << text;
  struct Remove {
    std::filesystem::path path;
    ~Remove() { std::filesystem::remove(path); }
  } remove{path};
  return load_scene(path.string());
}

std::string complaint(const std::string& text) {
  try {
    (void)from_text(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Scene, EverySceneOfTheInstallationLoadsAndFitsItsRobot) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(config_folder() + "/scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path().string());
    Scene scene = load_scene(entry.path().stem().string());
    const Model model = load_robot(scene.robot);
    EXPECT_NO_THROW(resolve_poses(scene, model));
    EXPECT_GE(model.find_pose(scene.start_pose), 0);
    EXPECT_FALSE(scene.about.empty());
    for (const Push& push : scene.pushes) EXPECT_GE(model.find_link(push.link), 0) << push.link;
    ++count;
  }
  EXPECT_GE(count, 9);
}

TEST(Scene, ReadsWhatItSays) {
  const Scene scene = from_text(
      "robot: hrp1s\nduration: 3\nstep: 0.001\nbase: fixed\nground: {friction: 0.5}\n"
      "obstacles:\n  - {shape: cylinder, size: [0.1, 0.4], position: [1, 2, 3], rpy_deg: [0, 90, "
      "0]}\n"
      "pushes:\n  - {link: CHEST, impulse: [45, 0, 0], at: 2}\n"
      "modes:\n  - {at: 1, mode: balance, motion: sway, amplitude: 0.03, frequency: 0.5}\n"
      "goals:\n  - {at: 2, hand: right, position: [0.4, -0.2, 0.9]}\n"
      "criteria: {max_tilt_deg: 5}\nsettings: {model.mass_scale: 1.03}\n");
  EXPECT_TRUE(scene.fixed_base);
  EXPECT_DOUBLE_EQ(scene.ground_friction, 0.5);
  ASSERT_EQ(scene.obstacles.size(), 1U);
  EXPECT_EQ(scene.obstacles[0].shape, ObstacleShape::kCylinder);
  EXPECT_NEAR(scene.obstacles[0].pose.linear()(0, 2), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(scene.pushes.at(0).duration, 0.1);
  EXPECT_EQ(scene.modes.at(0).request.motion, Motion::kSway);
  EXPECT_EQ(scene.goals.at(0).request.kind, ArmGoalKind::kPosition);
  EXPECT_EQ(scene.goals.at(0).request.side, ArmSide::kRight);
  EXPECT_DOUBLE_EQ(scene.criteria.max_tilt_deg, 5.0);
  EXPECT_TRUE(std::isnan(scene.criteria.slip_max_mm));
  ASSERT_EQ(scene.settings.size(), 1U);
}

TEST(Scene, ReadsLooseBodies) {
  const Scene scene = from_text(
      "loose:\n  - {name: tin, shape: cylinder, size: [0.05, 0.12], mass: 0.5, position: [1, 0, "
      "2], "
      "velocity: [0, 1, 0]}\n"
      "criteria: {loose: [{name: tin, position: [1, 0, 0.06]}]}\n");
  ASSERT_EQ(scene.loose.size(), 1U);
  EXPECT_EQ(scene.loose[0].solid.shape, SolidShape::kCylinder);
  EXPECT_DOUBLE_EQ(scene.loose[0].start.velocity.y(), 1.0);
  EXPECT_NEAR(scene.loose[0].damping, std::sqrt(0.25 * 1e5 * 0.5), 1e-9);
  EXPECT_EQ(scene.criteria.loose.at(0).name, "tin");
  const std::string box = "{name: a, size: [1, 1, 1], mass: 1, position: [0, 0, 0]";
  EXPECT_NE(complaint("loose:\n  - " + box + ", mas: 2}\n").find("mas"), std::string::npos);
  EXPECT_NE(complaint("loose:\n  - " + box + "}\n  - " + box + "}\n").find("'a'"),
            std::string::npos);
  EXPECT_NE(complaint("loose:\n  - {name: a, size: [1, 1, 1], mass: 0, position: [0, 0, 0]}\n")
                .find("mass"),
            std::string::npos);
  EXPECT_NE(complaint("criteria: {loose: [{name: b, position: [0, 0, 0]}]}\n").find("'b'"),
            std::string::npos);
}

TEST(Scene, MayBeginFarFromTheOriginButNotBeyondWhatEnginesTake) {
  EXPECT_EQ(from_text("origin: [10000, -5]\n").origin, Eigen::Vector2d(10000, -5));
  EXPECT_NE(complaint("origin: [1e6, 0]\n").find("within 100000 m"), std::string::npos);
  EXPECT_NE(complaint("origin: [1]\n"), "");
}

TEST(Scene, ReadsFurtherRobots) {
  const Scene scene = from_text(
      "self_contact: true\nrobots:\n  - {name: second, position: [1, 2], yaw_deg: 90}\n"
      "  - {name: third, robot: biped12, pose: zero, position: [0, 3]}\n"
      "criteria: {robots: [{name: second, within_m: 0.5}]}\n");
  EXPECT_TRUE(scene.self_contact);
  ASSERT_EQ(scene.robots.size(), 2U);
  EXPECT_EQ(scene.robots[0].robot, "hrp1s");
  EXPECT_NEAR(scene.robots[0].place.linear()(1, 0), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(scene.robots[0].place.translation().y(), 2.0);
  EXPECT_EQ(scene.robots[1].robot, "biped12");
  EXPECT_DOUBLE_EQ(scene.criteria.robots.at(0).within, 0.5);
  EXPECT_NE(complaint("robots:\n  - {name: a, position: [0, 0]}\n  - {name: a, position: [1, 0]}\n")
                .find("'a'"),
            std::string::npos);
  EXPECT_NE(complaint("robots:\n  - {name: a, position: [0, 1e9]}\n").find("position"),
            std::string::npos);
  EXPECT_NE(complaint("criteria: {robots: [{name: b}]}\n").find("'b'"), std::string::npos);
}

TEST(Scene, AWrongKeyNamesFileLineAndTheNearest) {
  const std::string text = complaint("duration: 3\nobstacels: []\n");
  EXPECT_NE(text.find(".yaml:2"), std::string::npos) << text;
  EXPECT_NE(text.find("obstacles"), std::string::npos) << text;
  EXPECT_NE(complaint("settings: {model.mas_scale: 1}\n").find("model.mass_scale"),
            std::string::npos);
  EXPECT_NE(complaint("pushes:\n  - {link: A, impuls: [1, 0, 0], at: 1}\n"), "");
}

TEST(Scene, LoopsAndGraspsAreRead) {
  const Scene scene = from_text(
      "loops:\n  - {link: LHAND, point: [0, 0, 0.1], to: RHAND, stiffness: 1.0e+6}\n"
      "grasps:\n  - {link: LHAND, to: box, at: 1, until: 3}\n");
  ASSERT_EQ(scene.loops.size(), 1U);
  EXPECT_EQ(scene.loops[0].to, "RHAND");
  EXPECT_DOUBLE_EQ(scene.loops[0].damping, 1e3);
  EXPECT_LT(scene.loops[0].length, 0.0);
  ASSERT_EQ(scene.grasps.size(), 1U);
  EXPECT_DOUBLE_EQ(scene.grasps[0].until, 3.0);
  EXPECT_NE(complaint("grasps:\n  - {link: LHAND, to: box, at: 3, until: 1}\n"), "");
  EXPECT_NE(complaint("loops:\n  - {link: LHAND, stiffness: 0}\n"), "");
}

// Which of the two a tie means is not guessed.
TEST(Scene, ALooseBodyThatATieNamesIsNotCalledLikeALink) {
  const Model model = load_robot("hrp1s");
  const auto complaint_of = [&](const std::string& name, const std::string& loop) {
    const Scene scene =
        from_text("loose:\n  - {name: " + name +
                  ", size: [1, 1, 1], mass: 1, position: [0, 0, 0]}\nloops:\n  - " + loop + "\n");
    try {
      const SceneTies ties(model, {}, scene);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint_of("box", "{link: LHAND, to: box}"), "");
  EXPECT_EQ(complaint_of("RHAND", "{link: LHAND, to: CHEST}"), "");  // no tie names it
  for (const std::string name : {"RHAND", "world"}) {
    const std::string said = complaint_of(name, "{link: LHAND, to: " + name + "}");
    EXPECT_NE(said.find(".yaml:2: name: a tie names '" + name + "'"), std::string::npos) << said;
    EXPECT_NE(said.find("another name"), std::string::npos) << said;
  }
}

TEST(Scene, WrongValuesAreRefused) {
  for (const char* text :
       {"duration: -1\n", "duration: x\n", "base: flying\n", "engine: magic\n", "contact: jelly\n",
        "step: 0\n", "obstacles:\n  - {shape: box, size: [1, 1], position: [0, 0, 0]}\n",
        "obstacles:\n  - {shape: box, size: [1, 1, .nan], position: [0, 0, 0]}\n",
        "pushes:\n  - {link: A, impulse: [1, 0, .inf], at: 1}\n", "modes:\n  - {at: 1}\n",
        "modes:\n  - {at: 1, mode: dance}\n", "modes:\n  - {at: 1, mode: pose}\n",
        "goals:\n  - {at: 1, position: [0, 0, 0]}\n", "settings: {model.mass_scale: heavy}\n",
        "[1, 2\n", "3\n"}) {
    EXPECT_NE(complaint(text), "") << text;
  }
}

TEST(Scene, AnUnknownNameListsThoseThatThereAre) {
  try {
    (void)load_scene("stnad");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("stand"), std::string::npos);
  }
}

TEST(Scene, APoseIsTakenFromTheRobot) {
  const Model model = load_robot("hrp1s");
  Scene scene = from_text(
      "modes:\n  - {at: 1, mode: pose, pose: half_sitting}\n"
      "goals:\n  - {at: 1, hand: left, pose: half_sitting}\n");
  resolve_poses(scene, model);
  EXPECT_EQ(scene.modes[0].request.joint_mask, (std::int64_t{1} << 29) - 1);
  EXPECT_GT(std::abs(scene.modes[0].request.q[3]), 0.5);  // a knee
  EXPECT_EQ(__builtin_popcountll(static_cast<unsigned long long>(scene.goals[0].request.joint_mask)),
            7);
  Scene wrong = from_text("modes:\n  - {at: 1, mode: pose, pose: handstand}\n");
  EXPECT_THROW(resolve_poses(wrong, model), std::runtime_error);
}

// Names by what they are: the same scene is for robots whose links are called otherwise.
TEST(Scene, PlacesAreFoundByWhatTheyAre) {
  const Model model = load_robot("hrp1s");
  EXPECT_EQ(find_place(model, "chest"), model.find_link("CHEST"));
  EXPECT_EQ(find_place(model, "CHEST"), model.find_link("CHEST"));
  EXPECT_EQ(find_place(model, "base"), 0);
  EXPECT_EQ(find_place(model, "right_hand"), model.hands[1].link);
  EXPECT_EQ(find_place(model, "left_foot"), model.soles[0].link);
  EXPECT_EQ(find_place(model, "third_hand"), -1);
  EXPECT_EQ(find_joint_place(model, "left_ankle_pitch"), model.find_joint("LLEG_ANKLE_P"));
  EXPECT_EQ(find_joint_place(model, "right_knee"), model.find_joint("RLEG_KNEE"));
  EXPECT_EQ(find_joint_place(model, "left_thumb"), -1);
  Scene scene = from_text(
      "pushes:\n  - {link: chest, impulse: [1, 0, 0], at: 1}\n"
      "bodies:\n  - {link: left_hand, mass: 1}\n");
  resolve_poses(scene, model);
  EXPECT_EQ(scene.pushes[0].link, "CHEST");
  EXPECT_EQ(scene.bodies[0].link, model.links[static_cast<std::size_t>(model.hands[0].link)].name);
}

TEST(Scene, AnArmOnAFixedBaseKnowsTheFloorThatItBeginsAbove) {
  Model arm = post_and_arm();  // its post ends 0.05 m below the ground
  arm.floating_base = false;
  arm.hands[1].link = 1;
  arm.hands[1].joints = {0};
  arm.joints[0].axis = Eigen::Vector3d::UnitY();
  arm.joints[0].placement.translation().z() = 0.2;
  Scene scene;
  resolve_poses(scene, arm);
  resolve_poses(scene, arm);
  ASSERT_EQ(scene.obstacles.size(), 4U);  // around the post
  for (const Obstacle& floor : scene.obstacles) {
    EXPECT_NEAR(floor.pose.translation().z() + 0.5 * floor.size.z(), 0.0, 1e-9);
    EXPECT_GT(floor.pose.translation().head<2>().cwiseAbs().maxCoeff(), 0.5);
  }
  EXPECT_EQ(begins_in_ground(scene, arm), "");
  // Of what stands on a long side the floor begins beside it, not where its farthest corner is.
  arm.links[0].collision[0].size.x() = 1.0;
  arm.links[0].collision[0].pose.translation().x() = 0.2;
  Scene narrow;
  resolve_poses(narrow, arm);
  const auto on_floor = [&](double x, double y) {
    return std::any_of(narrow.obstacles.begin(), narrow.obstacles.end(), [&](const Obstacle& floor) {
      return std::abs(x - floor.pose.translation().x()) < 0.5 * floor.size.x() && std::abs(y - floor.pose.translation().y()) < 0.5 * floor.size.y();
    });
  };
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(on_floor(0.1, side * 0.12));
    EXPECT_FALSE(on_floor(0.1, side * 0.10)) << "50 mm from it";
    EXPECT_TRUE(on_floor(0.2 + side * 0.57, 0.0));
    EXPECT_FALSE(on_floor(0.2 + side * 0.55, 0.0));
  }
  Scene below;
  arm.joints[0].placement.translation().z() = -0.2;
  resolve_poses(below, arm);
  EXPECT_TRUE(below.obstacles.empty());
  EXPECT_NE(begins_in_ground(below, arm).find("in the ground"), std::string::npos);
  Scene walks;
  arm.joints[0].placement.translation().z() = 0.0;
  arm.floating_base = true;
  resolve_poses(walks, arm);
  EXPECT_TRUE(walks.obstacles.empty());
}

// What the arm would begin in is turned about its shoulder, with all that belongs to it; a hand points by its looks, not by its axes.
TEST(Scene, WhatStandsAroundAnArmIsTurnedWhereItBeginsClear) {
  Model arm = post_and_arm();  // with a free base: a body may lean to goals that its arm does not reach
  arm.hands[1].link = 1;
  arm.hands[1].joints = {0};
  arm.hands[1].frame.translation().x() = 0.3;
  arm.hands[1].frame.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const Eigen::Vector3d shoulder(-0.3, 0.0, 0.0);
  for (const double beside : {0.0, 0.6}) {  // in the arm, and far from it
    Scene scene = from_text("lengths: arm\nobstacles: [{shape: box, size: [0.1, 0.1, 0.1], position: [0.5, " + std::to_string(beside) +
                            ", 0]}]\ngoals: [{at: 1, hand: right, reach: [0.5, 0.2, 0.1], rpy_deg: [180, 0, 0]}]\n");
    resolve_poses(scene, arm);
    resolve_poses(scene, arm);
    const Eigen::Vector3d thing = (scene.obstacles[0].pose.translation() - shoulder) / 0.3;
    const auto& [x, y, z] = scene.goals[0].request.position;
    const Eigen::Vector3d goal = (Eigen::Vector3d(x, y, z) - shoulder) / 0.3;
    EXPECT_NEAR(thing.norm(), std::hypot(0.5, beside), 1e-6);
    EXPECT_NEAR((goal - thing).norm(), std::hypot(0.2 - beside, 0.1), 1e-6);
    const double turned = std::abs(std::atan2(thing.y(), thing.x()) - std::atan2(beside, 0.5));
    if (beside > 0.0) EXPECT_NEAR(turned, 0.0, 1e-9);
    else EXPECT_NEAR(turned, M_PI / 6.0, 1e-9);  // 0.129 of the arm to the side is not enough, 0.25 is
    const auto& [w, i, j, k] = scene.goals[0].request.orientation;
    const Eigen::Vector3d points = Eigen::Quaterniond(w, i, j, k) * -Eigen::Vector3d::UnitX();  // from the joint to the hand
    EXPECT_NEAR(points.z(), -1.0, 1e-6);
  }
}

// From one goal to the next the slowest joint can turn once around; a fast arm goes by the times of the file.
TEST(Scene, ASlowArmIsGivenTime) {
  Model model = load_robot("hrp1s");
  for (const bool slow : {false, true}) {
    for (const int joint : model.hands[1].joints) model.joints[static_cast<std::size_t>(joint)].velocity = slow ? 0.6 : 6.0;
    Scene scene = load_scene("arm_pick");
    resolve_poses(scene, model);
    resolve_poses(scene, model);
    const double later = slow ? (2.0 + 2.0 * M_PI / (0.5 * 0.6)) / 12.0 : 1.0;
    EXPECT_NEAR(scene.goals[1].at, 13.0 * later, 1e-6);
    EXPECT_NEAR(scene.grasps[0].until, 26.0 * later, 1e-6);
    EXPECT_NEAR(scene.duration, 44.0 * later, 1e-6);
  }
}

TEST(Scene, ARobotWithOneHandUsesItForEitherAndAFixedOneHolds) {
  Model model = load_robot("hrp1s");
  model.hands[0] = Hand{};
  model.floating_base = false;
  Scene scene = from_text(
      "modes:\n  - {at: 0, mode: balance}\n"
      "goals:\n  - {at: 1, hand: left, pose: half_sitting}\n");
  resolve_poses(scene, model);
  EXPECT_EQ(scene.goals[0].request.side, ArmSide::kRight);
  EXPECT_NE(scene.goals[0].request.joint_mask, 0);
  EXPECT_EQ(scene.modes[0].request.mode, Mode::kHold);
}

TEST(Accuracy, IsALengthWithItsUnitAndAPlainOneIsNotTakenForAMillimetre) {
  double metres = 0.0;
  for (const auto& [text, asked] : {std::pair("0.001", 1e-3), std::pair("1mm", 1e-3), std::pair("0.1 mm", 1e-4),
                                    std::pair("20 um", 2e-5), std::pair("1cm", 1e-2), std::pair("0.1", 0.1)}) {
    EXPECT_EQ(read_accuracy(text, metres), "") << text;
    EXPECT_DOUBLE_EQ(metres, asked) << text;
  }
  for (const char* text : {"1", "1m", "0.11", "1e-10", "20"})
    EXPECT_NE(read_accuracy(text, metres).find("from 1e-9 to 0.1 m"), std::string::npos) << text;
  EXPECT_EQ(read_accuracy("1", metres), "is 1 m, and must be from 1e-9 to 0.1 m; millimetres are written 1mm");
  for (const char* text : {"", "mm", "-1mm", "0", "1 inch", "nan", "inf", "1e400", "0x"})
    EXPECT_NE(read_accuracy(text, metres).find("must be a length"), std::string::npos) << text;
}

}  // namespace
}  // namespace twinbus
