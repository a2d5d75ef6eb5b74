#include "sim/scene/sensors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

TWINBUS_BOTH_ENGINES(SensorsTest);

// At a pendulum that hangs still.
class HungSensorsTest : public test::BothEngines {
 protected:
  const Model model = test::pendulum();
  const std::unique_ptr<World> hung = make_hung(model);
  World& world = *hung;
};
TWINBUS_FOR_BOTH_ENGINES(HungSensorsTest);

TEST_P(HungSensorsTest, AtRestTheAccelerometerFeelsGravityUpwards) {
  Sensors sensors(model, {});
  RobotState state;
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    sensors.measure(world, 0.002, state);
  }
  EXPECT_NEAR(state.accel[2], kGravity, 1e-5);
  EXPECT_NEAR(state.accel[0], 0.0, 1e-5);
  EXPECT_EQ(state.wrench_kind[kLeftFoot], WrenchKind::kAbsent);
  EXPECT_EQ(state.joint_count, 1);
}

TEST_P(SensorsTest, FallingFreelyTheAccelerometerFeelsNothing) {
  Model model = test::chain(2, true);
  const auto world_owner = make(model);
  World& world = *world_owner;
  Configuration start(model);
  start.base.translation().z() = 20.0;
  ASSERT_EQ(world.set(start), Status::kOk);
  Sensors sensors(model, {});
  RobotState state;
  for (int i = 0; i < 5; ++i) {
    ASSERT_EQ(world.step(), Status::kOk);
    sensors.measure(world, 0.002, state);
  }
  for (float a : state.accel) EXPECT_NEAR(a, 0.0, 1e-3);
}

TEST_P(SensorsTest, AttitudeAndGyroAreThoseOfTheImuFrame) {
  Model model = test::chain(2, true);
  model.imu.linear() = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto world_owner = make(model);
  World& world = *world_owner;
  Configuration at(model);
  at.base.translation().z() = 20.0;
  at.base.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  at.base_angular_velocity = {0.0, 0.0, 1.0};
  ASSERT_EQ(world.set(at), Status::kOk);
  Sensors sensors(model, {});
  RobotState state;
  sensors.measure(world, 0.0, state);
  const Eigen::Matrix3d imu = at.base.linear() * model.imu.linear();
  const Eigen::Quaternionf measured(state.attitude[0], state.attitude[1], state.attitude[2],
                                    state.attitude[3]);
  EXPECT_LT((measured.toRotationMatrix().cast<double>() - imu).norm(), 1e-6);
  EXPECT_NEAR(state.gyro[1], std::sin(0.5), 1e-6);
  EXPECT_NEAR(state.gyro[2], std::cos(0.5), 1e-6);
}

TEST_P(SensorsTest, FootWrenchIsThatOfTheContactsInTheSensorFrame) {
  Model model = test::block();
  const auto world_owner = make_at(test::standing_block(model), model);
  World& world = *world_owner;
  ASSERT_EQ(world.step(), Status::kOk);
  Sensors sensors(model, {});
  RobotState state;
  sensors.measure(world, 0.002, state);
  const double weight = world.mass() * kGravity;
  EXPECT_NEAR(state.wrench[kLeftFoot][2], 0.5 * weight, 0.5);
  EXPECT_NEAR(state.wrench[kRightFoot][2], 0.5 * weight, 0.5);
  EXPECT_NEAR(state.wrench[kLeftFoot][3], 0.0, 0.05);
  EXPECT_NEAR(state.wrench[kRightFoot][4], 0.0, 0.05);
  EXPECT_NE(state.sensor_flags & wrench_valid(kLeftFoot), 0);
}

TEST_P(HungSensorsTest, NoiseBiasAndCountsAreAsAsked) {
  SensorOptions options;
  options.encoder.noise = 1e-3;
  options.gyro.noise = 0.02;
  options.gyro.bias = 0.1;
  options.accel.noise = 0.5;
  options.yaw_drift = 0.003;
  Sensors sensors(model, options);
  RobotState state;
  const int n = 20000;
  double q = 0, q2 = 0, g = 0, g2 = 0, a = 0, a2 = 0;
  for (int i = 0; i < n; ++i) {
    sensors.measure(world, 0.002, state);
    q += state.q[0];
    q2 += state.q[0] * state.q[0];
    const double gyro = static_cast<double>(state.gyro[0]);
    g += gyro;
    g2 += gyro * gyro;
    const double accel = static_cast<double>(state.accel[2]);
    a += accel;
    a2 += accel * accel;
  }
  EXPECT_NEAR(q / n, 0.0, 5e-5);
  EXPECT_NEAR(std::sqrt(q2 / n), 1e-3, 3e-5);
  EXPECT_NEAR(g / n, 0.1, 1e-3);
  EXPECT_NEAR(std::sqrt(g2 / n - g * g / n / n), 0.02, 6e-4);
  EXPECT_NEAR(a / n, kGravity, 0.02);
  EXPECT_NEAR(std::sqrt(a2 / n - a * a / n / n), 0.5, 0.02);
  // 40 s of drift at 3 mrad/s.
  EXPECT_NEAR(2.0F * std::atan2(state.attitude[3], state.attitude[0]), 0.12F, 1e-4F);

  SensorOptions counts;
  counts.encoder.quantum = 0.01;
  Sensors coarse(model, counts);
  Configuration at(model);
  at.q[0] = 0.123;
  ASSERT_EQ(world.set(at), Status::kOk);
  coarse.measure(world, 0.002, state);
  EXPECT_DOUBLE_EQ(state.q[0], 0.12);
}

