// Engine mujoco against closed formulas and the other engines.  Skipped where no MuJoCo is found, but for what needs none.

#include "sim/mujoco/mujoco_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <vector>

#include "common/text/strict_yaml.h"
#include "robot/description/load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/make_world.h"
#include "sim/mujoco/find_mujoco.h"
#include "sim/mujoco/mujoco_library.h"
#include "sim/world/felt_feet.h"
#include "sim/world/static_equilibrium.h"
#include "test/error_of.h"
#include "test_models.h"

namespace twinbus {
namespace {

class MujocoWorldTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      (void)MujocoLibrary::get();
    } catch (const std::exception& error) {
      GTEST_SKIP() << error.what();
    }
  }
  static std::unique_ptr<World> make(const Model& model, WorldConfig config = {}) {
    config.engine = Engine::kMujoco;
    return make_world(model, config);
  }
  // Far from the ground.
  static std::unique_ptr<World> make_high(const Model& model, Configuration& start) {
    auto world = make(model);
    start.base.translation().z() = 50.0;
    EXPECT_EQ(world->set(start), Status::kOk);
    return world;
  }
};

TEST(FindMujoco, AWrongVariableIsSaidWithItsRemedy) {
  const char* before = std::getenv("TWINBUS_MUJOCO");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TWINBUS_MUJOCO", "/nowhere/libmujoco.so", 1);
  const std::string text = test::error_of([] { (void)mujoco_files(); });
  if (before != nullptr) {
    ::setenv("TWINBUS_MUJOCO", kept.c_str(), 1);
  } else {
    ::unsetenv("TWINBUS_MUJOCO");
  }
  EXPECT_NE(text.find("TWINBUS_MUJOCO=/nowhere/libmujoco.so"), std::string::npos) << text;
  EXPECT_NE(text.find("pip install mujoco"), std::string::npos) << text;
}

// Said before the library is looked for, so it needs none.
TEST(MujocoWorld, WhatItDoesNotKnowIsRefusedByName) {
  const Model model = test::chain(2, true);
  const auto refusal = [&](const std::function<void(WorldConfig&)>& change) {
    WorldConfig config;
    config.engine = Engine::kMujoco;
    change(config);
    return test::error_of([&] { (void)make_world(model, config); });
  };
  EXPECT_NE(refusal([](WorldConfig& c) { c.contact = ContactModel::kPatch; }).find("contact patch"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.contact = ContactModel::kRigid; }).find("contact rigid"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.continuous = true; }).find("contact.continuous"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.order = 2; }).find("solver.order 2"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.flight = Flight::kRk4; }).find("solver.flight"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.stiffness_scale = 0.8; }).find("stiffness_scale"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.ground_height[1] = 0.01; }).find("one ground"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.robots.emplace_back(); }).find("further robots"), std::string::npos);
  EXPECT_NE(refusal([](WorldConfig& c) { c.ties.emplace_back(); }).find("no loops"), std::string::npos);
}

TEST_F(MujocoWorldTest, AFreeRobotFallsWithG) {
  const Model model = test::chain(6, true);
  const auto world = make(model);
  Configuration start(model);
  start.base.translation().z() = 50.0;
  start.qd << 0.5, -1.0, 0.3, 0.8, -0.2, 0.4;
  ASSERT_EQ(world->set(start), Status::kOk);
  const Eigen::Vector3d com = world->com(), velocity = world->com_velocity();
  for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR((world->com_velocity() - velocity).z(), -kGravity, 1e-3);
  EXPECT_NEAR(world->com().z() - com.z() - velocity.z(), -0.5 * kGravity * 1.002, 2e-3);
  EXPECT_NEAR(world->com_velocity().x(), velocity.x(), 1e-3);
}

TEST_F(MujocoWorldTest, AStateThatIsSetIsRead) {
  const Model model = test::chain(4, true);
  const auto world = make(model);
  Configuration start(model);
  start.base.translation() << 1.0, -2.0, 3.0;
  start.base.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  start.base_velocity << 0.1, -0.2, 0.3;
  start.base_angular_velocity << -0.4, 0.5, 0.6;
  start.q << 0.1, -0.2, 0.3, -0.4;
  start.qd << 1.0, 2.0, -3.0, 0.5;
  ASSERT_EQ(world->set(start), Status::kOk);
  ASSERT_EQ(world->step(), Status::kOk);  // 2 ms
  const Configuration& now = world->configuration();
  EXPECT_LT((now.base.translation() - start.base.translation() - 0.002 * start.base_velocity).norm(), 2e-4);
  EXPECT_LT((now.base_angular_velocity - start.base_angular_velocity).norm(), 0.1);
  EXPECT_LT((now.q - start.q - 0.002 * start.qd).norm(), 2e-4);
  EXPECT_LT((now.base.linear() - start.base.linear()).norm(), 4e-3);
}

