// A ladder that is kept is taken again only for a run that is the same in all that it depends on, and a choice is reported with its seed.

#include "launcher/run/accuracy.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "launcher/run/fit_scene.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"
#include "test/temporary_folder.h"

namespace twinbus {
namespace {

// A closed tetrahedron, its top so high.
std::string tetrahedron(double height) {
  return "v 0 0 0\nv 0.2 0 0\nv 0 0.2 0\nv 0 0 " + std::to_string(height) + "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
}

class LadderKey : public ::testing::Test {
 protected:
  LadderKey() {
    write("body.obj", tetrahedron(0.2));
    write("wall.obj", tetrahedron(0.3));
    write("nod.csv", "time,HEAD_JOINT1\n0,0\n1,0.05\n2,0\n");
    write("scene.yaml",
          "about: A test.\nduration: 3\nmodes:\n  - {at: 0, mode: balance}\n"
          "obstacles:\n  - {shape: mesh, file: wall.obj, position: [3, 0, 0]}\n"
          "loose:\n  - {name: body, shape: mesh, file: body.obj, mass: 1, position: [2, 0, 0.1]}\n"
          "robots:\n  - {name: other, robot: biped12, position: [0, 2]}\n");
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder_.path() + "/" + name) << text; }
  Scene read() const { return load_scene(folder_.path() + "/scene.yaml"); }
  std::string key(const Scene& scene, const OneProcessConfig& config = {}, const AccuracyRequest& request = {.error = 1e-3, .duration = 1.0}) const {
    return ladder_key(model_, scene, config, request).text();
  }

  test::TemporaryFolder folder_;
  Model model_ = load_robot("hrp1s");
};

TEST_F(LadderKey, TheSameRunTwiceHasTheSame) { EXPECT_EQ(key(read()), key(read())); }

TEST_F(LadderKey, AnotherPoseToStartInHasAnother) {
  const std::string before = key(read());
  ASSERT_GT(model_.poses.size(), 1U);
  for (const NamedPose& pose : model_.poses) {
    Scene scene = read();
    if (pose.name == scene.start_pose) continue;
    start_in(pose.name, model_, scene);
    EXPECT_NE(key(scene), before) << pose.name;
  }
}

TEST_F(LadderKey, AnotherPlaceInTheWorldHasAnother) {
  Scene scene = read();
  const std::string before = key(scene);
  scene.origin.x() += 1e4;
  EXPECT_NE(key(scene), before);
}

TEST_F(LadderKey, OtherContentOfAFileThatTheSceneNamesHasAnother) {
  const std::string before = key(read());
  write("body.obj", tetrahedron(0.25));
  const std::string body = key(read());
  EXPECT_NE(body, before);
  write("wall.obj", tetrahedron(0.5));
  EXPECT_NE(key(read()), body);
}

TEST_F(LadderKey, OtherFramesOfAMotionHaveAnother) {
  Scene scene = read();
  scene.motions.emplace_back().file = folder_.path() + "/nod.csv";
  const std::string before = key(scene);
  write("nod.csv", "time,HEAD_JOINT1\n0,0\n1,0.06\n2,0\n");
  EXPECT_NE(key(scene), before);
}

TEST_F(LadderKey, AFurtherRobotOfAnotherFolderHasAnother) {
  Scene scene = read();
  const std::string before = key(scene);
  scene.robots.front().robot = "hrp2p";
  EXPECT_NE(key(scene), before);
}

TEST_F(LadderKey, ADisturbedSceneHasAnother) {
  Scene scene = read();
  const std::string before = key(scene);
  scene.disturbance = small_disturbance();
  EXPECT_NE(key(scene), before);
}

TEST_F(LadderKey, SettingsSeedAndErrorCount) {
  const std::string before = key(read());
  OneProcessConfig config;
  config.settings.emplace_back("model.mass_scale", "1.1");
  EXPECT_NE(key(read(), config), before);
  EXPECT_NE(key(read(), {}, {.error = 2e-3, .duration = 1.0}), before);
  EXPECT_NE(key(read(), {}, {.error = 1e-3, .duration = 1.0, .seed = 2}), before);
}

TEST(AccuracyReport, SaysOfWhichSeedTheChoiceIs) {
  AccuracyChoice choice;
  Rung rung;
  rung.order = 2;
  rung.step = 1e-3;
  rung.apart = 4e-4;
  choice.ladder.rungs = {rung};
  choice.rung = 0;
  const AccuracyRequest asked{.error = 1e-3, .seed = 7};
  const auto json = nlohmann::json::parse(accuracy_json(choice, asked, 2.5));
  EXPECT_EQ(json["seed"], 7);
  EXPECT_EQ(json["order"], 2);
  EXPECT_EQ(json["physics_ms_per_s"], 2.5);
  EXPECT_NE(accuracy_line(choice, asked, 2.5).find("order 2 at 1 ms"), std::string::npos);
  choice.rung = -1;
  EXPECT_NE(accuracy_line(choice, asked, 2.5).find("not held"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
