// The torque limit of joints that two motors turn over rods, where commands are made and where they are let through.

#include "robot/dynamics/pair_torque.h"

#include <gtest/gtest.h>

#include "bridge/gate/command_gate.h"
#include "bridge/gate/command_in_force.h"
#include "common/allocation/no_alloc.h"
#include "control/loop/set_point_limits.h"
#include "control/walk/footsteps.h"
#include "robot/dynamics/pair_speed.h"
#include "robot/kinematics/kinematics.h"
#include "test/parallel/parallel_biped.h"

namespace twinbus::test {
namespace {

using Eigen::Vector2d;

class PairTorqueTest : public ::testing::Test {
 protected:
  PairTorqueTest() : model(parallel_biped()), pair(parallel_joints_of(model).front()), torque(model), standing(model, "half_sitting") {
    EXPECT_TRUE(pair.drive.at(pair.of(standing.q), posture));
    for (std::size_t i = 0; i < 2; ++i) bus[i] = static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(pair.joints[i])]);
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) state.q[k] = standing.q[model.bus_joints[k]];
    state.joint_count = static_cast<std::int16_t>(model.bus_count());
  }
  const Joint& joint(std::size_t i) const { return model.joints[static_cast<std::size_t>(pair.joints[i])]; }
  // The larger motor torque of the pair over its limit.
  template <class Array>
  double share(const Array& tau) const {
    const Vector2d motors = posture.jacobian.transpose().inverse() * Vector2d(static_cast<double>(tau[bus[0]]), static_cast<double>(tau[bus[1]]));
    return (motors.array() / pair.drive.torque_limits().array()).abs().maxCoeff();
  }

  const Model& model;
  ParallelJoints pair;
  PairTorque torque;
  Configuration standing;
  RodPosture posture;
  std::array<std::size_t, 2> bus{};
  RobotState state;
};

TEST_F(PairTorqueTest, AShareIsThatOfTheBusierMotor) {
  Eigen::VectorXd tau = Eigen::VectorXd::Zero(model.joint_count());
  const Vector2d motors(45.0, -9.0);
  const Vector2d joints = posture.jacobian.transpose() * motors;
  tau[pair.joints[0]] = joints[0];
  tau[pair.joints[1]] = joints[1];
  EXPECT_NEAR(torque.share(pair.joints[0], standing.q, tau), 0.5, 1e-12);
  EXPECT_NEAR(torque.share(pair.joints[1], standing.q, tau), 0.5, 1e-12);
  const int knee = model.find_joint("RLEG_KNEE");
  tau[knee] = 50.0;
  EXPECT_NEAR(torque.share(knee, standing.q, tau), 0.25, 1e-12);
  // Half of what each has alone, both at once.
  EXPECT_NEAR(torque.effort_in(pair.joints[0], standing.q), torque_box(pair.drive, posture)[0], 1e-12);
  EXPECT_LT(torque.effort_in(pair.joints[0], standing.q), 0.6 * joint(0).effort);
  EXPECT_EQ(torque.effort_in(knee, standing.q), model.joints[static_cast<std::size_t>(knee)].effort);
}

TEST_F(PairTorqueTest, TheGateLetsThroughWhatTheMotorsGive) {
  const GateLimits limits(model);
  CommandGate gate(limits, false, 1);
  gate.measured(state);
  gate.hold_measured(state);
  gate.open(42, 3, true, 0.0, 0);
  std::int64_t now = 0;
  JointCommand command;
  command.run_id = 42;
  command.term = 3;
  command.controller_id = 7;
  command.model_hash = model.hash;
  command.joint_count = state.joint_count;
  command.q = state.q;
  const auto offer = [&](double first, double second) {
    command.tau[bus[0]] = static_cast<float>(first);
    command.tau[bus[1]] = static_cast<float>(second);
    for (int i = 0; i < 30; ++i) {  // a torque may change by a tenth of the effort in a tick
      gate.measured(state);
      EXPECT_EQ(gate.accept(command, command.tick, false, now), GateVerdict::kAccepted);
      (void)gate.output(command.tick++, false, now);
      now += model.period_ns;
    }
    return share(gate.effective().tau);
  };
  const NoAlloc guard;
  EXPECT_NEAR(offer(0.95 * joint(0).effort, 0.95 * joint(1).effort), 1.0, 1e-4);
  EXPECT_EQ(guard.count(), 0);
  EXPECT_GT(gate.counters().clamped, 0);
  EXPECT_NEAR(offer(0.4 * joint(0).effort, 0.0), 0.4, 0.1);
  EXPECT_NEAR(static_cast<double>(gate.effective().tau[bus[0]]), 0.4 * joint(0).effort, 1e-3);
}

