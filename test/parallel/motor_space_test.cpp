// A robot whose electronics speak of motors, behind an adaptor that speaks of joints: the stand-in robot with parallel ankles.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "bridge/adaptor/motor_space_adaptor.h"
#include "common/allocation/no_alloc.h"
#include "robot/kinematics/kinematics.h"
#include "sim/emulated_robot.h"
#include "test/parallel/parallel_biped.h"

namespace twinbus {
namespace {

using emulated::CommandKind;
using emulated::CommandPacket;
using emulated::StatePacket;

// The driver of the stand-in robot without its socket: what goes over the wire is what the robot says and hears.
class Wire final : public RobotAdaptor {
 public:
  Status open(const Model& model, const AdaptorConfig&) override {
    model_ = &model;
    robot_ = std::make_unique<EmulatedRobot>(model, load_scene("stand"), EmulatedRobotOptions{});
    return Status::kOk;
  }
  Status read(RobotState& state, double) override {
    robot_->cycle(now_ns_ += model_->period_ns, packet_);
    state.joint_count = static_cast<std::int16_t>(packet_.joint_count);
    state.q = packet_.q;
    state.qd = packet_.qd;
    state.tau = packet_.tau;
    state.attitude = packet_.attitude;
    return Status::kOk;
  }
  Status write(const JointCommand& command) override {
    sent_ = CommandPacket{};
    sent_.kind = CommandKind::kDrive;
    sent_.session = 3;
    sent_.sequence = ++sequence_;
    sent_.model_hash = model_->hash;
    sent_.joint_count = static_cast<std::uint32_t>(model_->bus_count());
    sent_.q = command.q;
    sent_.qd = command.qd;
    sent_.tau = command.tau;
    sent_.kp = command.kp;
    sent_.kd = command.kd;
    return robot_->accept(sent_, now_ns_) ? Status::kOk : Status::kDeviceError;
  }
  void close() override {}

  const StatePacket& packet() const { return packet_; }
  const CommandPacket& sent() const { return sent_; }
  const EmulatedRobot& robot() const { return *robot_; }

 private:
  const Model* model_ = nullptr;
  std::unique_ptr<EmulatedRobot> robot_;
  StatePacket packet_;
  CommandPacket sent_;
  std::int64_t now_ns_ = 0;
  std::uint64_t sequence_ = 0;
};

class MotorSpaceTest : public ::testing::Test {
 protected:
  MotorSpaceTest() : model(test::parallel_biped()), pairs(parallel_joints_of(model)), adaptor(wire) {
    EXPECT_EQ(adaptor.open(model, {}), Status::kOk);
    EXPECT_EQ(adaptor.read(state, 0.0), Status::kOk);
  }
  std::size_t bus(const ParallelJoints& pair, std::size_t i) const {
    return static_cast<std::size_t>(model.bus_index[static_cast<std::size_t>(pair.joints[i])]);
  }
  JointCommand hold() const {
    JointCommand command;
    command.joint_count = static_cast<std::int16_t>(model.bus_count());
    const Configuration at(model, "half_sitting");
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
      command.q[k] = at.q[model.bus_joints[k]];
      command.kp[k] = static_cast<float>(joint.kp);
      command.kd[k] = static_cast<float>(joint.kd);
    }
    return command;
  }

  const Model& model;
  std::vector<ParallelJoints> pairs;
  Wire wire;
  MotorSpaceAdaptor adaptor;
  RobotState state;
};

TEST_F(MotorSpaceTest, TheWireHasTheMotorsAndTheBusTheJoints) {
  for (const ParallelJoints& pair : pairs) {
    RodPosture posture;
    const Eigen::Vector2d q(state.q[bus(pair, 0)], state.q[bus(pair, 1)]);
    ASSERT_TRUE(pair.drive.at(q, posture));
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(wire.packet().q[bus(pair, i)], posture.motors[static_cast<Eigen::Index>(i)], 1e-9);
    const Configuration stands(model, "half_sitting");
    EXPECT_LT((q - pair.of(stands.q)).norm(), 0.02);
    // Work is the same on both sides.
    double wire_power = 0.0, bus_power = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      wire_power += static_cast<double>(wire.packet().tau[bus(pair, i)] * wire.packet().qd[bus(pair, i)]);
      bus_power += static_cast<double>(state.tau[bus(pair, i)] * state.qd[bus(pair, i)]);
    }
    EXPECT_NEAR(wire_power, bus_power, 1e-4 * (1.0 + std::abs(bus_power)));
  }
}

