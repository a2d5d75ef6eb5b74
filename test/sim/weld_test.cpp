// Robots with joints held: the same body, and a world in which it moves as the whole robot would.

#include "sim/world/weld.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>

#include "both_engines.h"
#include "test/obstacles.h"
#include "robot/description/load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/kinematics.h"
#include "sim/contact/ground_contacts.h"
#include "sim/engine/articulated_world.h"
#include "sim/engine/make_world.h"
#include "sim/engine/welded_world.h"
#include "sim/scene/fidelity.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

std::vector<bool> all_but_the_legs(const Model& model) {
  std::vector<bool> held(model.joints.size(), true);
  for (const int joint : model.leg_joints) held[static_cast<std::size_t>(joint)] = false;
  return held;
}

// The equations of motion of what is left are those of the whole robot whose held joints are at rest.
TEST(Weld, LinksForcesAndTorquesAreThoseOfTheWholeRobot) {
  const Model model = load_robot("hrp1s");
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-0.8, 0.8);
  const std::vector<bool> held = all_but_the_legs(model);
  for (int round = 0; round < 20; ++round) {
    Configuration whole(model);
    Eigen::VectorXd whole_qdd(model.joint_count());
    for (int j = 0; j < model.joint_count(); ++j) {
      whole.q[j] = any(random);
      whole.qd[j] = held[static_cast<std::size_t>(j)] ? 0.0 : any(random);
      whole_qdd[j] = held[static_cast<std::size_t>(j)] ? 0.0 : any(random);
    }
    whole.base.translation() = Eigen::Vector3d(any(random), any(random), 1.0);
    whole.base_velocity = Eigen::Vector3d(any(random), any(random), any(random));
    whole.base_angular_velocity = Eigen::Vector3d(any(random), any(random), any(random));
    const Eigen::Vector3d up(any(random), any(random), any(random)), spin(any(random), any(random), any(random));

    const WeldedModel welded = weld(model, held, whole.q);
    ASSERT_EQ(welded.model.joint_count(), static_cast<int>(model.leg_joints.size()));
    Configuration less(welded.model);
    Eigen::VectorXd qdd(welded.model.joint_count());
    less.base = whole.base;
    less.base_velocity = whole.base_velocity;
    less.base_angular_velocity = whole.base_angular_velocity;
    for (std::size_t j = 0; j < held.size(); ++j) {
      const int to = welded.joint[j];
      if (to < 0) continue;
      less.q[to] = whole.q[static_cast<Eigen::Index>(j)];
      less.qd[to] = whole.qd[static_cast<Eigen::Index>(j)];
      qdd[to] = whole_qdd[static_cast<Eigen::Index>(j)];
    }
    Kinematics a(model), b(welded.model);
    a.update(whole);
    b.update(less);
    EXPECT_NEAR((a.com() - b.com()).norm(), 0.0, 1e-12);
    for (int i = 0; i < model.link_count(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      EXPECT_TRUE((b.link_in_world(welded.link[at]) * welded.in_link[at]).isApprox(a.link_in_world(i), 1e-12));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const Sole &sole = model.soles[side], &moved = welded.model.soles[side];
      EXPECT_TRUE((a.link_in_world(sole.link) * sole.frame).isApprox(b.link_in_world(moved.link) * moved.frame, 1e-12));
      const Hand &hand = model.hands[side], &kept = welded.model.hands[side];
      EXPECT_TRUE((a.link_in_world(hand.link) * hand.frame).isApprox(b.link_in_world(kept.link) * kept.frame, 1e-12));
    }
    InverseDynamics of_whole(model), of_less(welded.model);
    Eigen::VectorXd tau_whole(model.joint_count()), tau(welded.model.joint_count());
    const auto wrench_whole = of_whole.solve(a, whole, whole_qdd, up, spin, {}, tau_whole);
    const auto wrench = of_less.solve(b, less, qdd, up, spin, {}, tau);
    EXPECT_NEAR((wrench_whole - wrench).norm(), 0.0, 1e-9 * wrench_whole.norm());
    for (std::size_t j = 0; j < held.size(); ++j) {
      if (welded.joint[j] < 0) continue;
      EXPECT_NEAR(tau[welded.joint[j]], tau_whole[static_cast<Eigen::Index>(j)], 1e-9);
    }
  }
}

