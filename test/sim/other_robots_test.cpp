// Further robots in the one solve, and links of a robot that touch one another.

#include "sim/objects/other_robots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "sim/engine/articulated_world.h"
#include "common/allocation/no_alloc.h"
#include "test_models.h"

namespace twinbus {
namespace {

Configuration on_the_ground(const Model& model, double x, double y) {
  Configuration start(model);
  start.q.setZero();
  start.qd.setZero();
  const double sink = model.total_mass() * kGravity / (2.0 * model.soles[0].stiffness);
  start.base.translation() = Eigen::Vector3d(x, y, -sink);
  return start;
}

OtherRobot a_block(const std::string& name, double x, double y) {
  OtherRobot robot;
  robot.name = name;
  robot.model = std::make_shared<const Model>(test::block());
  robot.start = on_the_ground(*robot.model, x, y);
  robot.servos.resize(1);
  return robot;
}

TWINBUS_BOTH_ENGINES(SeveralRobots);

// Both slide, turn and stop in the same way, 10 m apart.
TEST_P(SeveralRobots, OneMovesAsTheCommandedRobotDoes) {
  const Model model = test::block();
  for (const int order : {1, 2}) {
    if (is_ode() && order > 1) continue;
    WorldConfig config;
    config.step = 1e-3;
    config.order = order;
    config.robots = {a_block("second", 0.0, 10.0)};
    Configuration start = on_the_ground(model, 0.0, 0.0);
    for (Configuration* each : {&start, &config.robots[0].start}) {
      each->base_velocity = {0.5, 0.2, 0.0};
      each->base_angular_velocity = {0.0, 0.0, 1.0};
      each->qd[0] = 2.0;
    }
    config.robots[0].servos[0] = {.q = 0.5, .kp = 10.0, .kd = 0.1};
    const auto world = make(model, config);
    ASSERT_EQ(world->set(start), Status::kOk);
    ASSERT_EQ(world->set_servo(0, config.robots[0].servos[0]), Status::kOk);
    for (int i = 0; i < 300; ++i) ASSERT_EQ(world->step(), Status::kOk);
    EXPECT_GT(world->link_in_world(0).translation().x(), 0.01);
    for (int link = 0; link < 2; ++link) {
      const Eigen::Isometry3d own = world->link_in_world(link), other = world->robot_link(0, link);
      const Eigen::Vector3d apart = other.translation() - own.translation();
      EXPECT_LT((apart - Eigen::Vector3d(0, 10, 0)).norm(), 1e-9) << order;
      EXPECT_LT((own.linear() - other.linear()).norm(), 1e-9) << order;
    }
  }
}

TEST_P(SeveralRobots, WhatOneGivesInABumpTheOtherGets) {
  const Model model = test::block();
  WorldConfig config;
  config.step = 1e-3;
  config.ground_friction = 0.0;
  config.robots = {a_block("second", 0.45, 0.0)};
  const auto world = make(model, config);
  Configuration start = on_the_ground(model, 0.0, 0.0);
  start.base_velocity.x() = 1.0;
  ASSERT_EQ(world->set(start), Status::kOk);
  const auto com_of_other = [&] {
    double sum = 0.0;
    for (int i = 0; i < 2; ++i) {
      const Link& link = model.links[static_cast<std::size_t>(i)];
      sum += link.mass * (world->robot_link(0, i) * link.com).x();
    }
    return sum / model.total_mass();
  };
  double before = com_of_other(), velocity = 0.0, own = 1.0, most = 0.0;
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(world->step(), Status::kOk);
    const double now = com_of_other();
    velocity = (now - before) / config.step;
    before = now;
    own = world->com_velocity().x();
    for (const ContactPoint& c : world->contacts()) most = std::max(most, -c.force.x());
    EXPECT_NEAR(own + velocity, 1.0, 2e-3) << i;
  }
  EXPECT_GT(velocity, 0.4);
  EXPECT_LT(own, 0.6);
  EXPECT_GT(most, 100.0);  // and feels it
}

TEST_P(SeveralRobots, TwoThatAreTiedStandAtEveryStepAndStiffness) {
  const Model model = test::block();
  for (const double k : {1e6, 1e8}) {
    for (const double h : {1e-4, 1e-3, 1e-2}) {
      WorldConfig config;
      config.step = h;
      config.robots = {a_block("second", 1.0, 0.0)};
      Tie tie;
      tie.a = {0, -1, {0.5, 0.0, 0.1}};
      tie.b = {0, -1, {-0.5, 0.0, 0.1}, 0};
      tie.stiffness = k;
      tie.damping = 1e-3 * k;
      config.ties = {tie};
      const auto world = make(model, config);
      Configuration start = on_the_ground(model, 0.0, 0.0);
      start.base_velocity = {0.1, 0.1, 0.0};
      ASSERT_EQ(world->set(start), Status::kOk);
      const auto gap = [&] {
        return (world->link_in_world(0) * tie.a.point - world->robot_link(0, 0) * tie.b.point)
            .norm();
      };
      for (int i = 0; i < std::lround(0.3 / h); ++i) {
        ASSERT_EQ(world->step(), Status::kOk);
        EXPECT_LT(gap(), 1e-3) << k << ' ' << h;
      }
      EXPECT_LT(world->com_velocity().norm(), 0.01) << k << ' ' << h;
      if (is_ode()) continue;
      EXPECT_EQ(dynamic_cast<const ArticulatedWorld&>(*world).unconverged(), 0) << k << ' ' << h;
    }
  }
}

TEST(OtherRobots, AHumanoidThatIsBumpedStaysOnItsFeet) {
  const auto model = std::make_shared<const Model>(load_robot("hrp1s"));
  const int pose = model->find_pose("half_sitting");
  ASSERT_GE(pose, 0);
  Eigen::VectorXd q(model->joint_count());
  for (int j = 0; j < q.size(); ++j) {
    q[j] = model->poses[static_cast<std::size_t>(pose)].q[static_cast<std::size_t>(j)];
  }
  Eigen::Isometry3d ahead = Eigen::Isometry3d::Identity();
  ahead.translation().x() = 0.30;
  OtherRobot own = standing_robot("own", model, q, Eigen::Isometry3d::Identity());
  WorldConfig config;
  config.step = 2e-3;
  config.robots = {standing_robot("second", model, q, ahead)};
  ArticulatedWorld world(*model, config);
  own.start.base_velocity.x() = 0.3;
  ASSERT_EQ(world.set(own.start), Status::kOk);
  for (int j = 0; j < q.size(); ++j) {
    ASSERT_EQ(world.set_servo(j, own.servos[static_cast<std::size_t>(j)]), Status::kOk);
  }
  long touched = 0;
  for (int i = 0; i < 750; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    for (const Contact& c : world.solved()) {
      touched += c.other_system >= 0 && c.now.mode != ContactMode::kOpen ? 1 : 0;
    }
  }
  EXPECT_GT(touched, 0);
  EXPECT_GT(world.link_in_world(0).linear()(2, 2), 0.99);
  EXPECT_GT(world.robot_link(0, 0).linear()(2, 2), 0.99);
  EXPECT_EQ(world.unconverged(), 0);
  const NoAlloc no_alloc;
  for (int i = 0; i < 50; ++i) (void)world.step();
  const std::int64_t allocated = no_alloc.count();
  EXPECT_EQ(allocations_counted() ? allocated : 0, 0);
}

TEST_P(SeveralRobots, WhatCannotBeIsRefused) {
  const Model model = test::block();
  WorldConfig config;
  config.robots = {a_block("second", 1.0, 0.0)};
  EXPECT_NO_THROW((void)make(model, config));
  config.robots[0].servos.clear();
  EXPECT_THROW((void)make(model, config), std::runtime_error);
  config.robots[0].servos.resize(1);
  config.robots[0].servos[0].kp = -1.0;
  EXPECT_THROW((void)make(model, config), std::runtime_error);
  config.robots[0].servos[0].kp = 0.0;
  config.robots[0].start.base.translation().x() = std::nan("");
  EXPECT_THROW((void)make(model, config), std::runtime_error);
}

// An arm of two links whose tip is a ball; beside its base stands a post.
Model arm_beside_a_post() {
  Model model = test::chain(2, false);
  model.links[1].com.setZero();
  model.links[2].com = {0.3, 0.0, 0.0};
  model.joints[0].placement.translation() = Eigen::Vector3d(0, 0, 2);
  model.joints[1].placement.translation().setZero();
  model.joints[1].axis = Eigen::Vector3d::UnitZ();
  Shape post;
  post.size = {0.1, 0.1, 1.0};
  post.pose.translation() = Eigen::Vector3d(0.3, 0.4, 2.0);
  model.links[0].collision = {post};
  Shape ball;
  ball.kind = ShapeKind::kSphere;
  ball.size = {0.05, 0, 0};
  ball.pose.translation() = Eigen::Vector3d(0.5, 0, 0);
  model.links[2].collision = {ball};
  return model;
}

class SelfContact : public test::BothEngines {
 protected:
  // Where the arm ends, and what its tip then feels [N].
  static double turned(const Model& model, bool self_contact, double* force = nullptr) {
    WorldConfig config;
    config.step = 1e-3;
    config.fixed_base = true;
    config.self_contact = self_contact;
    const auto world = make(model, config);
    Configuration start(model);
    start.q.setZero();
    start.qd.setZero();
    EXPECT_EQ(world->set(start), Status::kOk);
    EXPECT_EQ(world->set_servo(0, {.q = 0.0, .kp = 1000.0, .kd = 20.0}), Status::kOk);
    EXPECT_EQ(world->set_servo(1, {.q = 1.5, .kp = 20.0, .kd = 2.0}), Status::kOk);
    for (int i = 0; i < 1500; ++i) EXPECT_EQ(world->step(), Status::kOk);
    Eigen::Vector3d tip = Eigen::Vector3d::Zero(), all = Eigen::Vector3d::Zero();
    for (const ContactPoint& c : world->contacts()) {
      all += c.force;
      if (c.link == 2) tip += c.force;
    }
    EXPECT_LT(all.norm(), 1e-9);  // what one link feels the other does, the other way
    if (force != nullptr) *force = tip.norm();
    return world->configuration().q[1];
  }
};
TWINBUS_FOR_BOTH_ENGINES(SelfContact);

TEST_P(SelfContact, AnArmIsHeldByThePostBesideItsBase) {
  const Model model = arm_beside_a_post();
  EXPECT_NEAR(turned(model, false), 1.5, 0.02);
  double force = 0.0;
  const double q = turned(model, true, &force);
  EXPECT_GT(q, 0.5);
  EXPECT_LT(q, 0.9);
  // The servo's torque about the vertical, at the ball's lever of at most 0.5 m.
  EXPECT_GT(force, 20.0 * (1.5 - q) / 0.5 * 0.95);
}

TEST_P(SelfContact, PairsThatTheSrdfDisablesPassThroughOneAnother) {
  Model model = arm_beside_a_post();
  model.disabled_pairs = {{0, 2}};
  EXPECT_NEAR(turned(model, true), 1.5, 0.02);
}

// The post is of a link that is fixed, and moves to where the base is set.
TEST_P(SelfContact, ABallRestsOnThePostOfAFixedBase) {
  const Model model = arm_beside_a_post();
  WorldConfig config;
  config.step = 1e-3;
  config.fixed_base = true;
  LooseBody ball;
  ball.solid = {SolidShape::kSphere, {0.05, 0.0, 0.0}};
  ball.start.pose.translation() = Eigen::Vector3d(1.3, 0.4, 2.551);
  config.loose = {ball};
  const auto world = make(model, config);
  Configuration start(model);
  start.q.setZero();
  start.qd.setZero();
  start.base.translation() = Eigen::Vector3d(1.0, 0.0, 0.0);
  ASSERT_EQ(world->set(start), Status::kOk);
  for (int i = 0; i < 300; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).pose.translation().z(), 2.55, 1e-3);
}

}  // namespace
}  // namespace twinbus
