// Loose bodies: in the one solve of the articulated engine, and what every engine does with them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "sim/engine/articulated_world.h"
#include "sim/articulated/torque_free_rotation.h"
#include "common/math/key_index.h"
#include "common/math/random.h"
#include "sim/world/static_equilibrium.h"
#include "common/allocation/no_alloc.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

LooseBody light_box(const std::string& name, double mass, const Eigen::Vector3d& size,
              const Eigen::Vector3d& position, double stiffness = 1e6) {
  const Eigen::Isometry3d pose(Eigen::Translation3d{position});
  return test::loose_box(name, mass, size, pose, stiffness, std::sqrt(15.0 * stiffness));
}

TWINBUS_BOTH_ENGINES(LooseTest);

TEST_P(LooseTest, EveryShapeComesToRestOnTheGround) {
  const Model model = test::bystander();
  WorldConfig config;
  const SolidShape shapes[] = {SolidShape::kBox, SolidShape::kSphere, SolidShape::kCylinder,
                               SolidShape::kCapsule};
  const Eigen::Vector3d sizes[] = {{0.2, 0.3, 0.1}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0.05, 0.2, 0}};
  const double rest[] = {0.05, 0.1, 0.05, 0.05};  // height of the middle
  for (int i = 0; i < 4; ++i) {
    LooseBody body = light_box("b" + std::to_string(i), 2.0, sizes[i], {1.0 * i, 0.0, rest[i] + 0.02});
    body.solid.shape = shapes[i];
    if (i == 3)
      body.start.pose.linear() =
          Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
    config.loose.push_back(body);
  }
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  ASSERT_EQ(world->loose_count(), 4);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  for (int i = 0; i < 4; ++i) {
    const LooseState now = world->loose(i);
    EXPECT_NEAR(now.pose.translation().z(), rest[i], 1e-4) << i;
    EXPECT_LT(now.velocity.norm(), 1e-3) << i;
    EXPECT_NEAR(now.pose.translation().x(), 1.0 * i, 1e-3) << i;
  }
  EXPECT_TRUE(world->contacts().empty());  // the robot is not touched
}

// Against a wall, so that no weight is in it: a (v + v_out) = ln((1 + a v) / (1 - a v_out)).
TEST_P(LooseTest, ABallLeavesAWallAsHuntAndCrossleySay) {
  const Model model = test::bystander();
  WorldConfig config;
  config.contact = ContactModel::kHuntCrossley;
  config.dissipation = 0.5;
  config.step = 1e-5;
  config.order = is_ode() ? 1 : 2;
  config.ground_friction = 0.0;
  config.obstacles.push_back({.shape = ObstacleShape::kBox,
                              .size = {0.2, 2.0, 2.0},
                              .pose = Eigen::Isometry3d(Eigen::Translation3d(0.1, 0.0, 5.0))});
  LooseBody ball = light_box("ball", 1.0, {0.1, 0.0, 0.0}, {-0.105, 0.0, 5.0});
  ball.solid.shape = SolidShape::kSphere;
  ball.start.velocity.x() = 1.0;
  config.loose.push_back(ball);
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  const double out = -world->loose(0).velocity.x(), a = config.dissipation;
  EXPECT_LT(out, 0.95);
  EXPECT_NEAR(a * (1.0 + out), std::log((1.0 + a) / (1.0 - a * out)), is_ode() ? 5e-3 : 1e-4);
}

TEST_P(LooseTest, BoxesStandOnOneAnother) {
  const Model model = test::bystander();
  WorldConfig config;
  config.step = 1e-3;
  for (int i = 0; i < 3; ++i) {
    config.loose.push_back(
        light_box("b" + std::to_string(i), 1.0, {0.2, 0.2, 0.2}, {0.01 * i, 0.0, 0.1 + 0.2 * i}));
  }
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(world->loose(i).pose.translation().z(), 0.1 + 0.2 * i, 2e-4) << i;
    EXPECT_LT(world->loose(i).velocity.norm(), 1e-3) << i;
  }
}

