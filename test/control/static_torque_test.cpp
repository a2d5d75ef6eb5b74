#include "control/legs/static_torque.h"

#include <gtest/gtest.h>

#include "test/control/hrp1s.h"

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

}  // namespace
}  // namespace twinbus
