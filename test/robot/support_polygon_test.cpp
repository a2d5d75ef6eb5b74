#include "robot/estimation/support_polygon.h"

#include <gtest/gtest.h>

#include <random>

#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

SupportPolygon square() {
  SupportPolygon p;
  for (const double x : {0.0, 2.0}) {
    for (const double y : {0.0, 2.0}) p.add({x, y});
  }
  p.add({1.0, 1.0});  // inside
  p.add({1.0, 0.0});  // on an edge
  p.add({2.0, 2.0});  // twice
  p.finish();
  return p;
}

TEST(SupportPolygon, HullDropsInnerPoints) {
  const SupportPolygon p = square();
  EXPECT_EQ(p.count(), 4);
  EXPECT_NEAR((p.centre() - Eigen::Vector2d(1, 1)).norm(), 0.0, 1e-12);
}

TEST(SupportPolygon, MarginIsTheDistanceToTheEdge) {
  const SupportPolygon p = square();
  EXPECT_NEAR(p.margin({1.0, 0.25}), 0.25, 1e-12);
  EXPECT_NEAR(p.margin({-1.0, 1.0}), -1.0, 1e-12);
  EXPECT_NEAR(p.margin({3.0, 3.0}), -std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(p.margin({2.0, 1.0}), 0.0, 1e-12);
}

TEST(SupportPolygon, MarginIsContinuousAcrossTheEdge) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    SupportPolygon p;
    for (int i = 0; i < 8; ++i) p.add({value(random), value(random)});
    p.finish();
    const Eigen::Vector2d from(2 * value(random), 2 * value(random)), step(1e-4, 1e-4);
    EXPECT_NEAR(p.margin(from), p.margin(from + step), step.norm() + 1e-12);
  }
}

TEST(SupportPolygon, NothingSupportsNothing) {
  SupportPolygon p;
  p.finish();
  EXPECT_EQ(p.margin({0, 0}), -1.0);
  p.add({0, 0});
  p.add({1, 0});
  p.finish();
  EXPECT_EQ(p.margin({0.5, 0}), -1.0);
}

TEST(SupportPolygon, DoesNotAllocate) {
  NoAlloc no_alloc;
  EXPECT_GT(square().margin({1, 1}), 0.9);
  EXPECT_EQ(no_alloc.count(), 0);
}

}  // namespace
}  // namespace twinbus
