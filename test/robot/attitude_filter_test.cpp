#include "robot/estimation/attitude_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robot/dynamics/inverse_dynamics.h"
#include "common/math/pose_math.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

constexpr double kTick = 0.002;  // [s]

// Angle between what is up and what the filter takes for up [rad].
double lean(const AttitudeFilter& filter, const Eigen::Matrix3d& truth) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  return (filter.rotation().transpose() * up - truth.transpose() * up).norm();
}

TEST(AttitudeFilter, TheFirstLookAtTheAccelerometerSaysWhatIsUp) {
  const Eigen::Matrix3d truth = rotation_from_rpy(0.2, -0.1, 0.0);
  AttitudeFilter filter;
  filter.update(Eigen::Vector3d::Zero(), truth.transpose() * Eigen::Vector3d(0, 0, kGravity),
                Eigen::Vector3d::Zero(), true, kTick);
  EXPECT_LT(lean(filter, truth), 1e-9);
  EXPECT_NEAR(yaw_of(filter.rotation()), 0.0, 1e-12);
}

// Legs and accelerometer as noisy as in the harshest row of the robustness table.
TEST(AttitudeFilter, ARobotAtRestIsFoundWithinTheFirstLooksHoweverNoisy) {
  const Eigen::Matrix3d truth = rotation_from_rpy(0.05, -0.03, 0.0);
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto noise = [&](double size) {
      return Eigen::Vector3d(size * normal(random), size * normal(random), size * normal(random));
    };
    AttitudeFilter filter;
    for (int i = 0; i < 150; ++i) {
      filter.update(noise(0.03), truth.transpose() * Eigen::Vector3d(0, 0, kGravity) + noise(0.15),
                    noise(0.04), true, kTick);
    }
    EXPECT_LT(lean(filter, truth), 6e-3) << "seed " << seed;
  }
}

TEST(AttitudeFilter, FindsTheBiasOfTheGyro) {
  const Eigen::Vector3d bias(0.02, -0.01, 0.0);
  AttitudeFilter filter;
  for (int i = 0; i < 40'000; ++i) {
    filter.update(bias, Eigen::Vector3d(0, 0, kGravity), Eigen::Vector3d::Zero(), true, kTick);
  }
  EXPECT_LT((filter.bias() - bias).head<2>().norm(), 1e-3);
  EXPECT_LT(lean(filter, Eigen::Matrix3d::Identity()), 1e-3);
}

// 1 m/s^2 back and forth: 0.1 rad to who takes it for gravity.
TEST(AttitudeFilter, AnAccelerationThatTheLegsKnowIsNoTilt) {
  constexpr double kOmega = 5.0;
  const auto worst = [](bool told) {
    AttitudeFilter filter;
    double most = 0.0;
    for (int i = 0; i < 10'000; ++i) {
      const double t = kTick * i;
      const Eigen::Vector3d velocity(std::sin(kOmega * t) / kOmega, 0.0, 0.0);
      filter.update(Eigen::Vector3d::Zero(), {std::cos(kOmega * t), 0.0, kGravity},
                    told ? velocity : Eigen::Vector3d::Zero(), true, kTick);
      if (i > 2000) most = std::max(most, lean(filter, Eigen::Matrix3d::Identity()));
    }
    return most;
  };
  EXPECT_LT(worst(true), 2e-3);
  EXPECT_GT(worst(false), 5e-3);
}

TEST(AttitudeFilter, FollowsTurnsWithoutAllocating) {
  AttitudeFilter filter;
  Eigen::Matrix3d truth = Eigen::Matrix3d::Identity();
  NoAlloc guard;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d rate(0.5 * std::cos(0.004 * i), 0.3 * std::sin(0.006 * i), 0.2);
    truth = truth * rotation_of(kTick * rate);
    filter.update(rate, truth.transpose() * Eigen::Vector3d(0, 0, kGravity),
                  Eigen::Vector3d::Zero(), true, kTick);
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_LT(lean(filter, truth), 4e-3);
}

}  // namespace
}  // namespace twinbus::test
