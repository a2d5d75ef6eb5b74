#include "robot/estimation/estimator.h"

#include "fixtures.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/inverse_kinematics.h"
#include "robot/estimation/sole_contact.h"
#include "common/allocation/no_alloc.h"

namespace twinbus::test {
namespace {

// A robot that stands on two soles at given poses while its base moves; legs by inverse kinematics.
class Stand {
 public:
  Stand() : model_(hrp1s()), kinematics_(model_), truth(model_) {
    const auto& q = model_.poses[static_cast<std::size_t>(model_.find_pose("half_sitting"))].q;
    truth.q = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
    for (int foot = 0; foot < 2; ++foot) {
      legs_.emplace_back(model_, 0, model_.soles[static_cast<std::size_t>(foot)].link,
                         model_.soles[static_cast<std::size_t>(foot)].frame);
    }
    const double press = 0.5 * 130.8 * kGravity / model_.soles[0].stiffness;
    height = -press - legs_[0].pose(truth.q).translation().z();
    for (int foot = 0; foot < 2; ++foot) {
      sole[foot].setIdentity();
      sole[foot].translation() << 0.0, foot == 0 ? 0.09 : -0.09, -press;
    }
  }

  // Base at x, y (and turned by rpy) above the soles' middle; joints follow.
  void place(const Eigen::Vector3d& position, const Eigen::Vector3d& rpy) {
    truth.base.translation() = position + Eigen::Vector3d(0, 0, height);
    truth.base.linear() = rotation_from_rpy(rpy.x(), rpy.y(), rpy.z());
    for (int foot = 0; foot < 2; ++foot) {
      const IkResult result = legs_[static_cast<std::size_t>(foot)].solve(
          truth.base.inverse() * sole[foot],
          {.position_tolerance = 1e-11, .rotation_tolerance = 1e-11}, truth.q);
      ASSERT_LT(result.position_error, 1e-9);
    }
  }

  // Placed there, upright and standing on both feet, and seen once.
  Estimator estimated(const Eigen::Vector3d& position) {
    place(position, {0, 0, 0});
    Estimator estimator(model_);
    estimator.update(state(0.0, kHalf, kHalf));
    return estimator;
  }

  // What the robot measures; the IMU believes in a heading of its own.  force: normal, of each foot
  // [N].
  RobotState state(double imu_yaw, double force_left, double force_right) {
    kinematics_.update(truth);
    RobotState s;
    s.run_id = 5;
    s.joint_count = static_cast<std::int16_t>(model_.bus_count());
    s.sensor_flags =
        kEncodersValid | kImuValid | wrench_valid(kLeftFoot) | wrench_valid(kRightFoot);
    for (std::size_t k = 0; k < model_.bus_joints.size(); ++k) {
      s.q[k] = truth.q[model_.bus_joints[k]];
      s.qd[k] = static_cast<float>(truth.qd[model_.bus_joints[k]]);
    }
    const Eigen::Isometry3d imu = kinematics_.link_in_world(model_.imu_link) * model_.imu;
    s.attitude = array_from_rotation<float>(rotation_z(imu_yaw) * imu.linear());
    s.gyro = array_from_vector<float>(imu.linear().transpose() *
                                      kinematics_.angular_velocity(model_.imu_link));
    const double forces[2] = {force_left, force_right};
    for (std::size_t foot = 0; foot < 2; ++foot) {
      s.wrench_kind[foot] = WrenchKind::kMeasured;
      const Sole& sole_of = model_.soles[foot];
      const Eigen::Isometry3d sensor = kinematics_.link_in_world(sole_of.link) * sole_of.sensor;
      const Eigen::Vector3d force =
          sensor.linear().transpose() * Eigen::Vector3d(3.0, -2.0, forces[foot]);
      for (std::size_t i = 0; i < 3; ++i)
        s.wrench[foot][i] = static_cast<float>(force[static_cast<Eigen::Index>(i)]);
    }
    return s;
  }

