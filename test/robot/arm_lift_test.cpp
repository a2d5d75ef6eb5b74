#include <gtest/gtest.h>

#include <cmath>

#include "robot/dynamics/gravity_load.h"
#include "robot/onboarding/anatomy.h"

namespace twinbus {
namespace {

constexpr double kWeight = 4.0 * 0.3 * 9.80665;  // times the lever of the whole arm [N m]

// 4 kg, 0.3 m ahead of a shoulder 1 m above the ground.
Model heavy_arm(double effort) {
  Model model;
  model.floating_base = false;
  model.links.resize(2);
  model.links[1].parent = 0;
  model.links[1].mass = 4.0;
  model.links[1].com = {0.3, 0.0, 0.0};
  Joint shoulder;
  shoulder.name = "shoulder";
  shoulder.parent = 0;
  shoulder.child = 1;
  shoulder.placement.translation().z() = 1.0;
  shoulder.axis = Eigen::Vector3d::UnitY();
  shoulder.lower = -2.0;
  shoulder.upper = 2.0;
  shoulder.effort = effort;
  model.joints.push_back(shoulder);
  model.hands[1].link = 1;
  model.hands[1].joints = {0};
  return model;
}

TEST(ArmLift, WhatAJointCarriesIsAShareOfItsLimit) {
  const Model model = heavy_arm(20.0);
  Configuration there(model);
  GravityLoad load(model);
  GravityLoad::Worst worst = load.of(there, {0});
  EXPECT_EQ(worst.joint, 0);
  EXPECT_NEAR(worst.effort, kWeight, 1e-2);
  EXPECT_NEAR(worst.share, kWeight / 20.0, 1e-3);
  there.q[0] = 1.0;
  EXPECT_NEAR(load.of(there, {0}).effort, kWeight * std::cos(1.0), 1e-2);
  EXPECT_EQ(load.of(there, {}).joint, -1);
}

TEST(ArmLift, AnArmThatItsJointsCannotHoldBeginsWhereTheyCan) {
  Anatomy anatomy;
  for (const double effort : {20.0, 10.0}) {
    const Model model = heavy_arm(effort);
    anatomy.hands = model.hands;
    Eigen::VectorXd q = neutral_posture(model);
    const std::string said = lift_arms(model, anatomy, q);
    const double share = kWeight * std::cos(q[0]) / effort;
    EXPECT_LE(share, 0.8) << effort;
    EXPECT_EQ(said.empty(), effort == 20.0) << said;
    if (said.empty()) {
      EXPECT_EQ(q[0], 0.0);
    } else {
      EXPECT_GT(kWeight * std::cos(std::abs(q[0]) - 0.1) / effort, 0.8) << "no farther than it must";
    }
  }
}

}  // namespace
}  // namespace twinbus
