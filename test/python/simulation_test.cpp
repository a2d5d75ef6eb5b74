// Simulations, worlds and questions to a robot as Python has them.

#include "python/simulation/simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "launcher/run/judge_scene.h"
#include "python/simulation/robot_query.h"
#include "python/simulation/worlds.h"
#include "robot/description/load.h"
#include "sim/scene/scene_seed.h"
#include "test/error_of.h"

namespace twinbus {
namespace {

SimulationConfig scene(const std::string& name, bool controller = true) {
  SimulationConfig config;
  config.scene = name;
  config.controller = controller;
  return config;
}

TEST(Simulation, HasTheStatesOfRun) {
  Simulation simulation(scene("sway"));
  const Model model = load_robot("hrp1s");
  Scene same = load_scene("sway");
  fit_scene(same, model);
  apply_seed(same, model, 1);
  OneProcess run(model, same, OneProcessConfig{});
  for (int i = 0; i < 300; ++i) ASSERT_TRUE(run.tick());
  simulation.step(299);  // the first state was there before
  EXPECT_EQ(simulation.state_hash(), run.state_hash());
  EXPECT_EQ(simulation.state().tick, run.state().tick);
  EXPECT_NEAR(simulation.time(), 299 * model.period(), 1e-12);
}

TEST(Simulation, BeginsAnew) {
  Simulation simulation(scene("stand"));
  const RobotState* const place = &simulation.state();
  simulation.step(50);
  const std::string first = simulation.state_hash();
  simulation.reset(1);
  EXPECT_EQ(simulation.time(), 0.0);
  EXPECT_NE(simulation.state_hash(), first);
  simulation.step(50);
  EXPECT_EQ(simulation.state_hash(), first);
  EXPECT_EQ(&simulation.state(), place);
}

TEST(Simulation, ObeysACommandOfItsOwnAtOnce) {
  Simulation simulation(scene("stand", false));
  const double knee = simulation.state().q[3];
  for (int i = 0; i < 250; ++i) simulation.step(1);
  EXPECT_NEAR(simulation.state().q[3], knee, 2e-3) << "as it was, the command holds the posture";
  EXPECT_FALSE(simulation.truth().fell);
  EXPECT_GT(simulation.truth().foot_force[0][2], 300.0F);
  constexpr int kElbow = 22;
  const double elbow = simulation.state().q[kElbow];
  for (int i = 0; i < 250; ++i) {
    simulation.command().q[kElbow] = elbow - 0.2 * i / 250.0;
    simulation.step(1);
  }
  EXPECT_NEAR(simulation.state().q[kElbow], elbow - 0.2, 0.03);
  EXPECT_EQ(simulation.state().stop_kind, StopKind::kNone);
}

TEST(Simulation, FallsWithoutServosAndSaysSo) {
  Simulation simulation(scene("stand", false));
  simulation.command().kp.fill(0.0F);
  simulation.command().kd.fill(0.0F);
  simulation.command().tau.fill(0.0F);
  simulation.step(1000);
  EXPECT_TRUE(simulation.truth().fell);
  simulation.step(2500);  // until it lies, or a few seconds are over
  EXPECT_EQ(simulation.state().stop_kind, StopKind::kOff);
  simulation.reset(1);
  EXPECT_FALSE(simulation.truth().fell);
  EXPECT_GT(simulation.command().kp[0], 0.0F);
}

TEST(Simulation, RefusesACommandThatIsNone) {
  Simulation simulation(scene("stand", false));
  simulation.command().q[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::error_of([&] { simulation.step(1); }), "command of joint RLEG_KNEE: a number that is not finite");
  simulation.command().q[3] = simulation.state().q[3];
  simulation.command().kd[0] = -1.0F;
  EXPECT_NE(test::error_of([&] { simulation.step(1); }).find("a gain below zero"), std::string::npos);
  simulation.command().kd[0] = 1.0F;
  EXPECT_NE(test::error_of([&] { simulation.step(0); }).find("at least one tick"), std::string::npos);
  simulation.step(1);
}

TEST(Simulation, SaysWhatCannotBeLoaded) {
  EXPECT_NE(test::error_of([] { Simulation(scene("stnd")); }).find("stand"), std::string::npos);
  SimulationConfig config = scene("stand");
  config.engine = "bullet";
  EXPECT_NE(test::error_of([&] { Simulation{config}; }).find("use articulated, ode or mujoco"), std::string::npos);
  config = scene("stand");
  config.settings = {{"sensor.nois", "1"}};
  EXPECT_NE(test::error_of([&] { Simulation{config}; }).find("sensor.nois"), std::string::npos);
  config = scene("stand");
  config.start_pose = "half_siting";
  EXPECT_NE(test::error_of([&] { Simulation{config}; }).find("half_sitting"), std::string::npos);
}

bool equal(const WorldRow& a, const WorldRow& b) {
  return a.state.q == b.state.q && a.state.qd == b.state.qd && a.state.accel == b.state.accel && a.steps == b.steps &&
         a.truth.base_position == b.truth.base_position && a.hand == b.hand;
}

TEST(Worlds, AreTheSameWithAnyNumberOfThreads) {
  Worlds one(scene("stand"), 5, 1), three(scene("stand"), 5, 3);
  EXPECT_EQ(one.threads(), 1);
  EXPECT_EQ(three.threads(), 3);
  for (int round = 0; round < 3; ++round) {
    for (Worlds* worlds : {&one, &three}) {
      for (std::size_t i = 0; i < 5; ++i) worlds->rows()[i].command.q[3] += 0.01 * static_cast<double>(i);
      worlds->step(20);
    }
    for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(equal(one.rows()[i], three.rows()[i])) << i;
  }
  EXPECT_NE(one.rows()[0].state.q[3], one.rows()[4].state.q[3]);
  EXPECT_EQ(one.rows()[0].steps, 60);
}

TEST(Worlds, BeginAnewOneByOne) {
  Worlds worlds(scene("stand"), 3, 2);
  const WorldRow start = worlds.rows()[1];
  for (WorldRow& row : worlds.rows()) {
    row.command.kp.fill(0.0F);
    row.command.kd.fill(0.0F);
    row.command.tau.fill(0.0F);
  }
  worlds.step(1000);
  const WorldRow other = worlds.rows()[0];
  worlds.reset({1}, {2});
  EXPECT_TRUE(equal(worlds.rows()[1], start));
  EXPECT_TRUE(equal(worlds.rows()[0], other));
  EXPECT_GT(worlds.rows()[1].command.kp[0], 0.0F);
  EXPECT_TRUE(worlds.rows()[2].truth.fell);
  EXPECT_FALSE(worlds.rows()[1].truth.fell);
}

TEST(Worlds, RefuseWhatIsNotThere) {
  EXPECT_THROW(Worlds(scene("stand"), 0, 1), std::invalid_argument);
  EXPECT_THROW(Worlds(scene("stand"), 1, -1), std::invalid_argument);
  Worlds worlds(scene("stand"), 2, 2);
  EXPECT_THROW(worlds.reset({2}, {1}), std::invalid_argument);
  EXPECT_THROW(worlds.reset({-1}, {1}), std::invalid_argument);
  EXPECT_THROW(worlds.reset({1, 1}, {1, 2}), std::invalid_argument);
  EXPECT_THROW(worlds.reset({1}, {}), std::invalid_argument);
  worlds.rows()[1].command.tau[0] = std::numeric_limits<float>::infinity();
  EXPECT_NE(test::error_of([&] { worlds.step(1); }).find("world 1: command of joint "), std::string::npos);
  EXPECT_THROW((void)worlds.push(2, 0, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.1), std::invalid_argument);
}

TEST(Worlds, ArePushed) {
  Worlds worlds(scene("stand"), 2, 1);
  ASSERT_EQ(worlds.push(1, 0, {0.0, 300.0, 0.0}, Eigen::Vector3d::Zero(), 0.1), Status::kOk);
  worlds.step(60);
  EXPECT_NEAR(worlds.rows()[0].truth.base_velocity[1], 0.0, 0.01);
  EXPECT_GT(worlds.rows()[1].truth.base_velocity[1], 0.02);
}

TEST(RobotQuery, JacobianIsTheSlopeOfThePose) {
  RobotQuery robot("hrp1s");
  std::vector<double> q(robot.model().bus_joints.size(), 0.1);
  const std::string hand = robot.model().links[static_cast<std::size_t>(robot.model().hands[0].link)].name;
  const RobotQuery::Rows jacobian = robot.jacobian(q, hand);
  const double h = 1e-6;
  double largest = 0.0;
  for (std::size_t k = 0; k < q.size(); ++k) {
    std::vector<double> up = q, down = q;
    up[k] += h;
    down[k] -= h;
    const RobotQuery::Rows above = robot.link_pose(up, hand), below = robot.link_pose(down, hand);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(jacobian[i][k], (above[i][3] - below[i][3]) / (2.0 * h), 1e-7) << k;
      largest = std::max(largest, std::abs(jacobian[i][k]));
    }
  }
  EXPECT_GT(largest, 0.1);
}

TEST(RobotQuery, PlansAndMeasures) {
  RobotQuery robot("hrp1s");
  const Model& model = robot.model();
  const NamedPose& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))];
  std::vector<double> q;
  for (const int j : model.bus_joints) q.push_back(pose.q[static_cast<std::size_t>(j)]);
  const auto near = robot.nearest(q, 5);
  ASSERT_EQ(near.size(), 5U);
  for (std::size_t i = 1; i < near.size(); ++i) EXPECT_LE(near[i - 1].distance, near[i].distance);
  EXPECT_GT(near[0].distance, 0.0);
  const Eigen::Vector3d goal(0.35, 0.25, 0.1);
  const RobotQuery::Path path = robot.plan(q, "left", {.position = goal, .orientation = {}}, {}, 0.4, 1);
  ASSERT_FALSE(path.time.empty()) << path.text;
  for (std::size_t c = 0; c < path.joints.size(); ++c) {
    const int j = model.find_joint(path.joints[c]);
    EXPECT_NEAR(path.q.front()[c], q[static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(j)])], 1e-9);
    q[static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(j)])] = path.q.back()[c];
  }
  const Hand& hand = model.hands[0];
  const RobotQuery::Rows link = robot.link_pose(q, model.links[static_cast<std::size_t>(hand.link)].name);
  Eigen::Matrix4d at;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) at(i, j) = link[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  const Eigen::Vector3d reached = (at * hand.frame.translation().homogeneous()).head<3>();
  EXPECT_LT((reached - goal).norm(), 2e-3);
  EXPECT_FALSE(robot.plan(q, "left", {.position = {5.0, 0.0, 0.0}, .orientation = {}}, {}, 0.4, 1).text.empty());
  EXPECT_TRUE(robot.plan(q, "left", {.position = {5.0, 0.0, 0.0}, .orientation = {}}, {}, 0.4, 1).time.empty());
}

TEST(RobotQuery, NamesWhatIsWrong) {
  RobotQuery robot("hrp1s");
  std::vector<double> q(robot.model().bus_joints.size());
  EXPECT_EQ(test::error_of([&] { (void)robot.com({0.0}); }), "q: 1 numbers, the robot has 29 joints");
  EXPECT_NE(test::error_of([&] { (void)robot.link_pose(q, "CHES"); }).find("CHEST"), std::string::npos);
  EXPECT_EQ(test::error_of([&] { (void)robot.plan(q, "third", {}, {}, 0.4, 1); }), "the robot has no third hand; say one of: left, right");
  EXPECT_EQ(test::error_of([&] { (void)robot.inverse(q, "third", {}); }), "the robot has no third hand; say one of: left, right");
  q[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::error_of([&] { (void)robot.com(q); }), "q of joint RLEG_KNEE is not finite");
}

}  // namespace
}  // namespace twinbus
