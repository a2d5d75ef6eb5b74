// Motion that touches nothing: order of the explicit methods, and when they hand over.

#include "sim/articulated/free_flight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/energy.h"
#include "sim/engine/articulated_world.h"
#include "sim/articulated/spatial.h"
#include "common/allocation/no_alloc.h"
#include "test_models.h"

namespace twinbus {
namespace {

// Where the last link of a tumbling chain is after half a second.
Eigen::Vector3d tumbled(Flight flight, double step, double error = 0.0) {
  const Model model = test::chain(4, true);
  WorldConfig config;
  config.flight = flight;
  config.flight_error = error;
  config.step = step;
  ArticulatedWorld world(model, config);
  Configuration start(model);
  start.base.translation().z() = 50.0;
  start.base_angular_velocity = {2.0, -1.0, 1.5};
  start.q << 0.3, -0.4, 0.2, 0.1;
  start.qd << 0.5, -1.0, 0.3, 0.8;
  EXPECT_EQ(world.set(start), Status::kOk);
  const auto steps = static_cast<int>(std::lround(0.5 / step));
  const NoAlloc guard;
  for (int i = 0; i < steps; ++i) EXPECT_EQ(world.step(), Status::kOk);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_EQ(world.flown(), flight == Flight::kImplicit ? 0 : steps);
  return world.link_in_world(4).translation();
}

TEST(Flight, MethodsHaveTheirOrderOnATurningBase) {
  const Eigen::Vector3d exact = tumbled(Flight::kRkf78, 1e-3);
  EXPECT_LT((tumbled(Flight::kRkf78, 1e-2) - exact).norm(), 1e-11);
  const auto ratio = [&](Flight flight) {
    return (tumbled(flight, 5e-3) - exact).norm() / (tumbled(flight, 2.5e-3) - exact).norm();
  };
  EXPECT_NEAR(ratio(Flight::kRk4), 16.0, 2.0);
  EXPECT_NEAR(ratio(Flight::kAb4), 16.0, 5.0);
  EXPECT_LT((tumbled(Flight::kRk4, 2.5e-3) - exact).norm(), 1e-7);
  const auto coarse = [&](double step) { return (tumbled(Flight::kGauss8, step) - exact).norm(); };
  EXPECT_NEAR(std::log(coarse(0.125) / coarse(0.1)) / std::log(1.25), 8.0, 1.0);
  EXPECT_LT(coarse(1e-2), 1e-11);
}

// In steps of which one would be much too long.
TEST(Flight, GaussTakesAStepInAsManyPartsAsItsErrorAllows) {
  const Eigen::Vector3d exact = tumbled(Flight::kRkf78, 1e-3);
  for (const double step : {0.5, 0.25}) {
    EXPECT_LT((tumbled(Flight::kGauss8, step, 1e-5) - exact).norm(), 1e-5);
    EXPECT_LT((tumbled(Flight::kGauss8, step, 1e-8) - exact).norm(), 1e-8);
  }
  // Shorter ones are taken whole.
  EXPECT_EQ(tumbled(Flight::kGauss8, 2e-3, 1e-5), tumbled(Flight::kGauss8, 2e-3, 1e-4));
}

// Where a chain of n links that is thrown turning has its links after a second.
Eigen::Matrix3Xd thrown(int n, double spin, Flight flight, double step, double error = 0.0) {
  WorldConfig config;
  config.flight = flight;
  config.flight_error = error;
  config.step = step;
  const Model model = test::chain(n, true);
  ArticulatedWorld world(model, config);
  Configuration start(model);
  start.base.translation().z() = 100.0;
  start.base_angular_velocity = Eigen::Vector3d(1.0, 2.0, 0.5) * spin;
  for (int j = 0; j < n; ++j) start.qd[j] = 0.2 * std::sin(1.0 + j);
  EXPECT_EQ(world.set(start), Status::kOk);
  const auto steps = static_cast<int>(std::lround(1.0 / step));
  for (int i = 0; i < steps; ++i) EXPECT_EQ(world.step(), Status::kOk);
  EXPECT_EQ(world.flown(), steps) << n << " links, error " << error;
  Eigen::Matrix3Xd links(3, n + 1);
  for (int i = 0; i <= n; ++i) links.col(i) = world.link_in_world(i).translation();
  return links;
}

// Slow and fast ones, of which the longer ones whip.
TEST(Flight, GaussKeepsToTheErrorThatIsNamed) {
  for (const int n : {2, 4, 7}) {
    for (const double spin : {0.5, 1.0}) {
      const Eigen::Matrix3Xd exact = thrown(n, spin, Flight::kRkf78, 1e-3);
      for (const double error : {1e-5, 1e-6, 1e-7, 1e-8}) {
        const Eigen::Matrix3Xd found = thrown(n, spin, Flight::kGauss8, 1.0, error);
        EXPECT_LT((found - exact).colwise().norm().maxCoeff(), error) << n << ' ' << spin;
      }
    }
  }
}

TEST(Flight, WhatComesDownIsCaughtByTheImplicitSolve) {
  const Model model = test::block();
  for (const Flight flight : {Flight::kAb4, Flight::kRk4, Flight::kRkf78, Flight::kGauss8}) {
    WorldConfig config;
    config.flight = flight;
    ArticulatedWorld world(model, config);
    Configuration start(model);
    start.base.translation().z() = 0.3;
    ASSERT_EQ(world.set(start), Status::kOk);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(world.step(), Status::kOk);
    EXPECT_GT(world.flown(), 50);
    EXPECT_LT(world.flown(), 300);
    EXPECT_NEAR(world.configuration().base.translation().z(), -world.mass() * kGravity / 2e5, 1e-4);
  }
}

// A servo that an explicit step of this size would not survive, a joint with friction.
TEST(Flight, WhatIsStiffOrRoughIsLeftToTheImplicitSolve) {
  Model model = test::chain(3, true);
  WorldConfig config;
  config.flight = Flight::kRk4;
  Configuration start(model);
  start.base.translation().z() = 50.0;
  ArticulatedWorld stiff(model, config);
  ASSERT_EQ(stiff.set(start), Status::kOk);
  ASSERT_EQ(stiff.set_servo(1, {.q = 0.5, .qd = 0.0, .tau = 0.0, .kp = 1e6, .kd = 1e3}),
            Status::kOk);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(stiff.step(), Status::kOk);
  EXPECT_EQ(stiff.flown(), 0);
  EXPECT_NEAR(stiff.configuration().q[1], 0.5, 0.5);
  model.joints[0].friction = 0.1;
  ArticulatedWorld rough(model, config);
  ASSERT_EQ(rough.set(start), Status::kOk);
  ASSERT_EQ(rough.step(), Status::kOk);
  EXPECT_EQ(rough.flown(), 0);
}

// For a hundred seconds, in steps in which the chain turns by several degrees.
TEST(Flight, AChainSwingsByGaussWithoutLosingEnergy) {
  const Model model = test::chain(2, true);
  WorldConfig config;
  config.flight = Flight::kGauss8;
  config.fixed_base = true;
  config.step = 0.02;
  ArticulatedWorld world(model, config);
  Configuration start(model);
  start.base.translation().z() = 50.0;
  start.base.linear() = Eigen::AngleAxisd(0.5 * M_PI, Eigen::Vector3d::UnitY()).toRotationMatrix();
  start.q << 0.4, -0.2;
  ASSERT_EQ(world.set(start), Status::kOk);
  Kinematics kinematics(model);
  const auto energy = [&] {
    kinematics.update(world.configuration());
    return mechanical_energy(kinematics, world.configuration());
  };
  const double before = energy();
  double worst = 0.0, fastest = 0.0;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    worst = std::max(worst, std::abs(energy() - before));
    fastest = std::max(fastest, world.configuration().qd.norm());
  }
  EXPECT_EQ(world.flown(), 5000);
  EXPECT_GT(fastest, 1.0);
  EXPECT_LT(worst, 1e-9);
}

// Four postures, each shaken away from one another by its number.
struct FourAndOne {
  FourAndOne(const Model& model, bool fixed)
      : four(model, fixed, 1.2),
        one(model, fixed, 1.2),
        at(4, Configuration(model)),
        rows(model.joints.size()),
        accelerations(4, FourPostures::kFirstJoint + model.joint_count()) {
    for (int p = 0; p < 4; ++p) {
      Configuration& c = at[static_cast<std::size_t>(p)];
      // Of a fixed base they are all the same.
      const double turn = fixed ? 0.0 : p;
      c.base.linear() = Eigen::AngleAxisd(0.4 + turn, Eigen::Vector3d(1, turn, 2).normalized())
                            .toRotationMatrix();
      if (!fixed) {
        c.base_angular_velocity = {0.3, -0.2 * p, 0.5};
        c.base_velocity = {1.0, 0.1 * p, -0.4};
        const Eigen::Vector3d spin = c.base.linear().transpose() * c.base_angular_velocity;
        four.spin().row(p) = spin.transpose().array();
      }
      for (int j = 0; j < model.joint_count(); ++j) {
        c.q[j] = 0.3 * std::sin(1.0 + 2 * p + j);
        c.qd[j] = std::cos(2.0 * p - j);
        four.q()(p, j) = c.q[j];
        four.qd()(p, j) = c.qd[j];
        four.torque()(p, j) = 0.7 * p - j;
      }
    }
    if (fixed) four.hold(at[0].base.linear());
  }

