// How far the estimate of the base is from the truth while the robot sways, squats and is pushed, with noise and delay in
// every sensor.

#include <gtest/gtest.h>

#include "robot/estimation/estimator.h"
#include "robot/description/load.h"
#include "common/math/pose_math.h"
#include "test/control/sensor_noise.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

const Settings kNoisyAndLate = test::noisy({"5e-5", "0.005", "5e-4", "0.003", "3", "0.2"},
                                           {{"sensor.delay_ms", "2"}, {"sensor.imu_yaw_drift", "0.01"}});

struct Errors {
  double position = 0.0;  // root of the mean square [m]
  double velocity = 0.0;  // [m/s]
  double tilt = 0.0;      // [rad]
};

Eigen::Isometry3d base_of(const SimTruth& truth) {
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.linear() = quaternion_from_array(truth.base_attitude).toRotationMatrix();
  base.translation() << truth.base_position[0], truth.base_position[1], truth.base_position[2];
  return base;
}

// The frame in which the estimator begins: midway between the soles, with their heading.
Eigen::Isometry3d ground_of(const SimTruth& truth) {
  Eigen::Isometry3d ground = Eigen::Isometry3d::Identity();
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double yaw = 0.0;
  for (std::size_t s = 0; s < 2; ++s) {
    const Eigen::Matrix3d sole = quaternion_from_array(truth.foot_attitude[s]).toRotationMatrix();
    middle += 0.5 * Eigen::Vector2d(static_cast<double>(truth.foot_position[s][0]),
                                    static_cast<double>(truth.foot_position[s][1]));
    yaw += 0.5 * yaw_of(sole);
  }
  ground.linear() = rotation_z(yaw);
  ground.translation() << middle, 0.0;
  return ground;
}

Errors follow(const Scene& scene, Motion motion, double amplitude, double seconds) {
  static const Model model = load_robot("hrp1s");
  ControlConfig config;
  config.guard_in_loop = false;
  SimRig rig(model, scene, kNoisyAndLate, config);
  EXPECT_TRUE(rig.run(1.0));
  Estimator estimator(model);
  const Eigen::Isometry3d ground = ground_of(rig.truth());
  if (motion != Motion::kNone) rig.ask(Mode::kBalance, motion, amplitude, 0.4);
  Errors sum;
  const int ticks = static_cast<int>(std::lround(seconds / model.period()));
  for (int i = 0; i < ticks; ++i) {
    const SimTruth truth = rig.truth();  // of the state that the next tick reads
    EXPECT_TRUE(rig.tick());
    estimator.update(rig.state());
    const Eigen::Isometry3d base = ground.inverse() * base_of(truth);
    const Eigen::Vector3d velocity =
        ground.linear().transpose() *
        Eigen::Vector3d(truth.base_velocity[0], truth.base_velocity[1], truth.base_velocity[2]);
    const Configuration& found = estimator.configuration();
    sum.position += (found.base.translation() - base.translation()).squaredNorm() / ticks;
    sum.velocity += (found.base_velocity - velocity).squaredNorm() / ticks;
    const Eigen::Vector3d up = found.base.linear().transpose() * Eigen::Vector3d::UnitZ();
    sum.tilt += up.cross(Eigen::Vector3d(base.linear().transpose() * Eigen::Vector3d::UnitZ()))
                    .squaredNorm() /
                ticks;
  }
  EXPECT_FALSE(rig.record().fell);
  return {std::sqrt(sum.position), std::sqrt(sum.velocity), std::sqrt(sum.tilt)};
}

void is_near_the_truth(const char* name, const Errors& errors) {
  std::printf("%s: base position rms %.2f mm, velocity rms %.1f mm/s, tilt rms %.3f degrees\n",
              name, 1e3 * errors.position, 1e3 * errors.velocity, 57.29577951308232 * errors.tilt);
  EXPECT_LE(errors.position, 0.003) << name;
  EXPECT_LE(errors.velocity, 0.020) << name;
  EXPECT_LE(errors.tilt, 0.3 / 57.29577951308232) << name;
}

TEST(EstimatorTruth, Sway) { is_near_the_truth("sway", follow({}, Motion::kSway, 0.03, 8.0)); }
TEST(EstimatorTruth, Squat) { is_near_the_truth("squat", follow({}, Motion::kSquat, 0.05, 8.0)); }
TEST(EstimatorTruth, Pushes) {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d impulse(i == 0 ? 20.0 : 0.0, i == 1 ? 20.0 : i == 2 ? -20.0 : 0.0, 0.0);
    scene.pushes.push_back({.link = "CHEST",
                            .point = {0, 0, 0},
                            .impulse = impulse,
                            .at = 2.0 + 2.5 * i,
                            .duration = 0.1});
  }
  is_near_the_truth("pushes", follow(scene, Motion::kNone, 0.0, 8.0));
}

}  // namespace
}  // namespace twinbus