TEST_F(MotorSpaceTest, ServosOfTheJointsBecomeServosOfTheMotors) {
  JointCommand command = hold();
  ASSERT_EQ(adaptor.write(command), Status::kOk);
  const ParallelJoints& pair = pairs.front();
  for (std::size_t i = 0; i < 2; ++i) {
    // Two motors of 1 : 1 carry half of the pitch's stiffness each.
    EXPECT_NEAR(wire.sent().kp[bus(pair, i)], 0.5F * command.kp[bus(pair, 0)], 0.1F * command.kp[bus(pair, 0)]);
    EXPECT_NEAR(wire.sent().kd[bus(pair, i)], 0.5F * command.kd[bus(pair, 0)], 0.1F * command.kd[bus(pair, 0)]);
  }
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (pair_with(pairs, model.bus_joints[i]) == nullptr) {
      EXPECT_EQ(wire.sent().q[i], command.q[i]);
    }
  }
}

TEST_F(MotorSpaceTest, TheRobotStandsOnItsMotorsAndNothingIsAllocated) {
  const JointCommand command = hold();
  double worst = 0.0;
  const Configuration stands(model, "half_sitting");
  const NoAlloc guard;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(adaptor.write(command), Status::kOk);
    ASSERT_EQ(adaptor.read(state, 0.0), Status::kOk);
    for (const ParallelJoints& pair : pairs) {
      const Eigen::Vector2d q(state.q[bus(pair, 0)], state.q[bus(pair, 1)]);
      worst = std::max(worst, (q - pair.of(stands.q)).norm());
    }
  }
  EXPECT_EQ(guard.count(), 0);
  EXPECT_LT(worst, 0.03);
  EXPECT_GT(wire.robot().truth()->base_position[2], 0.9 * Configuration(model, "half_sitting").base.translation().z());
}

TEST_F(MotorSpaceTest, MotorAnglesThatNoPostureHasAreADeviceError) {
  MotorSpace space(model);
  RobotState lost = state;
  lost.q[bus(pairs.front(), 0)] = 3.0;
  lost.q[bus(pairs.front(), 1)] = -3.0;
  EXPECT_FALSE(space.to_joints(lost));
  JointCommand far = hold();
  far.q[bus(pairs.front(), 0)] = 0.0;
  far.q[bus(pairs.front(), 1)] = 1.5;
  EXPECT_EQ(adaptor.write(far), Status::kOutOfRange);
}

// A source goes on writing while reads fail.
TEST_F(MotorSpaceTest, ReadsThatFailChangeNoTorqueOfTheMotors) {
  MotorSpace space(model);
  RobotState read = state;
  ASSERT_TRUE(space.to_motors(read));
  const RobotState good = read;
  ASSERT_TRUE(space.to_joints(read));
  JointCommand before = hold(), after = hold();
  ASSERT_TRUE(space.to_motors(before));
  for (const double off : {1.6, -1.3, std::numeric_limits<double>::quiet_NaN()}) {
    for (std::size_t i = 0; i < 2; ++i) {
      RobotState lost = good;
      lost.q[bus(pairs.front(), i)] += off;
      if (space.to_joints(lost)) continue;  // some are a posture
      after = hold();
      ASSERT_TRUE(space.to_motors(after));
      EXPECT_EQ(after.tau, before.tau) << off << " of motor " << i;
    }
  }
}

TEST_F(MotorSpaceTest, NoMotorIsSentMoreTorqueThanItsLimit) {
  MotorSpace space(model);
  JointCommand far = hold();
  for (const ParallelJoints& pair : pairs) far.tau[bus(pair, 0)] = 1e4F;
  ASSERT_TRUE(space.to_motors(far));
  for (const ParallelJoints& pair : pairs) {
    for (std::size_t i = 0; i < 2; ++i) EXPECT_LE(std::abs(far.tau[bus(pair, i)]), pair.drive.torque_limits()[static_cast<int>(i)]);
  }
}

TEST(MotorSpace, ARobotWithoutSuchJointsPassesAsItIs) {
  EXPECT_TRUE(MotorSpace(load_robot("biped12")).empty());
}

}  // namespace
}  // namespace twinbus