TEST(ImperfectionTest, ReadsWithBiasSaturationAndCounts) {
  Random random(1);
  const Imperfection sensor{.bias = 0.3, .quantum = 0.5, .limit = 2.2};
  EXPECT_DOUBLE_EQ(sensor.read(0.0, random), 0.5);
  EXPECT_DOUBLE_EQ(sensor.read(-0.6, random), -0.5);
  EXPECT_DOUBLE_EQ(sensor.read(9.0, random), 2.0);  // the last whole count below the limit
  EXPECT_DOUBLE_EQ(sensor.read(-9.0, random), -2.0);
  EXPECT_DOUBLE_EQ(Imperfection{}.read(0.1234, random), 0.1234);
}

TEST_P(SensorsTest, ASlowSensorHoldsItsLastSample) {
  Model model = test::pendulum();
  model.imu_link = 1;  // on what swings
  const auto world_owner = make_hung(model);
  World& world = *world_owner;
  SensorOptions options;
  options.encoder_rate = 100.0;  // every fifth tick
  Sensors sensors(model, options);
  RobotState state;
  for (int i = 0; i < 20; ++i) {
    Configuration at(model);
    at.q[0] = 0.01 * i;
    at.qd[0] = 0.1 * i;
    ASSERT_EQ(world.set(at), Status::kOk);
    sensors.measure(world, 0.002, state);
    EXPECT_NEAR(state.q[0], 0.01 * (i - i % 5), 1e-12) << i;
    EXPECT_NEAR(state.gyro[1], 0.1 * i, 1e-6) << "the IMU has a rate of its own";
  }
}

TEST_P(SensorsTest, AnInclinationSensorReadsNoFurtherThanItsRange) {
  const Model model = test::chain(2, true);
  const auto world_owner = make(model);
  World& world = *world_owner;
  Configuration at(model);
  at.base.translation().z() = 20.0;
  at.base.linear() = (Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()) *
                      Eigen::AngleAxisd(0.111, Eigen::Vector3d::UnitX()))
                         .toRotationMatrix();
  ASSERT_EQ(world.set(at), Status::kOk);
  SensorOptions options;
  options.inclination.limit = 0.35;
  options.inclination.quantum = 0.01;
  Sensors sensors(model, options);
  RobotState state;
  sensors.measure(world, 0.0, state);
  const Eigen::Matrix3d read =
      Eigen::Quaternionf(state.attitude[0], state.attitude[1], state.attitude[2], state.attitude[3])
          .toRotationMatrix()
          .cast<double>();
  EXPECT_NEAR(std::asin(-read(2, 0)), -0.35, 1e-6);
  EXPECT_NEAR(std::atan2(read(2, 1), read(2, 2)), 0.11, 1e-6);
  EXPECT_NEAR(std::atan2(read(1, 0), read(0, 0)), 1.0, 1e-6) << "the heading is left alone";
}

TEST_P(HungSensorsTest, SameSeedSameNoise) {
  SensorOptions options;
  options.encoder.noise = 1e-3;
  Sensors one(model, options), two(model, options);
  options.seed = 2;
  Sensors other(model, options);
  RobotState a, b, c;
  for (int i = 0; i < 10; ++i) {
    one.measure(world, 0.002, a);
    two.measure(world, 0.002, b);
    other.measure(world, 0.002, c);
    EXPECT_EQ(a.q[0], b.q[0]);
    EXPECT_NE(a.q[0], c.q[0]);
  }
}

TEST_P(HungSensorsTest, DelayHandsOutThePast) {
  SensorOptions options;
  options.delay_ticks = 3;
  Sensors sensors(model, options);
  RobotState state;
  for (int i = 0; i < 20; ++i) {
    Configuration at(model);
    at.q[0] = 0.01 * i;
    ASSERT_EQ(world.set(at), Status::kOk);
    sensors.measure(world, 0.002, state);
    EXPECT_NEAR(state.q[0], 0.01 * std::max(0, i - 3), 1e-12);
  }
}

}  // namespace
}  // namespace twinbus