TEST_F(PairTorqueTest, ASetPointTurnsNoMotorFasterThanItsSpeed) {
  // Near the end of the range a motor is near its dead centre.
  const Vector2d from(pair.box.upper[0] - 0.05, pair.box.upper[1] - 0.05);
  Vector2d to = from + Vector2d(0.016, 0.016), qd(8.0, 8.0);
  const Vector2d asked = to;
  RodPosture before, after;
  EXPECT_TRUE(limit_speed(pair, from, 0.002, 1.0, to, qd));
  ASSERT_TRUE(pair.drive.at(from, before) && pair.drive.at(to, after));
  EXPECT_LE((after.motors - before.motors).cwiseAbs().maxCoeff(), 0.002 * 16.0 * 1.01);
  EXPECT_LE((after.jacobian * qd).cwiseAbs().maxCoeff(), 16.0 * 1.2);
  EXPECT_LT((to - from).norm(), (asked - from).norm());
  Vector2d near = from + Vector2d(1e-4, 1e-4), slow(0.1, 0.1);
  EXPECT_FALSE(limit_speed(pair, from, 0.002, 1.0, near, slow));
}

TEST_F(PairTorqueTest, ASourceThatTakesOverKnowsTheTorqueOfLimitedMotors) {
  const GateLimits limits(model);
  JointCommand command;
  command.joint_count = state.joint_count;
  command.q = state.q;
  command.tau[bus[0]] = static_cast<float>(0.9 * joint(0).effort);
  command.tau[bus[1]] = static_cast<float>(0.9 * joint(1).effort);
  state.tau = command.tau;
  torque.limit(state.q, state.tau);
  EXPECT_NEAR(share(state.tau), 1.0, 1e-6);
  JointCommand in_force;
  EXPECT_TRUE(find_command_in_force(state, command, command, limits, in_force));
  EXPECT_EQ(in_force.tau, command.tau);
}

TEST_F(PairTorqueTest, TheControllerAsksForNoMoreThanTheMotorsGive) {
  const SetPointLimits limits(model);
  SetPoint point;
  for (std::size_t k = 0; k < model.bus_joints.size(); ++k) point.q[k] = state.q[k];
  point.tau[bus[0]] = 0.9 * joint(0).effort;
  point.tau[bus[1]] = -0.9 * joint(1).effort;
  const double asked = share(point.tau);
  limits.apply(state, nullptr, 0.002, point);
  EXPECT_GT(asked, 1.2);
  EXPECT_NEAR(share(point.tau), 1.0, 1e-9);
}

TEST_F(PairTorqueTest, TheGaitCountsOnLessOfAnAnkleThatSharesItsMotors) {
  // Motors so weak that the ankle decides where the zero-moment point is held.
  std::string text = parallel_ankles_text();
  for (std::size_t at = text.find("torque: 90"); at != std::string::npos; at = text.find("torque: 90")) text.replace(at, 10, "torque: 15");
  const Model weak = biped12_with(text);
  Model alone = load_robot("biped12");  // the same ankle, as if each joint had its torque to itself
  for (const char* name : {"RLEG_ANKLE_P", "LLEG_ANKLE_P"}) {
    const auto j = static_cast<std::size_t>(alone.find_joint(name));
    alone.joints[j].effort = weak.joints[j].effort;
  }
  EXPECT_LT(gait_of(weak, weak.walking, 0.01).zmp_forward, gait_of(alone, alone.walking, 0.01).zmp_forward);
}

}  // namespace
}  // namespace twinbus::test