// One step after the other of a pendulum on a fixed base.
TEST_F(MujocoWorldTest, TheServoHasTheSpringOfTheStartAndTheDamperOfTheEnd) {
  const Model model = test::pendulum(1e5);
  for (const double kp : {4000.0, 40000.0}) {  // of the second both are of the end
    WorldConfig config;
    config.fixed_base = true;
    const auto world = make(model, config);
    Configuration start(model);
    start.base.translation().z() = 3.0;
    start.q[0] = 0.95;
    start.qd[0] = -0.7;
    ASSERT_EQ(world->set(start), Status::kOk);
    EXPECT_NEAR(world->link_in_world(0).translation().z(), 3.0, 1e-12);
    const ServoTarget target{.q = 1.0, .qd = 0.5, .tau = 3.0, .kp = kp, .kd = 50.0};
    ASSERT_EQ(world->set_servo(0, target), Status::kOk);
    double q = 0.95, qd = -0.7;
    const double h = config.step;
    for (int i = 0; i < 100; ++i) {
      const double gravity = -2.0 * kGravity * 0.5 * std::sin(q);
      const double spring = target.kp * (target.q - q) + target.kd * target.qd + target.tau;
      const double gain = target.kd + (kp > 1e4 ? h * kp : 0.0);
      qd = (test::kPendulumInertia * qd + h * (gravity + spring)) / (test::kPendulumInertia + h * gain);
      ASSERT_EQ(world->step(), Status::kOk);
      EXPECT_NEAR(world->configuration().qd[0], qd, 1e-8) << i;
      EXPECT_NEAR(world->tau(0), spring - gain * qd, 1e-5) << i;
      q += h * qd;
    }
  }
}

TEST_F(MujocoWorldTest, AServoGivesNoMoreThanItsLimit) {
  const Model model = test::pendulum(5.0);
  WorldConfig config;
  config.fixed_base = true;
  const auto world = make(model, config);
  Configuration start(model);
  start.base.translation().z() = 3.0;
  ASSERT_EQ(world->set(start), Status::kOk);
  ASSERT_EQ(world->set_servo(0, {.q = 1.0, .qd = 0.0, .tau = 0.0, .kp = 1e4, .kd = 0.0}), Status::kOk);
  ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_DOUBLE_EQ(world->tau(0), 5.0);
  EXPECT_NEAR(world->configuration().qd[0], 0.002 * 5.0 / test::kPendulumInertia, 1e-9);
}

TEST_F(MujocoWorldTest, APushIsAChangeOfMomentum) {
  const Model model = test::chain(4, true);
  Configuration start(model);
  const auto world = make_high(model, start);
  const Eigen::Vector3d before = world->com_velocity();
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(world->push(2, world->link_in_world(2).translation(), {4.0, -2.0, 0.0}), Status::kOk);
    ASSERT_EQ(world->step(), Status::kOk);
  }
  const Eigen::Vector3d gained = world->mass() * (world->com_velocity() - before);
  EXPECT_NEAR(gained.x(), 0.4, 5e-3);
  EXPECT_NEAR(gained.y(), -0.2, 5e-3);
  const Eigen::Vector3d then = world->com_velocity();
  ASSERT_EQ(world->step(), Status::kOk);  // the force was of one step only
  EXPECT_NEAR(world->com_velocity().x(), then.x(), 1e-3);
}

TEST_F(MujocoWorldTest, HrpStandsAndItsSolesCarryItsWeight) {
  const Model model = load_robot("hrp1s");
  const auto world = make(model);
  const NamedPose& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))];
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(pose.q.data(), model.joint_count());
  const Standing standing = stand(model, q, 1.0, {world->corner_stiffness(0), world->corner_stiffness(1)}, {0.0, 0.0}, false);
  ASSERT_EQ(world->set(standing.configuration, &standing.tau), Status::kOk);
  const FeltFeet feet = felt_feet(model);
  const auto weight = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const ContactPoint& each : world->contacts()) {
      EXPECT_TRUE(feet.foot[0].feels(each) || feet.foot[1].feels(each));
      sum += each.force;
    }
    return sum;
  };
  EXPECT_NEAR(weight().z(), model.total_mass() * kGravity, 0.1 * model.total_mass() * kGravity);  // from the first moment
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joints[static_cast<std::size_t>(j)];
    const double q_wanted = standing.configuration.q[j];
    (void)world->set_servo(j, {.q = q_wanted, .qd = 0.0, .tau = standing.tau[j], .kp = joint.kp, .kd = joint.kd});
  }
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(weight().z(), model.total_mass() * kGravity, 0.01 * model.total_mass() * kGravity);
  EXPECT_NEAR(world->configuration().base.translation().z(), standing.configuration.base.translation().z(), 2e-3);
  EXPECT_GT(world->configuration().base.linear()(2, 2), 0.9999);
}