TEST(Weld, WhatFollowsAHeldJointIsHeldAndALeaderIsTheSame) {
  Model model = test::chain(4, false);
  model.joints[3].mimic = 1;
  std::vector<bool> held{false, true, false, false};
  EXPECT_THROW(weld(model, held, Eigen::VectorXd::Zero(4)), std::invalid_argument);
  hold_followers(model, held);
  EXPECT_EQ(held, (std::vector<bool>{false, true, false, true}));
  const WeldedModel welded = weld(model, held, Eigen::VectorXd::Zero(4));
  EXPECT_EQ(welded.joint, (std::vector<int>{0, -1, 1, -1}));
  EXPECT_EQ(welded.link, (std::vector<int>{0, 1, 1, 2, 2}));
  EXPECT_THROW(weld(model, {true}, Eigen::VectorXd::Zero(4)), std::invalid_argument);
}

TEST(Weld, TwoLinksTouchIfAnyOfTheirPartsMay) {
  Model model = test::chain(4, true);
  model.disabled_pairs = {{0, 3}, {1, 3}};
  // Links 0 and 1 become one; 2 is its neighbour.
  const WeldedModel both = weld(model, {true, false, false, false}, Eigen::VectorXd::Zero(4));
  const auto apart = [&](const WeldedModel& welded, int a, int b) {
    const auto& pairs = welded.model.disabled_pairs;
    return std::find(pairs.begin(), pairs.end(), std::array<int, 2>{a, b}) != pairs.end();
  };
  EXPECT_TRUE(apart(both, 0, 2));   // former 3
  EXPECT_FALSE(apart(both, 0, 3));  // former 4
  model.disabled_pairs = {{0, 3}};
  EXPECT_FALSE(apart(weld(model, {true, false, false, false}, Eigen::VectorXd::Zero(4)), 0, 2));
}

TWINBUS_BOTH_ENGINES(Welded);