TEST_P(LooseTest, ABoxIsPutWhereItIsTold) {
  const Model model = test::bystander();
  WorldConfig config;
  config.loose = {light_box("b", 1.0, {0.2, 0.2, 0.2}, {0, 0, 0.1})};
  const auto world = make(model, config);
  LooseState to;
  to.pose.translation() = Eigen::Vector3d(0, 0, 3);
  to.velocity = {1, 0, 0};
  ASSERT_EQ(world->set_loose(0, to), Status::kOk);
  EXPECT_NE(world->set_loose(1, to), Status::kOk);
  to.velocity.x() = std::nan("");
  EXPECT_EQ(world->set_loose(0, to), Status::kNotFinite);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).pose.translation().x(), 0.2, 1e-9);
  EXPECT_NEAR(world->loose(0).pose.translation().z(), 3.0 - 0.5 * kGravity * 0.04, 5e-3);
}

// A loose box slides to where v^2 / (2 mu g) says.
TEST_P(LooseTest, ABoxSlidesToAHalt) {
  const Model model = test::bystander();
  WorldConfig config;
  config.step = 1e-3;
  LooseBody body = light_box("b", 5.0, {0.4, 0.4, 0.1}, {0, 0, 0.05 - 5.0 * kGravity / 4e6});
  body.start.velocity = {1, 0, 0};
  body.friction = config.ground_friction = 0.5;
  config.loose = {body};
  const auto world = make(model, config);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  const double expected = 1.0 / (2.0 * 0.5 * kGravity);
  EXPECT_NEAR(world->loose(0).pose.translation().x(), expected, 0.01 * expected);
  EXPECT_LT(world->loose(0).velocity.norm(), 1e-6);
}

// The robot and its servos, standing, with contacts of stiffness k at every corner.
class LooseAndRobot {
 public:
  LooseAndRobot(const std::string& scene, double mass, double k, double h)
      : model_(load_robot("hrp1s")) {
    for (Sole& sole : model_.soles) {
      sole.stiffness = kSoleCorners * k;
      sole.damping = kSoleCorners * std::sqrt(15.0 * k);
    }
    Eigen::VectorXd q = Eigen::VectorXd::Zero(model_.joint_count());
    const auto pose = static_cast<std::size_t>(model_.find_pose("half_sitting"));
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
      q[static_cast<Eigen::Index>(j)] = model_.poses[pose].q[j];
    }
    const Standing start = stand(model_, q, 1.0, {k, k}, {0.0, 0.0}, false);
    Configuration at = start.configuration;
    WorldConfig config;
    config.step = h;
    if (scene == "plate") {
      at.base.translation().z() += 0.041;
      config.loose = {light_box("plate", mass, {0.8, 0.8, 0.04}, {0.0, 0.0, 0.02}, k)};
    } else {
      Kinematics kinematics(model_);
      kinematics.update(at);
      // On the toes, where a box of 50 mm has room under the shin.
      const Sole& sole = model_.soles[0];
      const Eigen::Vector3d place = sole.frame * Eigen::Vector3d(0.12, 0.0, 0.02 + 0.026);
      config.loose = {
          light_box("box", mass, {0.05, 0.05, 0.05}, kinematics.link_in_world(sole.link) * place, k)};
    }
    world_ = std::make_unique<ArticulatedWorld>(model_, config);
    EXPECT_EQ(world_->set(at, &start.tau), Status::kOk);
    for (int j = 0; j < model_.joint_count(); ++j) {
      const Joint& joint = model_.joints[static_cast<std::size_t>(j)];
      EXPECT_EQ(world_->set_servo(
                    j, {.q = q[j], .qd = 0, .tau = start.tau[j], .kp = joint.kp, .kd = joint.kd}),
                Status::kOk);
    }
  }
  ArticulatedWorld& world() { return *world_; }

 private:
  Model model_;
  std::unique_ptr<ArticulatedWorld> world_;
};

