#include "sim/sim_adaptor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "robot/dynamics/inverse_dynamics.h"
#include "robot/description/load.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

class SimAdaptorTest : public ::testing::Test {
 protected:
  SimAdaptorTest() : model(load_robot("hrp1s")) {}

  // Holds the posture of a state with the torques measured in it.
  JointCommand hold(const RobotState& state) const {
    JointCommand command;
    command.joint_count = state.joint_count;
    for (std::size_t k = 0; k < model.bus_joints.size(); ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
      command.q[k] = state.q[k];
      command.tau[k] = state.tau[k];
      command.kp[k] = static_cast<float>(joint.kp);
      command.kd[k] = static_cast<float>(joint.kd);
    }
    return command;
  }

  double weight() const { return model.total_mass() * kGravity; }
  static double feet(const RobotState& state) {
    return static_cast<double>(state.wrench[kLeftFoot][2]) +
           static_cast<double>(state.wrench[kRightFoot][2]);
  }

  const Model model;
  const Scene scene = load_scene("stand");
};

TEST_F(SimAdaptorTest, StartsStandingAndNothingJumps) {
  SimAdaptor robot(scene);
  ASSERT_EQ(robot.open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  const double height = robot.truth()->base_position[2];
  const RobotState first = state;
  EXPECT_NEAR(feet(state), weight(), 0.01 * weight());
  EXPECT_EQ(state.enabled, (std::int64_t{1} << 29) - 1);
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
    ASSERT_NEAR(feet(state), weight(), 0.01 * weight()) << i;
    ASSERT_NEAR(robot.truth()->base_position[2], height, 2e-4);
    ASSERT_GT(robot.truth()->zmp_margin, 0.04F);
    for (std::size_t k = 0; k < 29; ++k)
      ASSERT_NEAR(state.tau[k], first.tau[k], 1.0) << i << " joint " << k;
  }
  EXPECT_FALSE(robot.truth()->fell);
  EXPECT_NEAR(state.accel[2], kGravity, 0.01);
  EXPECT_EQ(state.source_time_ns, 1'000'000'000);
}

TEST_F(SimAdaptorTest, TheSameSceneTwiceIsTheSameBitForBit) {
  SimAdaptor one(scene), two(scene);
  AdaptorConfig config{.settings = {{"sensor.noise.gyro", "0.01"}, {"model.backlash", "0.0005"}}};
  ASSERT_EQ(one.open(model, config), Status::kOk);
  ASSERT_EQ(two.open(model, config), Status::kOk);
  RobotState a, b;
  JointCommand command;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(one.read(a, 0.0), Status::kOk);
    ASSERT_EQ(two.read(b, 0.0), Status::kOk);
    ASSERT_EQ(std::memcmp(&a.q, &b.q, sizeof a.q), 0) << i;
    ASSERT_EQ(std::memcmp(&a.tau, &b.tau, sizeof a.tau), 0) << i;
    ASSERT_EQ(std::memcmp(&a.wrench, &b.wrench, sizeof a.wrench), 0) << i;
    ASSERT_EQ(std::memcmp(&a.gyro, &b.gyro, sizeof a.gyro), 0) << i;
    if (i == 0) command = hold(a);
    command.q[26] = 0.02 * std::sin(0.01 * i);  // bow a little
    ASSERT_EQ(one.write(command), Status::kOk);
    ASSERT_EQ(two.write(command), Status::kOk);
  }
}

