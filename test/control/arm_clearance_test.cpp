// The arm on the side to which the trunk leans swings out, the other stays, and a small lean moves none.

#include "control/balance/arm_clearance.h"

#include <gtest/gtest.h>

#include "robot/description/load.h"

namespace twinbus {
namespace {

ArmClearance leaning(double lean) {
  static const Model model = load_robot("hrp1s");
  ArmClearance arms(model, {});
  for (int i = 0; i < 1000; ++i) arms.update(lean, 0.002);
  return arms;
}

TEST(ArmClearance, TheJointIsTheShoulderThatRolls) {
  static const Model model = load_robot("hrp1s");
  const ArmClearance arms(model, {});
  EXPECT_EQ(model.joints[static_cast<std::size_t>(arms.joint(0))].name, "LARM_SHOULDER_R");
  EXPECT_EQ(model.joints[static_cast<std::size_t>(arms.joint(1))].name, "RARM_SHOULDER_R");
}

TEST(ArmClearance, SmallLeansMoveNoArm) {
  const ArmClearance arms = leaning(ArmClearanceGains{}.free);
  EXPECT_EQ(arms.angle(0), 0.0);
  EXPECT_EQ(arms.angle(1), 0.0);
}

TEST(ArmClearance, TheArmOnTheSideOfTheLeanGoesOut) {
  const ArmClearance left = leaning(0.5), right = leaning(-0.5);
  EXPECT_NEAR(left.angle(0), 0.6 * 0.35, 1e-6);  // about +x, away from the left leg
  EXPECT_EQ(left.angle(1), 0.0);
  EXPECT_EQ(right.angle(0), 0.0);
  EXPECT_NEAR(right.angle(1), -0.6 * 0.35, 1e-6);
}

TEST(ArmClearance, NoLeanAsksForMoreThanTheLimit) {
  EXPECT_NEAR(leaning(3.0).angle(0), ArmClearanceGains{}.limit, 1e-6);
}

}  // namespace
}  // namespace twinbus