// Order: box or plate, mass, stiffness, step, seconds.
void expect_quiet(const std::string& scene, double mass, double k, double h, double seconds) {
  SCOPED_TRACE(scene + " " + std::to_string(mass) + " kg, k " + std::to_string(k) + ", h " +
               std::to_string(h));
  LooseAndRobot both(scene, mass, k, h);
  ArticulatedWorld& world = both.world();
  const double height = world.loose(0).pose.translation().z();
  const auto steps = std::lround(seconds / h);
  for (long i = 0; i < steps; ++i) ASSERT_EQ(world.step(), Status::kOk) << i;
  EXPECT_NEAR(world.loose(0).pose.translation().z(), height, 3e-3);
  EXPECT_LT(world.loose(0).velocity.norm(), 5e-3);
  EXPECT_LT(world.com_velocity().norm(), 0.05);
  EXPECT_GT(world.configuration().base.linear()(2, 2), 0.99);
  EXPECT_EQ(world.counters().unconverged, 0);
}

TEST(LooseAndRobot, ABoxOnAFootAndAPlateUnderfootAreQuietAtEveryStep) {
  for (const double k : {1e6, 1e8}) {
    for (const double h : {1e-2, 1e-3}) {
      expect_quiet("box", 0.1, k, h, 0.5);
      expect_quiet("plate", 0.1, k, h, 0.5);
      expect_quiet("plate", 20.0, k, h, 0.5);
    }
    expect_quiet("box", 0.1, k, 1e-4, 0.1);
    expect_quiet("plate", 0.1, k, 1e-4, 0.1);
  }
}

TEST(LooseAndRobot, ABoxOnAFootAllocatesNothing) {
  LooseAndRobot both("box", 0.1, 1e6, 1e-3);
  for (int i = 0; i < 50; ++i) ASSERT_EQ(both.world().step(), Status::kOk);
  const NoAlloc guard;
  for (int i = 0; i < 200; ++i) (void)both.world().step();
  EXPECT_EQ(guard.count(), 0);
}

struct Kept {
  double linear, angular;  // change of momentum, relative
  double met;              // by so much did the box change its speed [m/s]
};

// A chain of links in the air and a box that hits it: momentum before and after, without what
// gravity gave.
Kept collide(double h) {
  Model model = test::chain(3, true);
  for (Link& link : model.links) {
    Shape shape;
    shape.size = {0.25, 0.1, 0.1};
    shape.pose.translation() = link.com;
    link.collision = {shape};
  }
  WorldConfig config;
  config.step = h;
  LooseBody body = light_box("b", 5.0, {0.5, 0.5, 0.1}, {0.35, 0.02, 49.8}, 1e5);
  body.start.velocity = {0.1, 0.0, 1.0};
  config.loose = {body};
  ArticulatedWorld world(model, config);
  Configuration start(model);
  start.base.translation() = Eigen::Vector3d(0, 0, 50);
  EXPECT_EQ(world.set(start), Status::kOk);
  const Eigen::Matrix3d inertia = inertia_of(body.solid, body.mass);
  const auto momenta = [&](Eigen::Vector3d& p, Eigen::Vector3d& l) {
    const LooseState b = world.loose(0);
    const double mass = world.mass() + body.mass;
    const Eigen::Vector3d com =
        (world.mass() * world.com() + body.mass * b.pose.translation()) / mass;
    p = world.mass() * world.com_velocity() + body.mass * b.velocity;
    const Eigen::Matrix3d r = b.pose.linear();
    l = r * inertia * r.transpose() * b.angular_velocity +
        body.mass * (b.pose.translation() - com).cross(b.velocity);
    for (int i = 0; i < model.link_count(); ++i) {
      const Link& link = model.links[static_cast<std::size_t>(i)];
      const Eigen::Isometry3d pose = world.link_in_world(i);
      const Eigen::Vector3d at = pose * link.com;
      l += pose.linear() * link.inertia * pose.linear().transpose() * world.angular_velocity(i) +
           link.mass * (at - com).cross(world.point_velocity(i, at));
    }
  };
  Eigen::Vector3d p0, l0, p1, l1;
  momenta(p0, l0);
  const auto steps = std::lround(0.3 / h);
  for (long i = 0; i < steps; ++i) EXPECT_EQ(world.step(), Status::kOk);
  momenta(p1, l1);
  p1.z() += (world.mass() + body.mass) * kGravity * 0.3;
  const double fallen = body.start.velocity.z() - 0.3 * kGravity;
  return {(p1 - p0).norm() / p0.norm(), (l1 - l0).norm() / l0.norm(),
          std::abs(world.loose(0).velocity.z() - fallen)};
}