// A chain that swings, one joint held by its servo or for good.
TEST_P(Welded, AHeldJointIsOneWithAServoThatIsStiff) {
  const Model model = test::chain(4, false);
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-4;
  const auto whole = make(model, config);
  config.held = {false, false, true, false};
  const auto less = make(model, config);
  Configuration start(model);
  start.base = Eigen::Isometry3d::Identity();
  start.q = Eigen::Vector4d(0.3, -0.2, 0.6, 0.1);
  ASSERT_EQ(whole->set(start), Status::kOk);
  ASSERT_EQ(less->set(start), Status::kOk);
  for (World* world : {whole.get(), less.get()}) {
    ASSERT_EQ(world->set_servo(2, {.q = 0.6, .qd = 0.0, .tau = 0.0, .kp = 1e7, .kd = 1e3}), Status::kOk);
    for (int i = 0; i < 3000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  }
  EXPECT_GT(std::abs(less->configuration().q[0] - 0.3), 0.1);  // it swings
  EXPECT_EQ(less->configuration().q[2], 0.6);
  EXPECT_EQ(less->configuration().qd[2], 0.0);
  EXPECT_EQ(less->encoder(2), 0.6);
  for (int i = 0; i < model.link_count(); ++i) {
    EXPECT_NEAR((whole->link_in_world(i).translation() - less->link_in_world(i).translation()).norm(), 0.0, 2e-4);
    const Eigen::Vector3d there = less->link_in_world(i) * Eigen::Vector3d(0.1, 0.05, 0.0);
    EXPECT_NEAR((whole->point_velocity(i, there) - less->point_velocity(i, there)).norm(), 0.0, 5e-3);
  }
  EXPECT_NEAR(whole->mass(), less->mass(), 1e-12);
}

TEST_P(Welded, AFurtherRobotThatIsRigidStandsAsOneBody) {
  const Model model = test::bystander();
  WorldConfig config;
  config.step = 1e-3;
  OtherRobot robot;
  robot.name = "second";
  robot.model = std::make_shared<const Model>(test::block());
  robot.start = Configuration(*robot.model);
  robot.start.q[0] = 0.4;
  robot.start.base.translation().z() = -robot.model->total_mass() * kGravity / (2.0 * robot.model->soles[0].stiffness);
  robot.servos.resize(1);
  config.robots = {robot};
  config.rigid_robots = {true};
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR((world->robot_link(0, 0).translation() - robot.start.base.translation()).norm(), 0.0, 1e-4);
  // Its arm has not moved, though no servo holds it.
  const Eigen::Isometry3d arm = world->robot_link(0, 0).inverse() * world->robot_link(0, 1);
  EXPECT_NEAR(Eigen::AngleAxisd(arm.linear()).angle(), 0.4, 1e-9);
}

// A block on the ground: held, base and all, it stays where it was put, whatever pushes it, and its soles feel its weight.
TEST_P(Welded, AHeldBaseStaysAndItsSolesFeelWhatTheyFelt) {
  const Model model = test::block();
  WorldConfig config;
  config.step = 1e-3;
  Configuration start(model);
  start.base.translation().z() = -model.total_mass() * kGravity / (2.0 * model.soles[0].stiffness);
  const auto feel = [](const World& world) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const ContactPoint& contact : world.contacts()) sum += contact.force;
    return sum;
  };
  const auto whole = make(model, config);
  ASSERT_EQ(whole->set(start), Status::kOk);
  config.held.assign(model.joints.size() + 1, true);
  const auto still = make(model, config);
  ASSERT_EQ(still->set(start), Status::kOk);
  EXPECT_NEAR((feel(*still) - feel(*whole)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(still->mass(), whole->mass(), 1e-12);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(still->push(0, Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(300, 0, 0)), Status::kOk);
    ASSERT_EQ(still->step(), Status::kOk);
  }
  EXPECT_EQ(still->configuration().base.translation(), start.base.translation());
  EXPECT_NEAR(feel(*still).z(), model.total_mass() * kGravity, 1e-3 * model.total_mass() * kGravity);
}

// With joints that move the soles of what moves are found as ever, and once.
TEST_P(Welded, AHeldBaseWithJointsThatMoveFeelsEachSoleOnce) {
  Model model = test::block();
  model.links[0].collision.clear();
  for (Sole& sole : model.soles) {
    sole.link = 1;
    sole.frame.translation().z() = -0.2;  // the joint is so high
    sole.sensor = sole.frame;
  }
  WorldConfig config;
  config.step = 1e-3;
  Configuration start(model);
  start.base.translation().z() = -model.total_mass() * kGravity / (2.0 * model.soles[0].stiffness);
  const auto whole = make_at(start, model, config);
  config.held = {false, true};
  const auto still = make(model, config);
  ASSERT_EQ(still->set(start), Status::kOk);
  ASSERT_FALSE(whole->contacts().empty());
  ASSERT_EQ(still->contacts().size(), whole->contacts().size());
  for (std::size_t i = 0; i < whole->contacts().size(); ++i) {
    EXPECT_EQ(still->contacts()[i].link, 1);
    EXPECT_NEAR((still->contacts()[i].force - whole->contacts()[i].force).norm(), 0.0, 1e-3);
  }
}

// What touches a robot that stands still finds it, also where it is put anew.
TEST_P(Welded, ABallLiesOnAStillRobotUntilThatIsTakenAway) {
  const Model model = test::block();
  WorldConfig config;
  config.step = 1e-3;
  config.held.assign(model.joints.size() + 1, true);
  LooseBody ball;
  ball.name = "ball";
  ball.mass = 1.0;
  ball.solid = {SolidShape::kSphere, {0.05, 0, 0}};
  ball.stiffness = 1e5;
  ball.damping = 200.0;
  ball.start.pose.translation() = Eigen::Vector3d(0, 0, 3);
  config.loose = {ball};
  const auto world = make(model, config);
  Configuration start(model);
  ASSERT_EQ(world->set(start), Status::kOk);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  const double on_it = world->loose(0).pose.translation().z();
  EXPECT_GT(on_it, 0.1);
  start.base.translation().x() = 5.0;
  ASSERT_EQ(world->set(start), Status::kOk);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).pose.translation().z(), 0.05, 0.01);
}

