#include "control/legs/static_torque.h"

#include <gtest/gtest.h>

#include <random>

#include "control/legs/point_load_share.h"
#include "test/control/hrp1s.h"
#include "test/rounds.h"

namespace twinbus {
namespace {

RobotState standing(const Model& model, double foot_force) {
  RobotState state;
  state.run_id = 1;
  state.joint_count = static_cast<std::int16_t>(model.bus_count());
  state.attitude = {1.0F, 0.0F, 0.0F, 0.0F};
  const auto& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))].q;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
    state.q[k] = pose[static_cast<std::size_t>(model.bus_joints[k])];
  }
  for (int foot : {kLeftFoot, kRightFoot}) {
    state.wrench_kind[static_cast<std::size_t>(foot)] = WrenchKind::kMeasured;
    state.wrench[static_cast<std::size_t>(foot)][2] = static_cast<float>(foot_force);
  }
  state.sensor_flags = -1;
  return state;
}

TEST(StaticTorque, TheTorqueOfAJointIsTheSlopeOfThePotentialEnergyWhenTheRobotHangs) {
  const Model& model = test::hrp1s();
  Estimator estimator(model);
  estimator.update(standing(model, 0.0));
  StaticTorque torque(model);
  Eigen::VectorXd tau(model.joint_count());
  const Eigen::VectorXd q = estimator.configuration().q;
  torque.solve(estimator, q, tau);
  Kinematics kinematics(model);
  Configuration c = estimator.configuration();
  const auto energy = [&](int j, double h) {
    c.q = q;
    c.q[j] += h;
    kinematics.update(c);
    return model.total_mass() * kGravity * kinematics.com().z();
  };
  for (int j = 0; j < model.joint_count(); ++j) {
    EXPECT_NEAR(tau[j], (energy(j, 1e-5) - energy(j, -1e-5)) / 2e-5, 1e-3) << j;
  }
}

TEST(StaticTorque, StandingTheLegsCarryTheBodyAndTheArmsOnlyThemselves) {
  const Model& model = test::hrp1s();
  Estimator hangs(model), stands(model);
  hangs.update(standing(model, 0.0));
  stands.update(standing(model, 0.5 * model.total_mass() * kGravity));
  ASSERT_TRUE(stands.loaded(0) && stands.loaded(1));
  ASSERT_FALSE(hangs.loaded(0) || hangs.loaded(1));
  StaticTorque torque(model);
  Eigen::VectorXd in_air(model.joint_count()), on_ground(model.joint_count());
  const Eigen::VectorXd q = stands.configuration().q;
  torque.solve(hangs, q, in_air);
  torque.solve(stands, q, on_ground);
  double legs = 0.0;
  for (int j : model.leg_joints) legs = std::max(legs, std::abs(on_ground[j] - in_air[j]));
  EXPECT_GT(legs, 50.0) << "bent knees under 130 kg";
  for (int j : model.hands[0].joints) EXPECT_NEAR(on_ground[j], in_air[j], 1e-6);
}

PointLoads loads_at(std::initializer_list<Eigen::Vector2d> places) {
  PointLoads loads;
  for (const Eigen::Vector2d& place : places) loads.away[static_cast<std::size_t>(loads.count++)] = place;
  share_load_on_points(loads);
  return loads;
}

Eigen::Vector2d moment(const PointLoads& loads) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(loads.count); ++i) sum += loads.share[i] * loads.away[i];
  return sum;
}

TEST(PointLoadShare, FourFeetRoundTheCentreOfMassCarryAlike) {
  const PointLoads loads = loads_at({{0.2, 0.1}, {0.2, -0.1}, {-0.2, 0.1}, {-0.2, -0.1}});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(loads.share[i], 0.25, 1e-5);
}

TEST(PointLoadShare, ThreeFeetCarryWhatStaticsSays) {
  const PointLoads loads = loads_at({{0.3, 0.0}, {-0.1, 0.2}, {-0.1, -0.2}});
  EXPECT_NEAR(loads.share[0], 0.25, 1e-4);
  EXPECT_NEAR(loads.share[1], 0.375, 1e-4);
  EXPECT_NEAR(loads.share[2], 0.375, 1e-4);
}

// The centre of mass over the triangle of three: the fourth one would have to pull.
TEST(PointLoadShare, NoFootPulls) {
  const PointLoads loads = loads_at({{0.02, 0.01}, {0.4, -0.3}, {-0.4, 0.3}, {1.0, 0.9}});
  EXPECT_EQ(loads.share[3], 0.0);
  EXPECT_LT(moment(loads).norm(), 1e-2);
}

TEST(PointLoadShare, OutsideTheFeetTheNearestCarryAllOfIt) {
  const PointLoads loads = loads_at({{0.1, 0.1}, {0.1, -0.1}, {0.5, 0.1}, {0.5, -0.1}});
  EXPECT_NEAR(loads.share[0], 0.5, 0.05);
  EXPECT_NEAR(loads.share[1], 0.5, 0.05);
  EXPECT_NEAR(loads.share[0] + loads.share[1] + loads.share[2] + loads.share[3], 1.0, 1e-12);
  EXPECT_NEAR(loads_at({{0.3, 0.2}}).share[0], 1.0, 1e-12);
  EXPECT_EQ(loads_at({}).share[0], 0.0);
}

// Among all that balance, no other shares are smaller: they differ by what neither weighs nor turns, and that only adds.
TEST(PointLoadShare, SixFeetBalanceWithTheLeastForces) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> within(-0.03, 0.03);
  for (int round = 0; round < test::rounds(200); ++round) {
    const auto about = [&](double x, double y) { return Eigen::Vector2d(x + within(random), y + within(random)); };
    const PointLoads loads =
        loads_at({about(0.3, 0.2), about(0.3, -0.2), about(0.0, 0.25), about(0.0, -0.25), about(-0.3, 0.2), about(-0.3, -0.2)});
    double sum = 0.0;
    Eigen::Matrix<double, 3, 6> map;
    Eigen::Matrix<double, 6, 1> share;
    for (int i = 0; i < 6; ++i) {
      const auto k = static_cast<std::size_t>(i);
      sum += loads.share[k];
      share[i] = loads.share[k];
      map.col(i) << 1.0, loads.away[k];
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_LT(moment(loads).norm(), 1e-4);
    const Eigen::Matrix<double, 6, 1> least = map.transpose() * (map * map.transpose()).inverse() * Eigen::Vector3d::UnitX();
    EXPECT_LT((share - least).norm(), 1e-3);
  }
}

}  // namespace
}  // namespace twinbus