TEST(LooseAndRobot, ACollisionKeepsMomentumToTheOrderOfTheStep) {
  const Kept coarse = collide(1e-3), fine = collide(1e-4);
  EXPECT_GT(coarse.met, 0.1);
  EXPECT_LT(coarse.linear, 1e-4);
  EXPECT_LT(coarse.angular, 2e-3);
  EXPECT_TRUE(fine.linear < 1e-9 || std::log10(coarse.linear / fine.linear) > 0.9)
      << coarse.linear << " " << fine.linear;
  EXPECT_GT(std::log10(coarse.angular / fine.angular), 0.9);
}

// The boxes numbered at random, and a box beside the stack among them.
TEST(LooseStack, ItStandsTheSameInWhateverOrderItsBoxesAreNamed) {
  const Model model = test::bystander();
  constexpr int kBoxes = 12;
  std::array<std::vector<double>, 2> heights;
  for (const std::size_t shuffled : {0u, 1u}) {
    WorldConfig config;
    config.step = 1e-3;
    for (int i = 0; i < kBoxes; ++i) {
      const int level = shuffled ? i * 7 % kBoxes : i;
      config.loose.push_back(
          light_box("b", 1.0 + 0.1 * level, {0.2, 0.2, 0.2}, {0.01 * (level % 3), 0, 0.1 + 0.2 * level}));
    }
    config.loose.insert(config.loose.begin() + 5, light_box("lone", 1.0, {0.2, 0.2, 0.2}, {1, 0, 0.1}));
    ArticulatedWorld world(model, config);
    for (int i = 0; i < 200; ++i) ASSERT_EQ(world.step(), Status::kOk);
    EXPECT_EQ(world.counters().unconverged, 0);
    for (int i = 0; i < world.loose_count(); ++i) {
      heights[shuffled].push_back(world.loose(i).pose.translation().z());
    }
    std::sort(heights[shuffled].begin(), heights[shuffled].end());
  }
  for (std::size_t i = 0; i < heights[0].size(); ++i) {
    EXPECT_NEAR(heights[0][i], heights[1][i], 1e-8);
  }
}

// Thrown boxes of 0.03 to 30 kg: every step settles inside the cone.
// A body that many others touch is eliminated last.
TEST(LooseStack, APlateCarriesManyBoxesAndAllocatesNothing) {
  const Model model = test::bystander();
  WorldConfig config = test::stepped(1e-3, 1);
  const auto at = [](double x, double y, double z) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Eigen::Vector3d(x, y, z);
    return pose;
  };
  config.loose.push_back(test::loose_box("plate", 4.0, {1.0, 1.0, 0.05}, at(0, 0, 0.025), 1e6, 1e3));
  for (int i = 0; i < 12; ++i)
    config.loose.push_back(test::loose_box("box" + std::to_string(i), 1.0, {0.1, 0.1, 0.1}, at(0.2 * (i % 4) - 0.3, 0.2 * (i / 4) - 0.2, 0.1), 1e6, 1e3));
  ArticulatedWorld world(model, config);
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  test::step_without_allocation(world, 500);
  EXPECT_EQ(world.unconverged(), 0);
  for (int i = 1; i <= 12; ++i) EXPECT_NEAR(world.loose(i).pose.translation().z(), 0.1, 2e-4);
}

