// A world that begins far from its origin does what it does at the origin.

#include "sim/world/world_origin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "both_engines.h"
#include "test_models.h"

namespace twinbus {
namespace {

// A brick falls on a fixed box and from there to the ground; a ball hangs on a spring from a fixed point.
WorldConfig falling() {
  WorldConfig config;
  config.step = 1e-3;
  Obstacle step;
  step.shape = ObstacleShape::kBox;
  step.size << 0.4, 0.4, 0.2;
  step.pose.translation() = Eigen::Vector3d(0.2, 0, 0.1);
  config.obstacles = {step};
  LooseBody brick, ball;
  brick.name = "brick";
  brick.solid.size << 0.3, 0.2, 0.1;
  brick.start.pose.translation() = Eigen::Vector3d(0, 0, 0.5);
  ball.name = "ball";
  ball.solid = {SolidShape::kSphere, {0.05, 0, 0}};
  ball.start.pose.translation() = Eigen::Vector3d(2, 0, 1);
  config.loose = {brick, ball};
  Tie tie;
  tie.a = {-1, 1, Eigen::Vector3d::Zero()};
  tie.b = {-1, -1, {2, 0.5, 1}};
  tie.length = 0.4;
  tie.stiffness = 1e3;
  tie.damping = 1.0;
  config.ties = {tie};
  return config;
}

TWINBUS_BOTH_ENGINES(WorldOriginTest);

TEST_P(WorldOriginTest, FarAwayItIsAsAtTheOrigin) {
  const Model model = test::bystander();
  const Eigen::Vector3d far(1e4, -1e5, 0.0);
  WorldConfig config = falling();
  const auto here = make(model, config);
  move_everything(far, config);
  const auto there = make(model, config);
  ASSERT_EQ(here->set(Configuration(model)), Status::kOk);
  Configuration start(model);
  start.base.translation() = far;
  ASSERT_EQ(there->set(start), Status::kOk);
  double worst = 0.0;
  for (int i = 0; i < 300; ++i) {  // the brick has landed on the box and tips over its edge
    ASSERT_EQ(here->step(), Status::kOk);
    ASSERT_EQ(there->step(), Status::kOk);
    for (int b = 0; b < 2; ++b)
      worst = std::max(worst, (there->loose(b).pose.translation() - far - here->loose(b).pose.translation()).norm());
  }
  EXPECT_LT(here->loose(0).pose.translation().z(), 0.3);
  EXPECT_GT((here->loose(1).pose.translation() - Eigen::Vector3d(2, 0, 1)).norm(), 0.05);
  EXPECT_LT(worst, 1e-6);
}

TEST_P(WorldOriginTest, ARobotMayStandAHundredKilometresAwayAndNotTenThousand) {
  const Model model = test::block();
  const auto world = make(model);
  Configuration start(model);
  start.base.translation() = Eigen::Vector3d(kMostOrigin, 0, 1);
  ASSERT_EQ(world->set(start), Status::kOk);
  EXPECT_EQ(world->step(), Status::kOk);
  start.base.translation().x() = 100.0 * kMostOrigin;
  EXPECT_EQ(world->set(start), Status::kOutOfRange);
}

}  // namespace
}  // namespace twinbus