// What robot.yaml says of MuJoCo's solver and contacts is what MuJoCo is given, and a robot stands on one iteration of it.
TEST_F(MujocoWorldTest, SolverAndContactsAreThoseOfRobotYaml) {
  Model model = test::block();
  const auto slid = [&](const std::string& yaml, double ground, double speed = 1.0) {
    model.mujoco = read_mujoco_config(ConfigNode::parse("{" + yaml + "}", "robot.yaml"));
    WorldConfig config;
    config.ground_friction = ground;
    const auto world = make(model, config);
    Configuration start(model);
    start.base.translation().z() = 0.0;
    start.base_velocity.x() = speed;
    EXPECT_EQ(world->set(start), Status::kOk);
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(world->step(), Status::kOk);
    EXPECT_LT(world->com_velocity().norm(), 1e-2);
    EXPECT_NEAR(world->configuration().base.translation().z(), 0.0, 2e-3);
    return world->com().x();
  };
  model.frames = {{model.links[0].name, 0, Eigen::Isometry3d::Identity()}};
  const std::string contact = "contacts: [{links: [" + model.links[0].name + "], friction: [0.2, 0.005, 0.0001]}]";
  const double usual = slid("", 0.8);
  const double slippery = slid(contact, 0.8);
  EXPECT_GT(slippery, 1.5 * usual);
  EXPECT_LT(slid(contact, 3.2), 0.8 * slippery);  // on a ground that holds better
  EXPECT_NEAR(slid("iterations: 1, ls_iterations: 5, " + contact, 0.8, 0.0), slid("", 0.8, 0.0), 2e-3);
  EXPECT_NE(test::error_of([&] { (void)slid("iteration: 1", 0.8); }).find("iterations"), std::string::npos);
}

// MuJoCo's contact is as stiff as what it carries is heavy.
TEST_F(MujocoWorldTest, ALooseBoxComesToRestAsDeepWhateverItsMass) {
  const Model model = test::pendulum(10.0);
  std::vector<double> depths;
  for (const double mass : {0.5, 20.0}) {
    WorldConfig config;
    config.fixed_base = true;
    LooseBody box;
    box.name = "box";
    box.solid = {SolidShape::kBox, {0.2, 0.2, 0.2}};
    box.mass = mass;
    box.start.pose.translation() << 2.0, 0.0, 0.15;
    config.loose.push_back(box);
    const auto world = make(model, config);
    Configuration start(model);
    start.base.translation().z() = 3.0;
    ASSERT_EQ(world->set(start), Status::kOk);
    ASSERT_EQ(world->loose_count(), 1);
    for (int i = 0; i < 1500; ++i) ASSERT_EQ(world->step(), Status::kOk);
    EXPECT_LT(world->loose(0).velocity.norm(), 1e-3);
    depths.push_back(0.1 - world->loose(0).pose.translation().z());
  }
  EXPECT_GT(depths[0], 1e-5);
  EXPECT_LT(depths[0], 5e-4);
  EXPECT_NEAR(depths[0], depths[1], 1e-6);
}

TEST_F(MujocoWorldTest, WhatDivergesIsFrozenWhereItWas) {
  const Model model = test::chain(4, true);
  Configuration start(model);
  const auto world = make_high(model, start);
  const Eigen::Vector3d far = world->link_in_world(1).translation() + Eigen::Vector3d(900.0, 0.0, 0.0);
  ASSERT_EQ(world->push(1, far, {0.0, 0.0, 1e6}), Status::kOk);
  EXPECT_EQ(world->step(), Status::kDiverged);
  EXPECT_EQ(world->step(), Status::kDiverged);
  EXPECT_NEAR(world->configuration().base.translation().z(), 50.0, 1e-12);
  ASSERT_EQ(world->set(start), Status::kOk);
  EXPECT_EQ(world->step(), Status::kOk);
}

}  // namespace
}  // namespace twinbus