// Two balls that meet while both fly as fast to the side part as they do without that.
TEST(LooseStress, WhatFliesTogetherMeetsAsAtRest) {
  const auto parted = [](double along) {
    WorldConfig config;
    config.step = 1e-2;
    for (const double side : {-1.0, 1.0}) {
      LooseBody ball;
      ball.name = side < 0.0 ? "left" : "right";
      ball.mass = 1.0;
      ball.solid = {SolidShape::kSphere, {0.1, 0, 0}};
      ball.stiffness = 1e4;
      ball.start.pose.translation() = Eigen::Vector3d(0.23 * side, 0, 100.0);
      ball.start.velocity = Eigen::Vector3d(-2.0 * side, along, 0);
      config.loose.push_back(ball);
    }
    ArticulatedWorld world(test::bystander(), config);
    EXPECT_EQ(world.set(Configuration(test::bystander())), Status::kOk);
    for (int i = 0; i < 30; ++i) EXPECT_EQ(world.step(), Status::kOk);
    return Eigen::Vector2d(world.loose(0).velocity.x(), world.loose(1).velocity.x());
  };
  const Eigen::Vector2d at_rest = parted(0.0);
  EXPECT_LT(at_rest[0], 0.0);  // they went back, not through
  EXPECT_GT(at_rest[1], 0.0);
  EXPECT_LT((parted(80.0) - at_rest).norm(), 1e-8);
}

TEST(KeyIndex, FindsWhatWasPutInFirst) {
  KeyIndex index;
  EXPECT_EQ(index.find(3), -1);
  index.reserve(100);
  for (int time = 0; time < 2; ++time) {
    for (int i = 0; i < 200; ++i) index.add(1000003 * (i % 100), i);  // what there is no room for is left out
    for (int i = 0; i < 100; ++i) EXPECT_EQ(index.find(1000003 * i), i);
    EXPECT_EQ(index.find(7), -1);
    index.clear();
    EXPECT_EQ(index.find(1000003), -1);
  }
}

TEST(LooseStress, ATumblingBoxAlwaysSettlesInsideTheCone) {
  const Model model = test::bystander();
  Random random(3);
  const auto u = [&] { return 2.0 * random.uniform() - 1.0; };
  // Friction above 4/3 has struck corners that several forces would fit.
  for (const double k : {1e5, 1e6, 1e7, 1e8}) {
    const double most = k > 5e7 ? 1.5 : 0.8;
    for (const double h : {1e-2, 1e-3}) {
      for (int thrown = 0; thrown < 6; ++thrown) {
        WorldConfig config;
        config.step = h;
        LooseBody body = light_box("b", std::pow(10.0, 1.5 * u()), {0.2, 0.3, 0.1}, {0, 0, 0.2}, k);
        body.friction = config.ground_friction = 0.3 + (most - 0.3) * std::abs(u());
        body.start.pose.linear() =
            Eigen::Quaterniond(u(), u(), u(), u()).normalized().toRotationMatrix();
        body.start.velocity = {2.0 * u(), 2.0 * u(), -1.0};
        body.start.angular_velocity = 10.0 * Eigen::Vector3d(u(), u(), u());
        config.loose = {body};
        ArticulatedWorld world(model, config);
        const auto steps = std::lround(1.0 / h);
        for (long i = 0; i < steps; ++i) {
          ASSERT_EQ(world.step(), Status::kOk);
          for (const Contact& c : world.solved()) {
            const double fn = c.normal.dot(c.now.force);
            ASSERT_LE((c.now.force - fn * c.normal).norm(), c.params.friction * fn * (1.0 + 1e-10));
          }
        }
        EXPECT_EQ(world.unconverged(), 0) << k << " " << h << " " << thrown;
        EXPECT_LT(world.loose(0).velocity.norm(), 3.0);
      }
    }
  }
}