  // How far the accelerations of the four are from those of each alone.
  double off() {
    double most = 0.0;
    for (int p = 0; p < 4; ++p) {
      const Configuration& c = at[static_cast<std::size_t>(p)];
      for (std::size_t j = 0; j < rows.size(); ++j) {
        rows[j] = {.force = 0.7 * p - static_cast<double>(j), .gain = 0.0};
      }
      one.place(c);
      EXPECT_TRUE(one.inward(rows, 0.0));
      one.outward();
      for (int k = 0; k < static_cast<int>(rows.size()); ++k) {
        const double qdd = one.qdd(k);
        const double found = accelerations(p, FourPostures::kFirstJoint + k);
        most = std::max(most, std::abs(found - qdd) / (1.0 + std::abs(qdd)));
      }
      // The origin's acceleration is the spatial one and the turning of its velocity.
      const Screw a = one.acceleration(0);
      const Eigen::Matrix3d axes = c.base.linear().transpose();
      const Eigen::Vector3d felt =
          axes * (linear(a) + c.base_angular_velocity.cross(c.base_velocity) +
                  Eigen::Vector3d(0, 0, kGravity));
      const Eigen::Vector3d turning = axes * angular(a);
      most = std::max({most, (accelerations.row(p).head<3>().matrix().transpose() - felt).norm(),
                       (accelerations.row(p).segment<3>(3).matrix().transpose() - turning).norm()});
    }
    return most;
  }

