// A push at the chest while standing, in the simulator and with the guard in the loop: nominal robot, and one that is
// heavier and noisy.

#include <gtest/gtest.h>

#include "robot/description/load.h"
#include "test/control/sensor_noise.h"
#include "test/control/sim_rig.h"

namespace twinbus {
namespace {

const Settings kHeavyAndNoisy =
    test::noisy({"1e-5", "0.002", "1e-4", "0.001", "1", "0.05"}, {{"model.mass_scale", "1.03"}});

RigRecord push(double ix, double iy, const Settings& settings) {
  static const Model model = load_robot("hrp1s");
  Scene scene;
  scene.pushes.push_back(
      {.link = "CHEST", .point = {0, 0, 0}, .impulse = {ix, iy, 0}, .at = 2.0, .duration = 0.1});
  ControlConfig config;
  SimRig rig(model, scene, settings, config);
  EXPECT_TRUE(rig.run(1.9));
  rig.forget();
  for (int i = 0; i < 1300; ++i) {
    EXPECT_TRUE(rig.tick());
    // No arm comes in the way of the leaning trunk.
    EXPECT_EQ(rig.loop().guard_report().hold_mask, 0) << "tick " << rig.ticks();
  }
  return rig.record();
}

void stands(const RigRecord& record) {
  EXPECT_FALSE(record.fell);
  EXPECT_GE(record.zmp_margin_min, 0.005);
  EXPECT_LE(record.sole_tilt_max, 0.5 / 57.29577951308232);
  EXPECT_LE(record.effort_share_max, 1.0);
}

TEST(Push, FortyFiveForwardIsStoodOnFlatSoles) { stands(push(45.0, 0.0, {})); }
TEST(Push, ThirtyBackIsStoodOnFlatSoles) { stands(push(-30.0, 0.0, {})); }
TEST(Push, FortyFiveLeftIsStoodOnFlatSoles) { stands(push(0.0, 45.0, {})); }
TEST(Push, FortyFiveRightIsStoodByAHeavierRobotWithNoise) {
  stands(push(0.0, -45.0, kHeavyAndNoisy));
}

}  // namespace
}  // namespace twinbus
