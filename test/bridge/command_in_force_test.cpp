#include "bridge/gate/command_in_force.h"

#include <gtest/gtest.h>

#include "test/bridge/small_robot.h"

namespace twinbus {
namespace {

using namespace test;

class InForce : public ::testing::Test {
 protected:
  InForce() : model(small_model()), limits(model) {
    before = newest = command_for(measured);
    measured.q[0] = 0.1;
    before.q[0] = 0.11;  // 10 N m
    newest.q[0] = 0.14;  // 40 N m
  }
  bool find() { return find_command_in_force(measured, before, newest, limits, found); }

  Model model;
  GateLimits limits;
  RobotState measured;
  JointCommand before, newest, found;
};

TEST_F(InForce, TheNewestWhereItsTorqueIsMeasured) {
  measured.tau[0] = 41.0F;  // within 2 % of the limit
  EXPECT_TRUE(find());
  EXPECT_EQ(found.q, newest.q);
  EXPECT_EQ(found.tau[0], 0.0F);
}

TEST_F(InForce, TheOneBeforeWhereTheNewestHasNotComeToActYet) {
  measured.tau[0] = 10.0F;
  EXPECT_TRUE(find());
  EXPECT_EQ(found.q[0], before.q[0]);
}

TEST_F(InForce, WhatLiesBetweenWhereTheNewestActsInPart) {
  measured.tau[0] = 25.0F;
  EXPECT_TRUE(find());
  EXPECT_NEAR(found.q[0], 0.125, 1e-6);
  EXPECT_EQ(found.tau[0], 0.0F);
}

TEST_F(InForce, TheLimitOfTheServoIsNoJump) {
  newest.q[0] = 0.3;  // 200 N m of 100
  measured.tau[0] = 100.0F;
  EXPECT_TRUE(find());
  EXPECT_EQ(found.q, newest.q);
}

TEST_F(InForce, ATorqueThatComesOfNeitherIsAddedToTheNewest) {
  measured.tau[0] = 50.0F;
  measured.tau[1] = 1.0F;
  EXPECT_FALSE(find());
  EXPECT_EQ(found.q, newest.q);
  EXPECT_NEAR(found.tau[0], 10.0F, 1e-3);
  EXPECT_NEAR(found.tau[1], 1.0F, 1e-6);
}

// Torques are not between those of two commands of different gains in the way that their set-points are.
TEST_F(InForce, GainsThatChangeAreNotMixed) {
  newest.kp[0] = 2000.0F;  // 80 N m
  measured.tau[0] = 40.0F;
  EXPECT_FALSE(find());
  EXPECT_EQ(found.kp[0], 2000.0F);
  measured.tau[0] = 10.0F;
  EXPECT_TRUE(find());
  EXPECT_EQ(found.kp[0], 1000.0F);
  EXPECT_EQ(found.q[0], before.q[0]);
}

}  // namespace
}  // namespace twinbus
