// Sensors that are not ideal: three times the noise of scene walk_noisy and what a calibration leaves.

#include <gtest/gtest.h>

#include "test/control/hrp1s.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

const Settings kNoise{{"sensor.noise.encoder", "3e-5"},   {"sensor.noise.velocity", "0.03"},
                      {"sensor.noise.attitude", "0.006"}, {"sensor.noise.gyro", "0.03"},
                      {"sensor.noise.accel", "0.15"},     {"sensor.noise.force", "15"},
                      {"sensor.noise.moment", "1.5"},     {"sensor.bias.roll", "0.003"},
                      {"sensor.bias.pitch", "0.003"},     {"sensor.bias.gyro", "0.005"},
                      {"sensor.bias.accel", "0.03"},      {"sensor.bias.force", "5"}};

Model robot_that_estimates() {
  Model model = test::hrp1s();
  model.walking.own_attitude = true;
  return model;
}

double degrees(double angle) { return 57.29577951308232 * angle; }

// From balance to walking on the spot of both feet and back: what one noisy tick says is not kept for the change.
void changes_modes_upright(const Model& model) {
  SimRig robot(model, Scene{}, kNoise, {});
  ASSERT_TRUE(robot.run(1.0));
  EXPECT_EQ(robot.loop().status().mode, Mode::kBalance);
  robot.ask(Mode::kWalk);
  ASSERT_TRUE(robot.run(1.0));
  EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
  robot.ask(Mode::kBalance);
  ASSERT_TRUE(robot.run(4.0));
  EXPECT_EQ(robot.loop().status().mode, Mode::kBalance);
  EXPECT_FALSE(robot.record().fell);
  EXPECT_LT(degrees(robot.record().base_tilt_max), 3.0);
}

TEST(Noise, ModesAreChangedUprightWithTheAttitudeOfTheImu) { changes_modes_upright(test::hrp1s()); }

TEST(Noise, ModesAreChangedUprightWithAnEstimatedAttitude) {
  changes_modes_upright(robot_that_estimates());
}

// Until then it holds: who balanced on the first look would balance on noise.
TEST(Noise, ARobotThatEstimatesItsAttitudeLooksBeforeItBalances) {
  const Model model = robot_that_estimates();
  SimRig robot(model, Scene{}, kNoise, {});
  ASSERT_TRUE(robot.run(0.1));
  robot.ask(Mode::kWalk);
  ASSERT_TRUE(robot.run(0.18));
  EXPECT_EQ(robot.loop().status().mode, Mode::kHold);
  ASSERT_TRUE(robot.run(0.04));
  EXPECT_EQ(robot.loop().take_sentence(), nullptr);
  EXPECT_EQ(robot.loop().status().mode, Mode::kWalk);
}

}  // namespace
}  // namespace twinbus