TEST_P(Welded, AFurtherRobotThatIsHeldStaysWhereItWasPut) {
  const Model model = test::bystander();
  WorldConfig config;
  OtherRobot robot;
  robot.name = "second";
  robot.model = std::make_shared<const Model>(test::block());
  robot.start = Configuration(*robot.model);
  robot.start.base.translation().z() = 0.5;  // it would fall
  robot.servos.resize(1);
  config.robots = {robot};
  Scene scene;
  scene.held = {"second"};
  apply_fidelity(scene, model, config);
  ASSERT_EQ(config.held.size(), model.joints.size() + 2);
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_EQ(world->robot_link(0, 0).translation(), robot.start.base.translation());
}

TEST_P(Welded, ALoopWithinOneBodyIsRefused) {
  const Model model = test::chain(3, false);
  WorldConfig config;
  config.held = {false, true, true};
  Tie tie;
  tie.a.link = 1;
  tie.b.link = 3;
  config.ties = {tie};
  EXPECT_THROW(make(model, config), std::runtime_error);
}

TEST(Fidelity, WordsAndListsSayWhichJointsAreHeld) {
  const Model model = load_robot("hrp1s");
  Scene scene;
  WorldConfig config;
  apply_fidelity(scene, model, config);
  EXPECT_TRUE(config.held.empty());
  scene.fidelity = "legs";
  apply_fidelity(scene, model, config);
  EXPECT_EQ(config.held, all_but_the_legs(model));
  scene.fidelity = "full";
  scene.held = {model.joints[3].name};
  apply_fidelity(scene, model, config);
  EXPECT_EQ(std::count(config.held.begin(), config.held.end(), true), 1);
  scene.held = {"base"};
  apply_fidelity(scene, model, config);
  EXPECT_EQ(config.held.size(), model.joints.size() + 1);
  EXPECT_TRUE(config.held.back());
  scene.held = {"no such joint"};
  EXPECT_THROW(apply_fidelity(scene, model, config), std::runtime_error);
  scene.held = {};
  scene.rigid = {"nobody"};
  EXPECT_THROW(apply_fidelity(scene, model, config), std::runtime_error);
  scene.rigid = {};
  scene.fidelity = "legs";
  EXPECT_THROW(apply_fidelity(scene, test::pendulum(), config), std::runtime_error);
}

TEST(Fidelity, AHeldNameIsOfOneJointOrRobot) {
  const Model model = test::chain(3, true);
  WorldConfig config;
  config.robots.resize(2);
  config.robots[0].name = "second";
  config.robots[1].name = "joint2";
  Scene scene;
  scene.name = "test";
  const auto complaint = [&](const std::string& name) -> std::string {
    scene.held = {name};
    try {
      apply_fidelity(scene, model, config);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  for (const char* name : {"second", "base", "joint1"}) EXPECT_EQ(complaint(name), "") << name;
  EXPECT_EQ(complaint("secnd"), "scene test: held: there is no joint or further robot 'secnd'; did you mean second?");
  EXPECT_EQ(complaint("bse"), "scene test: held: there is no joint or further robot 'bse'; did you mean base?");
  EXPECT_EQ(complaint("joint2"), "scene test: held: 'joint2' is a joint and a further robot; give one of them another name");
}

// A shape keeps being that of its former link; what is said of it goes with it.
TEST(Weld, UntouchedShapesAreThoseOfTheirFormerLinks) {
  const Model model = load_robot("hrp1s");
  const WeldedModel welded = weld(model, all_but_the_legs(model), Configuration(model).q);
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& now = welded.model.links[static_cast<std::size_t>(welded.link[i])];
    for (std::size_t s = 0; s < model.links[i].collision.size(); ++s) {
      const std::size_t to = static_cast<std::size_t>(welded.first_shape[i]) + s;
      ASSERT_LT(to, now.collision.size());
      EXPECT_TRUE(now.collision[to].pose.isApprox(welded.in_link[i] * model.links[i].collision[s].pose)) << i;
    }
  }
}

// A ball falls through the hand that it does not meet and lies on the other.
TEST(Weld, WhatIsUntouchedMeetsNothingLoose) {
  const Model model = load_robot("hrp1s");
  const Eigen::VectorXd q = Configuration(model).q;
  for (const bool untouched : {false, true}) {
    Scene scene;
    scene.fidelity = "rigid";
    if (untouched) {
      for (const Link& link : model.links) scene.untouched.push_back(link.name);
    }
    WorldConfig config;
    config.fixed_base = true;
    apply_fidelity(scene, model, config);
    Configuration start(model);
    start.base.translation().z() = 2.0;
    LooseBody ball = test::loose_box("ball", 0.5, {0.05, 0.0, 0.0}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 4.0)), 1e5, 150.0);
    ball.solid.shape = SolidShape::kSphere;
    config.loose.push_back(ball);
    WeldedWorld world(model, config);
    ASSERT_EQ(world.set(start), Status::kOk);
    bool touched = false;
    for (int i = 0; i < 600; ++i) {
      ASSERT_EQ(world.step(), Status::kOk);
      touched = touched || !world.contacts().empty();
    }
    EXPECT_EQ(touched, !untouched);
  }
}

