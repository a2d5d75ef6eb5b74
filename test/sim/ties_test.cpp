// Ties: closed loops, what is gripped and let go, springs between points.

#include <gtest/gtest.h>

#include <cmath>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "sim/engine/articulated_world.h"
#include "sim/world/static_equilibrium.h"
#include "sim/world/constraint.h"
#include "common/allocation/no_alloc.h"
#include "test_models.h"

namespace twinbus {
namespace {

// Two uprights of 1 m and a bar across that hangs on the first: a four-bar once its end is tied to
// the top of the second.
Model open_four_bar() {
  Model model = test::chain(3, false);
  const Eigen::Vector3d inertia = Eigen::Vector3d::Constant(1.0 / 12.0);
  model.links[0].com.setZero();
  model.links[1] = test::make_link("left", 0, 1.0, {0, 0, 0.5}, inertia);
  model.links[2] = test::make_link("bar", 1, 1.0, {0.5, 0, 0}, inertia);
  model.links[3] = test::make_link("right", 0, 1.0, {0, 0, 0.5}, inertia);
  const Eigen::Vector3d places[] = {{0, 0, 3}, {0, 0, 1}, {1, 0, 3}};
  for (int i = 0; i < 3; ++i) {
    Joint& joint = model.joints[static_cast<std::size_t>(i)];
    joint.kind = JointKind::kContinuous;
    joint.lower = -HUGE_VAL;
    joint.upper = HUGE_VAL;
    joint.axis = Eigen::Vector3d::UnitY();
    joint.placement.translation() = places[i];
    joint.parent = i == 1 ? 1 : 0;
  }
  return model;
}

WorldConfig with_its_loop(double step, double stiffness = 1e8) {
  WorldConfig config;
  config.fixed_base = true;
  config.step = step;
  Tie tie;
  tie.a = {2, -1, {1, 0, 0}};
  tie.b = {3, -1, {0, 0, 1}};
  tie.stiffness = stiffness;
  tie.damping = 1e-2 * stiffness;
  config.ties = {tie};
  return config;
}

Configuration moving_top(const Model& model) {
  Configuration start(model);
  start.q.setZero();
  start.qd << 1.0, -1.0, 1.0;
  return start;
}

double energy(const Model& model, const Configuration& now) {
  Kinematics kinematics(model);
  kinematics.update(now);
  double sum = 0.0;
  for (int i = 1; i < model.link_count(); ++i) {
    const Link& link = model.links[static_cast<std::size_t>(i)];
    const Eigen::Isometry3d& pose = kinematics.link_in_world(i);
    const Eigen::Vector3d w = pose.linear().transpose() * kinematics.angular_velocity(i);
    sum += 0.5 * link.mass * kinematics.point_velocity(i, pose * link.com).squaredNorm() +
           link.mass * kGravity * (pose * link.com).z() + 0.5 * w.dot(link.inertia * w);
  }
  return sum;
}

TWINBUS_BOTH_ENGINES(TieTest);

TEST_P(TieTest, AFourBarKeepsItsShape) {
  const Model model = open_four_bar();
  const auto world = make(model, with_its_loop(1e-3));
  ASSERT_EQ(world->set(moving_top(model)), Status::kOk);
  for (int j = 0; j < 3; ++j) ASSERT_EQ(world->set_servo(j, {}), Status::kOk);
  for (int i = 0; i < 700; ++i) ASSERT_EQ(world->step(), Status::kOk);
  const Eigen::VectorXd& q = world->configuration().q;
  EXPECT_GT(q[0], 1.0);  // it falls
  EXPECT_NEAR(q[1], -q[0], 1e-3);
  EXPECT_NEAR(q[2], q[0], 1e-3);
}

// What hangs on a tie pulls on it, up to what it weighs.
TEST_P(TieTest, WhatIsGrippedHangsAndFallsWhenLetGo) {
  const Model model = test::pendulum();
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-3;
  LooseBody box;
  box.name = "box";
  box.solid = {SolidShape::kBox, {0.1, 0.1, 0.1}};
  box.mass = 2.0;
  box.start.pose.translation() = Eigen::Vector3d(0.0, 0.0, 0.95);
  config.loose = {box};
  for (const double side : {-0.05, 0.05}) {
    Tie tie;
    tie.a = {-1, 0, {side, 0.0, 0.05}};
    tie.b = {1, -1, Eigen::Vector3d::Zero()};
    tie.stiffness = 1e6;
    tie.damping = 1e3;
    tie.holds = false;
    config.ties.push_back(tie);
  }
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  ASSERT_EQ(world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1e4, .kd = 100}), Status::kOk);
  for (int tie = 0; tie < 2; ++tie) ASSERT_EQ(world->hold(tie, true), Status::kOk);
  EXPECT_NE(world->hold(2, true), Status::kOk);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).pose.translation().z(), 0.95, 1e-3);
  double pull = 0.0;
  for (const ContactPoint& c : world->contacts()) {
    EXPECT_TRUE(c.tie);
    EXPECT_EQ(c.link, 1);
    pull += c.force.z();
  }
  EXPECT_NEAR(pull, -2.0 * kGravity, 0.05);
  for (int tie = 0; tie < 2; ++tie) ASSERT_EQ(world->hold(tie, false), Status::kOk);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).pose.translation().z(), 0.95 - 0.5 * kGravity * 0.04, 5e-3);
}