TEST_F(SimAdaptorTest, NothingIsAllocatedInTheLoop) {
  SimAdaptor robot(scene);
  ASSERT_EQ(robot.open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  const JointCommand command = hold(state);
  ImposedState imposed;
  for (std::size_t k = 0; k < 29; ++k) imposed.q[k] = state.q[k];
  imposed.base.translation().z() = robot.truth()->base_position[2];
  for (int i = 0; i < 50; ++i) {  // ODE's own memory settles
    (void)robot.write(command);
    (void)robot.read(state, 0.0);
  }
  const NoAlloc guard;
  for (int i = 0; i < 100; ++i) {
    (void)robot.write(command);
    (void)robot.read(state, 0.0);
    if (i % 10 == 0) (void)robot.set_state(imposed);
  }
  EXPECT_EQ(guard.count(), 0);
}

TEST_F(SimAdaptorTest, RefusesWhatIsNotANumberBeforeTheEngineSeesIt) {
  SimAdaptor robot(scene);
  EXPECT_EQ(robot.write({}), Status::kNotOpen);
  ASSERT_EQ(robot.open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  const JointCommand good = hold(state);
  for (int field = 0; field < 5; ++field) {
    for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
      JointCommand command = good;
      if (field == 0) command.q[5] = bad;
      if (field == 1) command.qd[5] = static_cast<float>(bad);
      if (field == 2) command.tau[5] = static_cast<float>(bad);
      if (field == 3) command.kp[5] = static_cast<float>(bad);
      if (field == 4) command.kd[5] = static_cast<float>(bad);
      EXPECT_EQ(robot.write(command), Status::kNotFinite);
    }
  }
  JointCommand short_one = good;
  short_one.joint_count = 28;
  EXPECT_EQ(robot.write(short_one), Status::kWrongSize);
  ImposedState imposed;
  imposed.q[0] = kNan;
  EXPECT_EQ(robot.set_state(imposed), Status::kNotFinite);
  for (int i = 0; i < 50; ++i) ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  EXPECT_NEAR(feet(state), weight(), 0.01 * weight());
}

TEST_F(SimAdaptorTest, NoJointExceedsItsEffortWhateverIsAsked) {
  SimAdaptor robot(scene);
  ASSERT_EQ(robot.open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  JointCommand command = hold(state);
  for (int i = 0; i < 300; ++i) {
    for (std::size_t k = 0; k < 29; ++k) command.q[k] = state.q[k] + (i / 20 % 2 == 0 ? 1.0 : -1.0);
    ASSERT_EQ(robot.write(command), Status::kOk);
    ASSERT_EQ(robot.read(state, 0.0), Status::kOk) << i;
    for (std::size_t k = 0; k < 29; ++k) {
      const Joint& joint = model.joints[static_cast<std::size_t>(model.bus_joints[k])];
      ASSERT_LE(std::abs(static_cast<double>(state.tau[k])), joint.effort * (1.0 + 1e-6))
          << joint.name;
      ASSERT_LT(state.q[k], joint.upper + 0.01) << joint.name;
      ASSERT_GT(state.q[k], joint.lower - 0.01) << joint.name;
    }
  }
}

TEST_F(SimAdaptorTest, FarFromTheOriginItMeasuresTheSame) {
  Scene far = scene;
  far.origin << 1e4, -1e4;
  SimAdaptor here(scene), there(far);
  ASSERT_EQ(here.open(model, {}), Status::kOk);
  ASSERT_EQ(there.open(model, {}), Status::kOk);
  RobotState a, b;
  ASSERT_EQ(here.read(a, 0.0), Status::kOk);
  ASSERT_EQ(there.read(b, 0.0), Status::kOk);
  const JointCommand command = hold(a);
  for (int i = 0; i < 200; ++i) {
    for (SimAdaptor* robot : {&here, &there}) ASSERT_EQ(robot->write(command), Status::kOk);
    ASSERT_EQ(here.read(a, 0.0), Status::kOk);
    ASSERT_EQ(there.read(b, 0.0), Status::kOk);
  }
  EXPECT_NEAR(there.truth()->base_position[0] - 1e4, here.truth()->base_position[0], 1e-7);
  EXPECT_NEAR(there.truth()->base_position[1] + 1e4, here.truth()->base_position[1], 1e-7);
  for (std::size_t k = 0; k < static_cast<std::size_t>(model.bus_count()); ++k) EXPECT_NEAR(a.q[k], b.q[k], 1e-6);
}

TEST_F(SimAdaptorTest, APushGivesItsImpulse) {
  Scene pushed = scene;
  pushed.start_pose = "half_sitting";
  pushed.pushes = {
      {.link = "CHEST", .point = {0, 0, 0}, .impulse = {20, 0, 0}, .at = 0.1, .duration = 0.1}};
  SimAdaptor robot(pushed);
  AdaptorConfig slippery{.settings = {{"contact.friction", "0"}}};
  ASSERT_EQ(robot.open(model, slippery), Status::kOk);
  RobotState state;
  ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  const JointCommand command = hold(state);
  double impulse = 0.0;
  int pushing = 0;
  for (int i = 0; i < 150; ++i) {
    ASSERT_EQ(robot.write(command), Status::kOk);
    ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
    impulse += 0.002 * static_cast<double>(robot.truth()->push_force[0]);
    pushing += robot.truth()->push_force[0] > 0.0F ? 1 : 0;
  }
  EXPECT_EQ(pushing, 50);
  EXPECT_NEAR(impulse, 20.0, 1e-3);
  EXPECT_NEAR(model.total_mass() * static_cast<double>(robot.truth()->com_velocity[0]), 20.0, 0.2);
}

// A state taken from one simulation goes on in another that has other ground and masses.
TEST_F(SimAdaptorTest, SetStateGoesOnWithTheForcesOfTheOther) {
  for (const char* height : {"0", "0.001"}) {
    SimAdaptor from(scene), to(scene);
    ASSERT_EQ(from.open(model, {}), Status::kOk);
    ASSERT_EQ(to.open(model, {.settings = {{"ground.left_height_error", height},
                                           {"model.mass_scale", "1.03"},
                                           {"contact.stiffness_scale", "0.8"}}}),
              Status::kOk);
    RobotState state;
    ASSERT_EQ(from.read(state, 0.0), Status::kOk);
    JointCommand command = hold(state);
    const JointCommand start = command;
    RobotState other;
    for (int i = 0; i < 400; ++i) {  // sway with the ankles and hips
      const double angle = 0.02 * std::sin(2.0 * M_PI * 0.5 * 0.002 * i);
      for (const std::size_t k : {0U, 13U}) command.q[k] = start.q[k] + angle;
      for (const std::size_t k : {5U, 18U}) command.q[k] = start.q[k] - angle;
      ASSERT_EQ(from.write(command), Status::kOk);
      ASSERT_EQ(from.read(state, 0.0), Status::kOk);
    }
    const SimTruth& truth = *from.truth();
    ImposedState imposed;
    imposed.base.translation() =
        Eigen::Vector3d(0.1, 0.2, truth.base_position[2] + 0.002);  // an estimate
    imposed.base.linear() = Eigen::Quaterniond(truth.base_attitude[0], truth.base_attitude[1],
                                               truth.base_attitude[2], truth.base_attitude[3])
                                .toRotationMatrix();
    imposed.base_velocity =
        Eigen::Vector3d(truth.base_velocity[0], truth.base_velocity[1], truth.base_velocity[2]);
    imposed.base_angular_velocity =
        Eigen::Vector3d(truth.base_angular_velocity[0], truth.base_angular_velocity[1],
                        truth.base_angular_velocity[2]);
    imposed.forces_known = true;
    imposed.foot_wrench = {state.wrench[kLeftFoot], state.wrench[kRightFoot]};
    for (std::size_t k = 0; k < 29; ++k) {
      imposed.q[k] = state.q[k];
      imposed.qd[k] = static_cast<double>(state.qd[k]);
      imposed.tau[k] = state.tau[k];
    }
    ASSERT_EQ(to.read(other, 0.0), Status::kOk);
    ASSERT_EQ(to.set_state(imposed), Status::kOk);
    for (int i = 400; i < 800; ++i) {
      if (i > 400) {
        const double angle = 0.02 * std::sin(2.0 * M_PI * 0.5 * 0.002 * i);
        for (const std::size_t k : {0U, 13U}) command.q[k] = start.q[k] + angle;
        for (const std::size_t k : {5U, 18U}) command.q[k] = start.q[k] - angle;
        ASSERT_EQ(to.write(command), Status::kOk);
      }
      ASSERT_EQ(to.read(other, 0.0), Status::kOk);
      if (i < 410) {
        for (const Limb foot : {kLeftFoot, kRightFoot}) {
          EXPECT_NEAR(other.wrench[static_cast<std::size_t>(foot)][2],
                      state.wrench[static_cast<std::size_t>(foot)][2], 0.1 * weight())
              << i;
        }
        for (std::size_t k = 0; k < 29; ++k) {
          const double effort = model.joints[static_cast<std::size_t>(model.bus_joints[k])].effort;
          EXPECT_NEAR(other.tau[k], state.tau[k], 0.05 * effort) << i << " joint " << k;
        }
      }
      ASSERT_FALSE(to.truth()->fell) << i;
    }
    EXPECT_NEAR(to.truth()->com[0], 0.1, 0.1) << "it goes on where it was put";
  }
}

TEST_F(SimAdaptorTest, AnUnknownSettingOrPoseOrLinkDoesNotOpen) {
  ::testing::internal::CaptureStderr();
  SimAdaptor robot(scene);
  EXPECT_NE(robot.open(model, {.settings = {{"model.colour", "1"}}}), Status::kOk);
  Scene posed = scene;
  posed.start_pose = "handstand";
  EXPECT_NE(SimAdaptor(posed).open(model, {}), Status::kOk);
  Scene pushed = scene;
  pushed.pushes = {{.link = "TAIL"}};
  EXPECT_NE(SimAdaptor(pushed).open(model, {}), Status::kOk);
  const std::string said = ::testing::internal::GetCapturedStderr();
  for (const char* word : {"model.colour", "handstand", "TAIL"})
    EXPECT_NE(said.find(word), std::string::npos) << word;
}

TEST_F(SimAdaptorTest, FallSafeLetsTheRobotDownOntoTheGround) {
  SimAdaptor robot(scene);
  ASSERT_EQ(robot.open(model, {}), Status::kOk);
  RobotState state;
  ASSERT_EQ(robot.read(state, 0.0), Status::kOk);
  ASSERT_EQ(robot.fall_safe(), Status::kOk);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(robot.read(state, 0.0), Status::kOk) << i;
  EXPECT_TRUE(robot.truth()->fell);
  EXPECT_GT(robot.truth()->base_position[2], 0.0);
  EXPECT_EQ(state.enabled, 0);
}

}  // namespace
}  // namespace twinbus
