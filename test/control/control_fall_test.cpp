// What the controller does about a fall: it sees it early, braces, and lets go of a robot that lies.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

TEST(ControlFall, ARobotThatHasFallenIsDamped) {
  SimRig rig(test::hrp1s(), flat_scene(), {}, {});
  ASSERT_TRUE(rig.run(0.05));
  RobotState state = rig.state();
  const double half = 0.5;  // a roll of 1 rad
  state.attitude = {static_cast<float>(std::cos(half)), static_cast<float>(std::sin(half)), 0.0F,
                    0.0F};
  ++state.tick;
  rig.loop().on_state(state, state.time_ns);
  JointCommand command;
  ASSERT_TRUE(rig.loop().step(state.time_ns, command));
  EXPECT_EQ(rig.loop().status().mode, Mode::kIdle);
  ASSERT_NE(rig.loop().take_sentence(), nullptr);
}

// A gate that obeys nobody lets it do nothing about a fall: it is not said with every tick.
TEST(ControlFall, AFallBehindAStoppedGateIsNotSaidEveryTick) {
  SimRig rig(test::hrp1s(), flat_scene(), {}, {});
  ASSERT_TRUE(rig.run(0.05));
  RobotState state = rig.state();
  state.attitude = {static_cast<float>(std::cos(0.1)), static_cast<float>(std::sin(0.1)), 0.0F, 0.0F};
  state.gyro = {2.0F, 0.0F, 0.0F};
  state.role = Role::kStopped;
  state.stop_kind = StopKind::kHold;
  int said = 0;
  for (int i = 0; i < 20; ++i) {
    ++state.tick;
    state.time_ns += 2'000'000;
    rig.loop().on_state(state, state.time_ns);
    JointCommand command;
    (void)rig.loop().step(state.time_ns, command);
    const char* sentence = rig.loop().take_sentence();
    if (sentence != nullptr && std::string(sentence).find("falls") != std::string::npos) ++said;
  }
  EXPECT_LE(said, 1);
}

// A push that no step catches: said early, knees bent and gains down before the robot lies.
TEST(ControlFall, AFallIsSeenEarlyAndTheRobotBracesItself) {
  const Model& model = test::hrp1s();
  for (const Eigen::Vector3d& impulse :
       {Eigen::Vector3d(0.0, 130.0, 0.0), Eigen::Vector3d(150.0, 0.0, 0.0),
        Eigen::Vector3d(-130.0, 0.0, 0.0)}) {
    Scene scene = flat_scene();
    scene.pushes.push_back({.link = "CHEST", .impulse = impulse, .at = 0.5, .duration = 0.1});
    SimRig rig(model, scene, {}, {});
    double said = -1.0, tilted = -1.0, softest = 1.0, knee = 0.0;
    for (int i = 0;
         i < 2000 && !(said > 0.0 && 0.002 * static_cast<double>(rig.ticks()) > said + 0.7); ++i) {
      ASSERT_TRUE(rig.tick());
      const double now = 0.002 * static_cast<double>(rig.ticks());
      const char* sentence = rig.loop().take_sentence();
      if (sentence != nullptr && std::string(sentence).find("falls") != std::string::npos)
        said = now;
      if (said > 0.0) {
        softest = std::min(softest, static_cast<double>(rig.command().kp[3]) / model.joints[3].kp);
        knee = std::max(knee, rig.command().q[3]);
      }
      if (tilted < 0.0 && rig.record().base_tilt_max > 1.0) tilted = now;
    }
    ASSERT_GT(said, 0.0) << impulse.transpose();
    ASSERT_GT(tilted, 0.0) << impulse.transpose();
    EXPECT_GT(tilted - said, 0.15) << impulse.transpose();
    EXPECT_LT(softest, 0.2);
    EXPECT_GT(knee, 1.6);
    EXPECT_EQ(rig.loop().status().mode, Mode::kStop);
    ASSERT_TRUE(rig.run(4.0));
    EXPECT_EQ(rig.loop().status().mode, Mode::kIdle) << "it lies and is let go";
  }
}

}  // namespace
}  // namespace twinbus
