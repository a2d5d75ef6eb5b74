#include "robot/kinematics/pose_request.h"

#include <gtest/gtest.h>

#include <limits>

#include "robot/description/load.h"

namespace twinbus {
namespace {

TEST(PoseRequest, TakesAJointWithinItsLimits) {
  const Model model = load_robot("hrp1s");
  ModeRequest pose;
  EXPECT_EQ(add_joint(model, "RLEG_KNEE", 0.5, pose), "");
  EXPECT_EQ(add_joint(model, "CHEST", 0.1, pose), "");
  int asked = 0;
  for (int k = 0; k < model.bus_count(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    if ((pose.joint_mask >> k & 1) == 0) continue;
    ++asked;
    const std::string& name = model.joints[static_cast<std::size_t>(model.bus_joints[i])].name;
    EXPECT_EQ(pose.q[i], name == "CHEST" ? 0.1 : 0.5) << name;
  }
  EXPECT_EQ(asked, 2);
}

TEST(PoseRequest, WhatCannotBeAskedIsNamed) {
  const Model model = load_robot("hrp1s");
  ModeRequest pose;
  EXPECT_NE(add_joint(model, "RLEG_KNE", 0.5, pose).find("RLEG_KNEE"), std::string::npos);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double q : {9.0, -infinity, infinity, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_NE(add_joint(model, "RLEG_KNEE", q, pose).find("limits"), std::string::npos) << q;
  EXPECT_EQ(pose.joint_mask, 0);
}

}  // namespace
}  // namespace twinbus