// A body spun about its middle axis turns over again and again (Dzhanibekov), 11 times in 60 s.
TEST(FreeTurn, ABodyTurnsOverElevenTimesAndKeepsEnergyAndMomentum) {
  const Eigen::Vector3d inertia(0.01, 0.02, 0.028);
  for (const double h : {1e-2, 1e-3}) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    Eigen::Vector3d spin(0.01, 5.0, 0.0);
    const auto momentum = [&] {
      return Eigen::Vector3d(pose.linear() * inertia.cwiseProduct(pose.linear().transpose() * spin));
    };
    const Eigen::Vector3d l0 = momentum();
    const double e0 = 0.5 * spin.dot(l0);
    int flips = 0;
    bool up = true;
    for (long i = 0; i < std::lround(60.0 / h); ++i) {
      turn_freely(inertia, h, pose, spin);
      const bool now = pose.linear().col(1).dot(spin) > 0.0;
      flips += now != up ? 1 : 0;
      up = now;
    }
    EXPECT_EQ(flips, 11) << h;
    EXPECT_LT((momentum() - l0).norm() / l0.norm(), 1e-9) << h;
    EXPECT_LT(std::abs(0.5 * spin.dot(momentum()) / e0 - 1.0), 1e-9) << h;
  }
}

// A needle: what its spin about the short axis is in terms of the long one is more than an int holds.
TEST(FreeTurn, ANeedleTurnsAsFarAsAnythingElse) {
  for (const double thin : {1e-2, 1e-6, 1e-10, 1e-14}) {
    const Eigen::Vector3d inertia(1.0, 1.0, thin);
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    Eigen::Vector3d spin(100.0, 0.0, 0.0);
    for (int i = 0; i < 5; ++i) turn_freely(inertia, 0.002, pose, spin);
    EXPECT_NEAR(std::atan2(pose(2, 1), pose(1, 1)), 1.0, 1e-3) << thin;
    EXPECT_NEAR(spin.x(), 100.0, 1e-9) << thin;
  }
}

// Of many speeds and shapes, so that lanes need sweeps and parts of their own; one does not turn at all.
TEST(FreeTurn, FourBodiesTurnAsEachByItself) {
  Random random(5);
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * (random.uniform() - 0.5), size * (random.uniform() - 0.5), size * (random.uniform() - 0.5));
  };
  for (int round = 0; round < 200; ++round) {
    std::array<Eigen::Vector3d, kFreeLanes> inertia, spin, spin_alone;
    std::array<Eigen::Isometry3d, kFreeLanes> pose, pose_alone;
    std::array<FreeRotation, kFreeLanes> all;
    for (std::size_t k = 0; k < all.size(); ++k) {
      inertia[k] = (vector(1.0).cwiseAbs() + Eigen::Vector3d::Constant(0.01)) * std::pow(10.0, -3.0 * random.uniform());
      spin[k] = spin_alone[k] = round % 10 == 0 && k == 2 ? Eigen::Vector3d(0, 0, 0) : vector(std::pow(10.0, 4.0 * random.uniform() - 1.0));
      pose[k] = Eigen::Translation3d(vector(5.0)) * Eigen::AngleAxisd(3.0 * random.uniform(), vector(1.0).normalized());
      pose_alone[k] = pose[k];
      all[k] = {&inertia[k], &pose[k], &spin[k]};
    }
    turn_freely(all.data(), kFreeLanes, 0.002);
    for (std::size_t k = 0; k < all.size(); ++k) {
      turn_freely(inertia[k], 0.002, pose_alone[k], spin_alone[k]);
      EXPECT_EQ(pose[k].matrix(), pose_alone[k].matrix()) << round << " " << k;
      EXPECT_EQ(spin[k], spin_alone[k]) << round << " " << k;
    }
  }
}

}  // namespace
}  // namespace twinbus
