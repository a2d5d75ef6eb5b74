#include "control/walk/ground_roughness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "control/walk/ground_slope.h"

namespace twinbus {
namespace {

using Eigen::Vector2d;

constexpr double kStep = 0.2, kToe = 0.15, kHeel = 0.1;

// Steps forward, on soles that tell the ground below them.
struct Walker {
  // gradient: under the sole that carried; landed: as the other one was turned.
  void land(double rise, const Vector2d& gradient, const Vector2d& landed) {
    slope.stood_on(gradient);
    roughness.landed({.way = {kStep, 0.0}, .rise = rise, .landed = landed, .gradient = gradient, .toe = kToe, .heel = kHeel}, slope.gradient());
  }
  // The sole comes down turned as the slope is believed to be, upwards on its toe or downwards on its heel.
  void land_on(const Vector2d& plane) {
    const Vector2d believed = slope.gradient();
    const double off = plane.x() - believed.x();
    land(plane.x() * kStep + std::max(kToe * off, -kHeel * off), plane, believed);
  }
  GroundSlope slope;
  GroundRoughness roughness;
};

TEST(GroundRoughness, OnLevelGroundThereIsNone) {
  Walker walker;
  for (int i = 0; i < 10; ++i) walker.land_on(Vector2d::Zero());
  EXPECT_EQ(walker.roughness.roughness(), 0.0);
}

// As soon as a slope is believed, the steps that led to it were no roughness; nor was the one over its edge, half up.
TEST(GroundRoughness, ASlopeIsForgivenWhenItIsBelievedAndItsEndTooWhenTheGroundIsLevelAgain) {
  const Vector2d ramp(std::tan(0.0873), 0.0);
  Walker walker;
  for (int i = 0; i < 4; ++i) walker.land_on(Vector2d::Zero());
  walker.land(0.5 * kStep * ramp.x(), Vector2d::Zero(), Vector2d::Zero());
  walker.land_on(ramp);
  EXPECT_GT(walker.roughness.roughness(), 0.9 * (kToe + kHeel) * ramp.x()) << "nobody knows yet that it is a slope";
  int until = 0;
  for (; until < 10 && walker.roughness.roughness() > 0.005; ++until) walker.land_on(ramp);
  EXPECT_LE(until, 4);
  for (int i = 0; i < 10; ++i) walker.land_on(ramp);
  EXPECT_LT(walker.roughness.roughness(), 1e-3);
  walker.land(0.5 * kStep * ramp.x(), ramp, ramp);
  for (until = 0; until < 20 && (until == 0 || walker.roughness.roughness() > 0.005); ++until) walker.land_on(Vector2d::Zero());
  EXPECT_LE(until, 5);
}

TEST(GroundRoughness, AStepIsRememberedFromLandingToLanding) {
  Walker walker;
  walker.land(0.02, Vector2d::Zero(), Vector2d::Zero());
  EXPECT_DOUBLE_EQ(walker.roughness.roughness(), 0.02);
  double before = 0.02;
  for (int i = 0; i < 20; ++i) {
    walker.land_on(Vector2d::Zero());
    EXPECT_NEAR(walker.roughness.roughness(), 0.9 * before, 1e-12) << i;
    before = walker.roughness.roughness();
  }
}

// Tiles of walk_rough: +- 3 degrees, up to 30 mm high.
TEST(GroundRoughness, TilesAtRandomAreNotForgiven) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> tilt(-0.052, 0.052), height(0.0, 0.03);
  Walker walker;
  double last = 0.0, least = 1.0;
  for (int i = 0; i < 2000; ++i) {
    const double now = height(random);
    walker.land(now - last, {tilt(random), tilt(random)}, Vector2d::Zero());
    last = now;
    if (i > 10) least = std::min(least, walker.roughness.roughness());
  }
  EXPECT_GT(least, 0.008);
}

TEST(GroundRoughness, ASoleThatDoesNotTellCountsByItsHeightAlone) {
  GroundRoughness roughness;
  roughness.landed({.way = {kStep, 0.0}, .rise = 0.003, .gradient = {0.2, 0.1}}, Vector2d::Zero());
  EXPECT_DOUBLE_EQ(roughness.roughness(), 0.003);
}

}  // namespace
}  // namespace twinbus
