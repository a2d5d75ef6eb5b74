#include "sim/emulated_robot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "robot/description/load.h"
#include "sim/scene/settings.h"
#include "sim/world/coulomb_friction.h"

namespace twinbus {
namespace {

using emulated::CommandKind;
using emulated::CommandPacket;
using emulated::DeviceMode;
using emulated::StatePacket;

constexpr std::int64_t kPeriod = 2'000'000;

class EmulatedRobotTest : public ::testing::Test {
 protected:
  EmulatedRobotTest()
      : model(load_robot("hrp1s")),
        robot(model, load_scene("stand"), {.hold = 0.5, .settings = {}}) {
    cycle(1);
  }

  void cycle(int count) {
    for (int i = 0; i < count; ++i) robot.cycle(now_ns += kPeriod, state);
  }

  CommandPacket drive() {
    CommandPacket packet;
    packet.kind = CommandKind::kDrive;
    packet.session = 5;
    packet.sequence = ++sequence;
    packet.model_hash = model.hash;
    packet.joint_count = 29;
    packet.q = state.q;
    packet.tau = state.tau;
    for (std::size_t k = 0; k < 29; ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
      packet.kp[k] = static_cast<float>(joint.kp);
      packet.kd[k] = static_cast<float>(joint.kd);
    }
    return packet;
  }

  const Model model;
  EmulatedRobot robot;
  StatePacket state;
  std::int64_t now_ns = 0;
  std::uint64_t sequence = 0;
};

TEST_F(EmulatedRobotTest, ItsFrictionIsNoMoreThanAShareOfWhatASmallMotorGives) {
  SimSettings settings;
  apply_settings(EmulatedRobot::differences(), model.period(), settings);
  Joint joint;
  joint.effort = 400.0;
  EXPECT_DOUBLE_EQ(coulomb_friction(joint, settings.world), 1.0);
  joint.effort = 5.0;
  EXPECT_DOUBLE_EQ(coulomb_friction(joint, settings.world), 0.05);
}

TEST_F(EmulatedRobotTest, HoldsItsStartPoseWithServosOffUntilCommanded) {
  const NamedPose& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))];
  cycle(200);
  EXPECT_EQ(state.mode, DeviceMode::kBraked);
  EXPECT_EQ(state.enabled, 0);
  for (std::size_t k = 0; k < 29; ++k) {
    EXPECT_NEAR(state.q[k], pose.q[static_cast<std::size_t>(model.bus_joints[k])], 2e-3);
  }
  ASSERT_TRUE(robot.accept(drive(), now_ns));
  cycle(1);
  EXPECT_EQ(state.mode, DeviceMode::kDriven);
  EXPECT_EQ(state.enabled, (std::int64_t{1} << 29) - 1);
}

TEST_F(EmulatedRobotTest, WithoutCommandsItHoldsAfter50MillisecondsThenDamps) {
  const CommandPacket first = drive();
  ASSERT_TRUE(robot.accept(first, now_ns));
  cycle(25);
  EXPECT_EQ(robot.mode(), DeviceMode::kDriven);
  cycle(1);
  EXPECT_EQ(robot.mode(), DeviceMode::kHolding);
  cycle(100);
  EXPECT_EQ(robot.mode(), DeviceMode::kHolding);
  EXPECT_NE(state.enabled, 0);
  EXPECT_FALSE(robot.truth()->fell);
  cycle(151);
  EXPECT_EQ(robot.mode(), DeviceMode::kDamping);
  EXPECT_EQ(state.enabled, 0);
}

TEST_F(EmulatedRobotTest, ACommandEndsTheHold) {
  ASSERT_TRUE(robot.accept(drive(), now_ns));
  cycle(100);
  ASSERT_EQ(robot.mode(), DeviceMode::kHolding);
  ASSERT_TRUE(robot.accept(drive(), now_ns));
  EXPECT_EQ(robot.mode(), DeviceMode::kDriven);
}

TEST_F(EmulatedRobotTest, DropsWhatIsNotForItOrOldOrNotANumber) {
  CommandPacket packet = drive();
  ASSERT_TRUE(robot.accept(packet, now_ns));
  EXPECT_FALSE(robot.accept(packet, now_ns)) << "twice";
  packet = drive();
  packet.model_hash += 1;
  EXPECT_FALSE(robot.accept(packet, now_ns));
  packet = drive();
  packet.joint_count = 30;
  EXPECT_FALSE(robot.accept(packet, now_ns));
  packet = drive();
  packet.q[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(robot.accept(packet, now_ns));
  packet = drive();
  packet.kp[3] = -1.0F;
  EXPECT_FALSE(robot.accept(packet, now_ns));
  cycle(1);
  EXPECT_EQ(state.dropped, 5U);
}

TEST_F(EmulatedRobotTest, DamagedDatagramsAreNotUnsealed) {
  CommandPacket packet = drive();
  emulated::seal(packet);
  CommandPacket copy;
  EXPECT_TRUE(emulated::unseal(&packet, sizeof packet, copy));
  EXPECT_FALSE(emulated::unseal(&packet, sizeof packet - 1, copy));
  auto* bytes = reinterpret_cast<unsigned char*>(&packet);
  for (std::size_t i = 0; i < sizeof packet; i += 7) {
    bytes[i] ^= 0x10U;
    EXPECT_FALSE(emulated::unseal(&packet, sizeof packet, copy)) << i;
    bytes[i] ^= 0x10U;
  }
  EXPECT_EQ(emulated::crc32("123456789", 9), 0xcbf43926U);
}

TEST_F(EmulatedRobotTest, IsNotTheNominalRobot) {
  double force = 0.0;
  cycle(400);
  for (std::size_t foot = 0; foot < 2; ++foot) force += static_cast<double>(state.wrench[foot][2]);
  EXPECT_NEAR(force, 1.03 * model.total_mass() * 9.81, 15.0);
}

}  // namespace
}  // namespace twinbus