// m g / k further than its length.
TEST_P(TieTest, ASpringHasItsLength) {
  const Model model = test::slider();
  Model free = model;
  free.joints[0].lower = -1.0;
  free.joints[0].upper = 1.0;
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-3;
  Tie tie;
  tie.a = {1, -1, Eigen::Vector3d::Zero()};
  tie.b = {-1, -1, {0, 0, 4}};
  tie.stiffness = 1e3;
  tie.damping = 50.0;
  tie.length = 2.0;
  config.ties = {tie};
  const auto world = make(free, config);
  ASSERT_EQ(world->set(Configuration(free)), Status::kOk);
  ASSERT_EQ(world->set_servo(0, {}), Status::kOk);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->configuration().q[0], -2.0 * kGravity / 1e3, 1e-4);
}

TEST_P(TieTest, AnEndThatIsNotThereIsRefused) {
  const Model model = test::pendulum();
  for (const auto& [link, loose] : {std::pair{2, -1}, {-1, 0}, {0, -1}}) {
    WorldConfig config;
    config.fixed_base = true;
    Tie tie;
    tie.a = {link, loose, Eigen::Vector3d::Zero()};
    config.ties = {tie};
    EXPECT_THROW(make(model, config), std::runtime_error) << link << loose;
  }
}

// At order 3 a loop keeps its energy through the positions in which it lies flat.
TEST(Ties, AFourBarKeepsItsEnergy) {
  const Model model = open_four_bar();
  WorldConfig config = with_its_loop(1e-3);
  config.order = 3;
  ArticulatedWorld world(model, config);
  const Configuration start = moving_top(model);
  ASSERT_EQ(world.set(start), Status::kOk);
  for (int j = 0; j < 3; ++j) ASSERT_EQ(world.set_servo(j, {}), Status::kOk);
  const double before = energy(model, start);
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    ASSERT_NEAR(energy(model, world.configuration()), before, 2e-3) << i;
  }
  EXPECT_GT(world.configuration().q[0], 5.0);
  EXPECT_EQ(world.unconverged(), 0);
}

TEST(Ties, AStepAllocatesNothing) {
  const Model model = open_four_bar();
  ArticulatedWorld world(model, with_its_loop(1e-3));
  ASSERT_EQ(world.set(moving_top(model)), Status::kOk);
  const NoAlloc guard;
  for (int i = 0; i < 50; ++i) {
    (void)world.hold(0, i % 20 < 10);
    (void)world.step();
  }
  EXPECT_EQ(guard.count(), 0);
}

// The robot stands with its hands tied and presses them together: no step is too long, no tie too
// stiff.
TEST(Ties, TiedHandsAreStableAtAnyStep) {
  const Model model = load_robot("hrp1s");
  const auto pose = static_cast<std::size_t>(model.find_pose("half_sitting"));
  const Eigen::VectorXd q =
      Eigen::Map<const Eigen::VectorXd>(model.poses[pose].q.data(), model.joint_count());
  const double corner = model.soles[0].stiffness / kSoleCorners;
  const Standing standing = stand(model, q, 1.0, {corner, corner}, {0.0, 0.0}, false);
  Kinematics kinematics(model);
  kinematics.update(standing.configuration);
  const int left = model.hands[0].link, right = model.hands[1].link;
  for (const double stiffness : {1e6, 1e8}) {
    for (const double step : {1e-4, 2e-3, 1e-2}) {
      WorldConfig config;
      config.step = step;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d point = 0.05 * Eigen::Vector3d::Unit(axis);
        Tie tie;
        tie.a = {left, -1, point};
        tie.b = {
            right, -1,
            kinematics.link_in_world(right).inverse() * (kinematics.link_in_world(left) * point)};
        tie.stiffness = stiffness;
        tie.damping = 1e-3 * stiffness;
        config.ties.push_back(tie);
      }
      ArticulatedWorld world(model, config);
      ASSERT_EQ(world.set(standing.configuration, &standing.tau), Status::kOk);
      for (int j = 0; j < model.joint_count(); ++j) {
        const Joint& joint = model.joints[static_cast<std::size_t>(j)];
        const bool pressed =
            std::count(model.hands[0].joints.begin(), model.hands[0].joints.end(), j) > 0;
        ASSERT_EQ(world.set_servo(j, {.q = q[j] + (pressed ? 0.05 : 0.0),
                                      .qd = 0.0,
                                      .tau = standing.tau[j],
                                      .kp = joint.kp,
                                      .kd = joint.kd}),
                  Status::kOk);
      }
      const long steps = std::lround(0.5 / step);
      for (long i = 0; i < steps; ++i) ASSERT_EQ(world.step(), Status::kOk);
      const Configuration& now = world.configuration();
      EXPECT_LT(now.qd.cwiseAbs().maxCoeff(), 0.2) << stiffness << " " << step;
      EXPECT_LT((now.base.translation() - standing.configuration.base.translation()).norm(), 0.01);
      EXPECT_EQ(world.unconverged(), 0) << stiffness << " " << step;
    }
  }
}

}  // namespace
}  // namespace twinbus
