#include "launcher/check/trained_joints.h"

#include <gtest/gtest.h>

#include "robot/description/load.h"
#include "test/error_of.h"
#include "test/temporary_folder.h"

namespace twinbus::test {
namespace {

class TrainedJoints : public ::testing::Test {
 protected:
  std::vector<TrainedJoint> read(const std::string& text) {
    folder_.write("spec.yaml", text);
    return read_trained_joints(folder_.path() + "/spec.yaml", model_);
  }
  std::string refusal(const std::string& text) {
    return error_of([&] { (void)read(text); });
  }
  const Model model_ = load_robot("pendulum");
  const std::string joint_ = model_.joints[0].name;
  TemporaryFolder folder_;
};

TEST_F(TrainedJoints, ArmatureAndFrictionAreRead) {
  const auto trained = read("spec: 1\njoints:\n  - {name: " + joint_ + ", default: 0, scale: 0.5, kp: 75, kd: 2, armature: 0.01, friction: 0.3}\n");
  ASSERT_EQ(trained.size(), 1u);
  EXPECT_EQ(trained[0].joint, joint_);
  EXPECT_EQ(trained[0].rotor_inertia, 0.01);
  EXPECT_EQ(trained[0].friction, 0.3);
}

TEST_F(TrainedJoints, WhatSaysNothingOfThisRobotIsRefused) {
  EXPECT_NE(refusal("spec: 1\njoints: [{name: tail, armature: 0.01}]\n").find("tail, which the robot has not"), std::string::npos);
  EXPECT_NE(refusal("spec: 1\njoints: [{name: " + joint_ + ", kp: 75}]\n").find("neither armature nor friction"), std::string::npos);
  EXPECT_NE(refusal("joints: [{name: " + joint_ + ", armature: 0.01}]\n").find("no SPEC.yaml"), std::string::npos);
  EXPECT_NE(refusal("spec: 1\njoints: [{name: " + joint_ + ", armature: -1}]\n").find("armature"), std::string::npos);
}

}  // namespace
}  // namespace twinbus::test