// A hand within an obstacle is pushed out of it, unless it is said never to come near one.
TEST(Weld, WhatIsAloftMeetsNothingFixed) {
  const Model model = load_robot("hrp1s");
  const int hand = model.find_link("RARM_WRIST_R");
  ASSERT_GE(hand, 0);
  Configuration start(model);
  start.base.translation().z() = 2.0;
  Kinematics kinematics(model);
  kinematics.update(start);
  for (const bool held : {false, true}) {
    std::size_t touches[2] = {};
    for (const bool aloft : {false, true}) {
      Scene scene;
      if (held) scene.held = {model.joints[static_cast<std::size_t>(hand) - 1].name};
      if (aloft) scene.aloft = {model.links[static_cast<std::size_t>(hand)].name};
      WorldConfig config;
      config.fixed_base = true;
      apply_fidelity(scene, model, config);
      config.obstacles = {test::box_at(kinematics.link_in_world(hand).translation(), {0.2, 0.2, 0.2})};
      const std::unique_ptr<World> world = make_world(model, config);
      ASSERT_EQ(world->set(start), Status::kOk);
      touches[aloft ? 1 : 0] = world->contacts().size();
    }
    EXPECT_GT(touches[0], touches[1]) << held;
  }
  Scene scene;
  scene.aloft = {"RARM_WRIST"};
  WorldConfig config;
  EXPECT_THROW(apply_fidelity(scene, model, config), std::runtime_error);
}

// How far links are from the ground grows with their height; an obstacle comes nearer than it.
TEST(Weld, LinksAreAsFarFromWhatIsFixedAsTheirShapes) {
  const Model model = load_robot("hrp1s");
  WorldConfig config;
  config.fixed_base = true;
  const auto nearest = [&](double height) {
    ArticulatedWorld world(model, config);
    Configuration start(model);
    start.base.translation().z() = height;
    EXPECT_EQ(world.set(start), Status::kOk);
    std::vector<double> above(model.links.size(), std::numeric_limits<double>::infinity());
    GroundContacts(model, config).clearance(world, above);
    return above;
  };
  const std::vector<double> low = nearest(1.0), high = nearest(1.1);
  const auto hand = static_cast<std::size_t>(model.find_link("RARM_WRIST_R"));
  int shapes = 0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    if (!std::isfinite(low[i])) continue;
    ++shapes;
    EXPECT_NEAR(high[i] - low[i], 0.1, 1e-12) << i;
  }
  EXPECT_GT(shapes, 10);
  ASSERT_TRUE(std::isfinite(low[hand]));
  config.obstacles = {test::box_at({0.0, 0.0, 0.3}, {4.0, 4.0, 0.2})};
  EXPECT_NEAR(nearest(1.0)[hand], low[hand] - 0.4, 1e-9);
}

}  // namespace
}  // namespace twinbus
