#include "launcher/figures/swing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "test/sim/both_engines.h"
#include "common/math/index.h"
#include "robot/description/load.h"
#include "sim/world/static_equilibrium.h"

namespace twinbus {
namespace {

std::vector<double> damped(double period, double decay, double offset, double phase) {
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) {
    const double t = 0.002 * i;
    values.push_back(offset +
                     5.0 * std::exp(-decay * t) * std::cos(2.0 * M_PI / period * t + phase));
  }
  return values;
}

TEST(SwingSeen, FindsPeriodAndDecayWhateverTheOffset) {
  for (const double phase : {0.0, 1.0, 2.5}) {
    const auto seen = swing_seen(damped(0.5, 1.2, 20.0, phase), 0.002);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->period, 0.5, 1e-4);
    EXPECT_NEAR(seen->decay, 1.2, 5e-3);
  }
}

TEST(SwingSeen, SaysNoneWhereNothingSwings) {
  EXPECT_FALSE(swing_seen({}, 0.002));
  EXPECT_FALSE(swing_seen(std::vector<double>(500, 3.0), 0.002));
  EXPECT_FALSE(swing_seen(damped(1e9, 5.0, 1.0, 0.0), 0.002));  // creeps back
}

// The robot pushed at the chest, its servos holding, and let go; no controller.
class SwingTest : public test::BothEngines {
 protected:
  SwingTest() : model(load_robot("hrp1s")) {
    const std::vector<double>& pose = model.poses[at(model.find_pose("half_sitting"))].q;
    q = Eigen::Map<const Eigen::VectorXd>(pose.data(), model.joint_count());
    push = {
        .link = model.find_link("CHEST"), .point = Eigen::Vector3d::Zero(), .force = {30, 0, 0}};
    joint = model.find_joint("LLEG_ANKLE_P");
  }

  std::optional<Swing> run(WorldConfig config) const {
    const auto world = make(model, config);
    const Standing standing = stand(
        model, q, 1.0, {world->corner_stiffness(0), world->corner_stiffness(1)}, {0.0, 0.0}, false);
    if (world->set(standing.configuration) != Status::kOk) return std::nullopt;
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& of = model.joints[at(j)];
      (void)world->set_servo(
          j, {.q = q[j], .qd = 0.0, .tau = standing.tau[j], .kp = of.kp, .kd = of.kd});
    }
    std::vector<double> values;
    const auto steps = std::lround(3.5 / config.step), pushed = std::lround(0.4 / config.step);
    for (long i = 0; i < steps; ++i) {
      if (i < pushed)
        (void)world->push(push.link, world->link_in_world(push.link) * push.point, push.force);
      if (world->step() != Status::kOk) return std::nullopt;
      if (i >= pushed) values.push_back(world->tau(joint));
    }
    return swing_seen(values, config.step);
  }

  Model model;
  Eigen::VectorXd q;
  SteadyPush push;
  int joint = -1;
};
TWINBUS_FOR_BOTH_ENGINES(SwingTest);

TEST_P(SwingTest, AStandingRobotSwingsAsItsLinearModel) {
  WorldConfig config;
  config.step = is_ode() ? 1e-3 : 2.5e-4;
  for (const double soft : {1.0, 0.3}) {  // of the servos
    config.servo_kp_scale = soft;
    const auto expected = swing_of(model, config, q, push, joint);
    const auto seen = run(config);
    ASSERT_TRUE(expected && seen);
    EXPECT_NEAR(seen->period, expected->period, 0.01 * expected->period);
    EXPECT_NEAR(seen->decay, expected->decay, (is_ode() ? 0.10 : 0.05) * expected->decay);
    if (is_ode()) break;  // half a second each
  }
}

TEST(SwingOf, SaysNoneWhereTheRobotDoesNotStand) {
  Model model = load_robot("hrp1s");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.joint_count());
  q[model.find_joint("LLEG_HIP_P")] = q[model.find_joint("RLEG_HIP_P")] = -1.2;
  EXPECT_FALSE(swing_of(model, {}, q, {.link = 0, .force = {1, 0, 0}}, 0));
}

}  // namespace
}  // namespace twinbus