  FourPostures four;
  ArticulatedBody one;
  std::vector<Configuration> at;
  std::vector<JointRow> rows;
  FourPostures::Accelerations accelerations;
};

// A branching robot whose joints turn about axes of their own and any other.
Model branching() {
  Model model = test::chain(6, true);
  model.joints[3].parent = model.links[4].parent = 1;
  model.joints[2].axis = Eigen::Vector3d(1, 2, -2) / 3.0;
  model.joints[4].axis = -Eigen::Vector3d::UnitX();
  model.joints[5].placement.linear() =
      Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()).toRotationMatrix();
  model.joints[1].rotor_inertia = 0.2;
  return model;
}

TEST(FourPostures, AccelerateLikeOneEach) {
  for (const bool fixed : {false, true}) {
    FourAndOne robots(branching(), fixed);
    robots.accelerations.setConstant(2.0);
    ASSERT_TRUE(robots.four.weigh());
    robots.four.improve(robots.accelerations, robots.accelerations);
    EXPECT_LT(robots.off(), 1e-10);
  }
}

TEST(FourPostures, FromAGuessComeToTheSame) {
  for (const bool fixed : {false, true}) {
    FourAndOne robots(branching(), fixed);
    // Weighed nearby: each further guess is much better.
    robots.accelerations.setZero();
    robots.four.q() += 0.002;
    ASSERT_TRUE(robots.four.weigh());
    robots.four.q() -= 0.002;
    double before = robots.off();
    EXPECT_GT(before, 1e-3);
    for (int i = 0; i < 3; ++i) {
      robots.four.improve(robots.accelerations, robots.accelerations);
      EXPECT_LT(robots.off(), 0.3 * before);
      before = robots.off();
    }
  }
}