  const Model& model_;
  std::vector<InverseKinematics> legs_;
  Kinematics kinematics_;
  Configuration truth;
  Eigen::Isometry3d sole[2];
  double height = 0.0;
  static constexpr double kHalf = 0.5 * 130.8 * kGravity;
};

TEST(Estimator, StartsMidwayBetweenTheSolesWithHeadingZero) {
  Stand stand;
  stand.place({0.02, 0.01, -0.01}, {0.01, -0.02, 0.0});
  Estimator estimator(stand.model_);
  estimator.update(stand.state(1.7, Stand::kHalf, Stand::kHalf));
  EXPECT_LT((estimator.configuration().base.translation() - stand.truth.base.translation()).norm(),
            1e-5);
  EXPECT_LT(rotation_vector(estimator.configuration().base.linear() *
                            stand.truth.base.linear().transpose())
                .norm(),
            1e-6);
  EXPECT_TRUE(estimator.ground_in_world().isApprox(Eigen::Isometry3d::Identity(), 1e-6));
  EXPECT_TRUE(estimator.loaded(0) && estimator.loaded(1));
}

// Pressed into the ground by its share of the weight each sole sits deeper, so the base does too.
TEST(Estimator, HeightKnowsHowDeepTheSolesArePressed) {
  Stand stand;
  stand.place({0, 0, 0}, {0, 0, 0});
  Estimator estimator(stand.model_);
  estimator.update(stand.state(0.0, Stand::kHalf, Stand::kHalf));
  EXPECT_NEAR(estimator.configuration().base.translation().z(), stand.truth.base.translation().z(),
              1e-7);
  EXPECT_NEAR(estimator.sole_in_world(0).translation().z(), -Stand::kHalf / 1e6, 1e-7);
}

TEST(Estimator, SwayIsFollowedAndSolesStandStill) {
  Stand stand;
  Estimator estimator(stand.model_);
  for (int i = 0; i < 500; ++i) {
    const double t = 0.002 * i;
    const Eigen::Matrix3d before = stand.truth.base.linear();
    stand.place({0.03 * std::sin(3 * t), 0.04 * std::sin(5 * t), 0.02 * std::sin(2 * t) - 0.03},
                {0.02 * std::sin(4 * t), 0.03 * std::sin(3 * t), 0.05 * std::sin(2 * t)});
    // The gyro has felt the turn that the attitude made.
    stand.truth.base_angular_velocity =
        rotation_vector(stand.truth.base.linear() * before.transpose()) / 0.002;
    estimator.update(stand.state(0.4, Stand::kHalf, Stand::kHalf));
    ASSERT_LT(
        (estimator.configuration().base.translation() - stand.truth.base.translation()).norm(),
        2e-6)
        << i;
    ASSERT_LT(rotation_vector(estimator.configuration().base.linear() *
                              stand.truth.base.linear().transpose())
                  .norm(),
              2e-6);
    ASSERT_LT((estimator.sole_in_world(1).translation() - stand.sole[1].translation()).norm(),
              2e-6);
  }
}

TEST(Estimator, ADriftingImuTurnsNeitherFeetNorBase) {
  Stand stand;
  stand.place({0.01, 0, 0}, {0.01, 0.02, 0.1});
  Estimator estimator(stand.model_);
  for (int i = 0; i < 5000; ++i) {
    RobotState state = stand.state(3e-3 * 0.002 * i, Stand::kHalf, Stand::kHalf);
    state.gyro[2] += 3e-3f;
    estimator.update(state);
  }
  EXPECT_LT(rotation_vector(estimator.configuration().base.linear() *
                            stand.truth.base.linear().transpose())
                .norm(),
            1e-6);
  EXPECT_LT((estimator.sole_in_world(0).translation() - stand.sole[0].translation()).norm(), 1e-6);
  // What is left of the gyro's error is its share about the horizontal axes of a leaning robot.
  EXPECT_LT(estimator.configuration().base_angular_velocity.norm(), 1e-4);
  EXPECT_LT(estimator.configuration().base_velocity.norm(), 1e-4);
}

TEST(Estimator, VelocityIsTheDerivativeOfThePosition) {
  Stand stand;
  const auto place = [&](double t) {
    stand.place({0.03 * std::sin(3 * t), 0.04 * std::sin(5 * t), 0.02 * std::sin(2 * t) - 0.03},
                {0.02 * std::sin(4 * t), 0.03 * std::sin(3 * t), 0.05 * std::sin(2 * t)});
  };
  constexpr double h = 1e-4;
  const double t = 0.3;
  place(t - h);
  const Configuration before = stand.truth;
  place(t + h);
  const Configuration after = stand.truth;
  place(t);
  stand.truth.qd = (after.q - before.q) / (2 * h);
  stand.truth.base_velocity = (after.base.translation() - before.base.translation()) / (2 * h);
  stand.truth.base_angular_velocity =
      rotation_vector(after.base.linear() * before.base.linear().transpose()) / (2 * h);
  Estimator estimator(stand.model_);
  estimator.update(stand.state(0.0, Stand::kHalf, Stand::kHalf));
  // The estimate starts with the heading of the feet, which is the true one here.
  EXPECT_LT((estimator.configuration().base_velocity - stand.truth.base_velocity).norm(), 1e-4);
  EXPECT_LT(
      (estimator.configuration().base_angular_velocity - stand.truth.base_angular_velocity).norm(),
      1e-4);
  EXPECT_LT((estimator.kinematics().com_velocity()).norm() - 0.3, 0.0);
}

TEST(Estimator, ASwitchKeepsTheGroundFrame) {
  Stand stand;
  Estimator estimator = stand.estimated({0.02, 0, 0});
  // Walk the estimate away from the origin: a foot is lifted and set down elsewhere.
  stand.sole[0].translation() += Eigen::Vector3d(0.1, 0.02, 0.0);
  for (int i = 0; i <= 50; ++i) {
    Eigen::Isometry3d goal = stand.sole[0];
    stand.sole[0].translation() -= (1.0 - i / 50.0) * Eigen::Vector3d(0.1, 0.02, 0.0);
    stand.sole[0].translation().z() = i == 50 ? stand.sole[1].translation().z() : 0.03;
    const bool down = i == 50;
    stand.place({0.02, 0.0, 0.0}, {0, 0, 0});
    estimator.update(
        stand.state(0.0, down ? Stand::kHalf : 0.0, down ? Stand::kHalf : 2 * Stand::kHalf));
    stand.sole[0] = goal;
  }
  const Eigen::Isometry3d ground = estimator.ground_in_world();
  EXPECT_NEAR(ground.translation().x(), 0.05, 1e-4);
  EXPECT_NEAR(ground.translation().y(), 0.01, 1e-4);

  RobotState other = stand.state(2.9, Stand::kHalf, Stand::kHalf);
  other.run_id = 6;
  const Eigen::Isometry3d base = estimator.configuration().base;
  estimator.update(other);
  EXPECT_TRUE(estimator.ground_in_world().isApprox(ground, 1e-6));
  EXPECT_LT((estimator.configuration().base.translation() - base.translation()).norm(), 1e-5);
  EXPECT_LT(
      rotation_vector(estimator.configuration().base.linear() * base.linear().transpose()).norm(),
      1e-5);
}

TEST(Estimator, ALiftedFootMovesFreely) {
  Stand stand;
  Estimator estimator = stand.estimated({0, 0, 0});
  stand.sole[0].translation() += Eigen::Vector3d(0.05, 0.01, 0.04);
  stand.place({0, -0.02, 0}, {0, 0, 0});
  stand.truth.base.translation().z() -= Stand::kHalf / 1e6;  // the other sole carries all
  estimator.update(stand.state(0, 0.0, 2 * Stand::kHalf));
  EXPECT_FALSE(estimator.loaded(0));
  EXPECT_LT((estimator.configuration().base.translation() - stand.truth.base.translation()).norm(),
            1e-5);
  const Eigen::Vector3d com(0, -0.09, 0);
  EXPECT_NEAR(estimator.support_margin(com), 0.07, 1e-4);
}

TEST(Estimator, OneReadingOfAForceIsNoLoad) {
  Stand stand;
  stand.place({0, 0, 0}, {0, 0, 0});
  Estimator estimator(stand.model_);
  estimator.update(stand.state(0, 0.0, 2 * Stand::kHalf));
  EXPECT_FALSE(estimator.loaded(0));
  estimator.update(stand.state(0, 100.0, 2 * Stand::kHalf));
  EXPECT_FALSE(estimator.loaded(0));
  estimator.update(stand.state(0, 0.0, 2 * Stand::kHalf));
  estimator.update(stand.state(0, 100.0, 2 * Stand::kHalf));
  EXPECT_FALSE(estimator.loaded(0));
  estimator.update(stand.state(0, 100.0, 2 * Stand::kHalf));
  EXPECT_TRUE(estimator.loaded(0));
}

// White noise of the IMU's attitude and of the joints' rates: the gyro and the ZMP know better.
TEST(Estimator, NoiseOfAttitudeAndRatesIsHeardQuietly) {
  Stand stand;
  stand.place({0, 0, 0}, {0, 0, 0});
  Estimator estimator(stand.model_);
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const RobotState quiet = stand.state(0, Stand::kHalf, Stand::kHalf);
  const Eigen::Matrix3d read = quaternion_from_array(quiet.attitude).toRotationMatrix();
  double tilt = 0.0;
  Eigen::Array2d sum = Eigen::Array2d::Zero(), squares = sum, of_joints = sum;
  for (int i = 0; i < 2000; ++i) {
    RobotState state = quiet;
    state.time_ns = std::int64_t{2'000'000} * i;
    const Eigen::Vector3d turn(0.006 * normal(random), 0.006 * normal(random), 0.0);
    state.attitude = array_from_rotation<float>(read * rotation_of(turn));
    for (auto& qd : state.qd) qd = static_cast<float>(0.03 * normal(random));
    estimator.update(state);
    if (i < 500) continue;
    tilt += rotation_vector(estimator.configuration().base.linear() *
                            stand.truth.base.linear().transpose())
                .head<2>()
                .squaredNorm();
    of_joints += estimator.kinematics().com_velocity().head<2>().array().square();
    sum += estimator.dcm_velocity().array();
    squares += estimator.dcm_velocity().array().square();
  }
  EXPECT_LT(std::sqrt(tilt / 3000.0), 0.0015);
  const Eigen::Array2d spread = (squares / 1500.0 - (sum / 1500.0).square()).sqrt();
  EXPECT_LT(spread.maxCoeff(), 0.5 * (of_joints / 1500.0).sqrt().minCoeff());
}

TEST(Estimator, ZmpIsWhereTheForcesBalance) {
  Stand stand;
  stand.place({0, 0, 0}, {0, 0, 0});
  Estimator estimator(stand.model_);
  RobotState state = stand.state(0, 1000, 500);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    state.wrench[foot][0] = state.wrench[foot][1] = 0;
    state.wrench[foot][4] =
        foot == 0 ? -20.0f : -10.0f;  // forces act 0.02 m ahead of the soles' frames
  }
  estimator.update(state);
  EXPECT_NEAR(estimator.zmp().x(), 0.02, 1e-5);
  EXPECT_NEAR(estimator.zmp().y(), 0.09 / 3.0, 1e-5);
  EXPECT_EQ(estimator.zmp().z(), 0.0);
}

TEST(Estimator, StandsWithoutForceSensorsToo) {
  Stand stand;
  stand.place({0.01, 0, 0}, {0, 0.02, 0});
  Estimator estimator(stand.model_);
  RobotState state = stand.state(0.3, 0, 0);
  state.wrench_kind = {};
  estimator.update(state);
  EXPECT_LT((estimator.configuration().base.translation() - stand.truth.base.translation()).norm(),
            1e-4);
}

TEST(Estimator, HangingInTheAirIsFinite) {
  Stand stand;
  stand.place({0, 0, 0}, {0, 0, 0});
  Estimator estimator(stand.model_);
  for (int i = 0; i < 10; ++i) estimator.update(stand.state(0.1 * i, 0.0, 0.0));
  EXPECT_TRUE(estimator.configuration().base.matrix().allFinite());
  EXPECT_EQ(estimator.support_margin(Eigen::Vector3d::Zero()), -1.0);
  EXPECT_NEAR(yaw_of(estimator.configuration().base.linear()), 0.9,
              1e-5);  // nothing else knows the heading
}

TEST(Estimator, UpdateDoesNotAllocate) {
  Stand stand;
  stand.place({0, 0, 0}, {0, 0, 0});
  const RobotState state = stand.state(0, Stand::kHalf, Stand::kHalf);
  Estimator estimator(stand.model_);
  NoAlloc no_alloc;
  estimator.update(state);
  estimator.update(state);
  EXPECT_GT(estimator.support_margin(Eigen::Vector3d(0.05, 0, 0)), 0.0);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus::test
