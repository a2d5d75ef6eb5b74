#include "sim/world/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TWINBUS_BOTH_ENGINES(WorldTest);

Configuration high_up(const Model& model) {
  Configuration start(model);
  start.base.translation().z() = 50.0;
  return start;
}

TEST_P(WorldTest, AFreeRobotFallsWithG) {
  const Model model = test::chain(6, true);
  Configuration start = high_up(model);
  start.qd << 0.5, -1.0, 0.3, 0.8, -0.2, 0.4;
  const auto world_owner = make_at(start, model);
  World& world = *world_owner;
  const Eigen::Vector3d com = world.com();
  const Eigen::Vector3d velocity = world.com_velocity();
  const int steps = 500;
  for (int i = 0; i < steps; ++i) ASSERT_EQ(world.step(), Status::kOk);
  const double t = steps * 0.002;
  EXPECT_NEAR((world.com_velocity() - velocity).z(), -kGravity * t, 1e-6);
  EXPECT_NEAR(world.com().z() - com.z() - velocity.z() * t, -0.5 * kGravity * t * (t + 0.002),
              1e-5);
  EXPECT_NEAR(world.com_velocity().x(), velocity.x(), 1e-6);
}

TEST_P(WorldTest, ServosCannotChangeMomentum) {
  const Model model = test::chain(6, true);
  const auto world_owner = make_at(high_up(model), model);
  World& world = *world_owner;
  Kinematics kinematics(model);
  for (int i = 0; i < 300; ++i) {
    for (int j = 0; j < 6; ++j) {
      ASSERT_EQ(
          world.set_servo(j, {.q = std::sin(0.01 * i + j), .qd = 0, .tau = 0, .kp = 500, .kd = 20}),
          Status::kOk);
    }
    ASSERT_EQ(world.step(), Status::kOk);
  }
  kinematics.update(world.configuration());
  EXPECT_LT(kinematics.angular_momentum().norm(), 0.02);  // of about 1 kg m^2/s in each part
  EXPECT_NEAR(world.com_velocity().x(), 0.0, 1e-6);
}

// Swinging on a fixed base: what the servos do in work is what kinetic and potential energy gain.
// First order in time.
TEST_P(WorldTest, WorkOfTheServosIsTheGainInEnergy) {
  const Model model = test::chain(4, false);
  WorldConfig config;
  config.step = 1e-4;
  const auto world_owner = make_hung(model, config);
  World& world = *world_owner;
  Kinematics kinematics(model);
  InverseDynamics dynamics(model);
  Eigen::VectorXd tau(4), before(4);
  const double start = test::energy(model, world, kinematics);
  double work = 0.0;
  for (int i = 0; i < 3000; ++i) {
    before = world.configuration().qd;
    for (int j = 0; j < 4; ++j) {
      ASSERT_EQ(world.set_servo(
                    j, {.q = 0.4 * std::sin(0.002 * i + j), .qd = 0, .tau = 0, .kp = 60, .kd = 2}),
                Status::kOk);
    }
    ASSERT_EQ(world.step(), Status::kOk);
    for (int j = 0; j < 4; ++j)
      work += config.step * world.tau(j) * 0.5 * (before[j] + world.configuration().qd[j]);
    // Inverse dynamics of the motion made needs the torque that the servo gave.
    if (i % 500 == 499) {
      kinematics.update(world.configuration());
      const Eigen::VectorXd qdd = (world.configuration().qd - before) / config.step;
      (void)dynamics.solve(kinematics, world.configuration(), qdd, Eigen::Vector3d::Zero(),
                           Eigen::Vector3d::Zero(), {}, tau);
      for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(tau[j], world.tau(j), 0.02 * (1.0 + std::abs(world.tau(j)))) << i << j;
    }
  }
  EXPECT_NEAR(test::energy(model, world, kinematics) - start, work, 0.01 * std::abs(work) + 0.02);
}

TEST_P(WorldTest, JointsStayTogether) {
  const Model model = load_robot("hrp1s");
  const auto world_owner = make(model);
  World& world = *world_owner;
  Configuration start(model);
  start.base.translation().z() = 5.0;
  start.base_angular_velocity = {1.0, 2.0, -1.0};
  ASSERT_EQ(world.set(start), Status::kOk);
  for (int i = 0; i < 400; ++i) ASSERT_EQ(world.step(), Status::kOk);
  Kinematics kinematics(model);
  kinematics.update(world.configuration());
  for (int i = 0; i < model.link_count(); ++i) {
    EXPECT_LT(
        (kinematics.link_in_world(i).translation() - world.link_in_world(i).translation()).norm(),
        2e-4)
        << i;
  }
}

TEST_P(WorldTest, RefusesWhatIsNotANumberAndGoesOn) {
  const Model model = test::pendulum();
  const auto world_owner = make_hung(model);
  World& world = *world_owner;
  for (int field = 0; field < 5; ++field) {
    for (const double bad : {kNotANumber, std::numeric_limits<double>::infinity(), 1e300}) {
      double n[5] = {0, 0, 0, 10, 1};
      n[field] = bad;
      EXPECT_NE(world.set_servo(0, {.q = n[0], .qd = n[1], .tau = n[2], .kp = n[3], .kd = n[4]}),
                Status::kOk);
    }
  }
  EXPECT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = -1, .kd = 0}),
            Status::kOutOfRange);
  EXPECT_EQ(world.set_servo(7, {}), Status::kWrongSize);
  Configuration bad(model);
  bad.q[0] = kNotANumber;
  EXPECT_EQ(world.set(bad), Status::kNotFinite);
  bad = Configuration(model);
  bad.base_velocity.x() = kNotANumber;
  EXPECT_EQ(world.set(bad), Status::kNotFinite);
  EXPECT_EQ(world.push(1, Eigen::Vector3d::Zero(), {kNotANumber, 0, 0}), Status::kNotFinite);
  EXPECT_EQ(world.step(), Status::kOk);
}

TEST_P(WorldTest, FreezesInsteadOfEndingTheProcess) {
  const Model model = test::pendulum(1e9);
  const auto world_owner = make_hung(model);
  World& world = *world_owner;
  ASSERT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 9e8, .kp = 0, .kd = 0}), Status::kOk);
  Status status = Status::kOk;
  for (int i = 0; i < 100 && status == Status::kOk; ++i) status = world.step();
  EXPECT_EQ(status, Status::kDiverged);
  EXPECT_TRUE(world.configuration().q.allFinite());
  EXPECT_EQ(world.step(), Status::kDiverged);
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);  // thawed
  ASSERT_EQ(world.set_servo(0, {}), Status::kOk);
  EXPECT_EQ(world.step(), Status::kOk);
}

TEST_P(WorldTest, RefusesALinkWithoutMassByName) {
  Model model = test::pendulum();
  model.links[1].mass = 0.0;
  try {
    (void)make(model);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("'arm'"), std::string::npos);
  }
}

}  // namespace
}  // namespace twinbus