// A wrist and a hip: joints of every axis that share an origin, and that do not, of links that are as
// lopsided as can be.
Model lopsided() {
  Model model = test::chain(8, true);
  for (const std::size_t j : {1U, 2U, 3U}) model.joints[j].placement.translation().setZero();
  for (const std::size_t j : {4U, 5U, 6U}) {
    model.joints[j].placement.translation() = Eigen::Vector3d(0.1, -0.2, 0.3);
  }
  model.joints[7].axis = Eigen::Vector3d(2, -1, 2) / 3.0;
  model.joints[7].placement.translation().setZero();
  for (Link& link : model.links) {
    const Eigen::Matrix3d axes =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    link.inertia = axes * Eigen::Vector3d(0.01, 0.03, 0.035).asDiagonal() * axes.transpose();
    link.com = {0.1, -0.07, 0.05};
  }
  return model;
}

TEST(FourPostures, WithOriginsTogetherToo) {
  for (const bool fixed : {false, true}) {
    FourAndOne robots(lopsided(), fixed);
    robots.accelerations.setZero();
    ASSERT_TRUE(robots.four.weigh());
    robots.four.improve(robots.accelerations, robots.accelerations);
    EXPECT_LT(robots.off(), 1e-10);
    EXPECT_LT(robots.four.improve(robots.accelerations, robots.accelerations), 1e-10);
  }
}

TEST(FourPostures, SayHowMuchTheyChange) {
  FourAndOne robots(lopsided(), false);
  ASSERT_TRUE(robots.four.weigh());
  FourPostures::Accelerations first = robots.accelerations, second = first;
  first.setZero();
  const double change = robots.four.improve(first, second);
  EXPECT_NEAR(change, (second - first).matrix().norm() / 2.0, 1e-9 * change);
  robots.four.q()(2, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(robots.four.improve(first, second) < HUGE_VAL);
}

TEST(FourPostures, EveryInstructionSetGivesTheSameToRounding) {
  std::vector<FourPostures::Accelerations> found;
  for (const Simd level : {Simd::kBaseline, Simd::kAvx2, Simd::kAvx512}) {
    lower_simd(level);
    FourAndOne robots(lopsided(), false);
    robots.accelerations.setZero();
    EXPECT_TRUE(robots.four.weigh());
    robots.four.improve(robots.accelerations, robots.accelerations);
    found.push_back(robots.accelerations);
  }
  lower_simd(Simd::kAvx512);
  for (const FourPostures::Accelerations& one : found) {
    EXPECT_LT(((one - found[0]).abs() / (1.0 + found[0].abs())).maxCoeff(), 1e-12);
  }
}

TEST(FourPostures, SlideToo) {
  Model model = branching();
  model.joints[1].kind = model.joints[5].kind = JointKind::kPrismatic;
  for (const bool fixed : {false, true}) {
    FourAndOne robots(model, fixed);
    robots.accelerations.setZero();
    ASSERT_TRUE(robots.four.weigh());
    robots.four.improve(robots.accelerations, robots.accelerations);
    EXPECT_LT(robots.off(), 1e-10);
  }
}

}  // namespace
}  // namespace twinbus
