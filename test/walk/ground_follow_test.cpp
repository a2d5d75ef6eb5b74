#include "control/walk/ground_follow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace twinbus {
namespace {

constexpr double kDt = 0.002, kRate = 5.0, kGroundStep = 0.03;

TEST(GroundFollow, AStepUpIsTakenSmoothlyAndNeverOvershot) {
  GroundFollow ground(kRate);
  ground.rest(0.0);
  double most = 0.0, fastest = 0.0;
  for (int i = 0; i < 1500; ++i) {
    ground.advance(kGroundStep, kDt);
    most = std::max(most, ground.height());
    fastest = std::max(fastest, std::abs(ground.velocity()));
  }
  EXPECT_NEAR(ground.height(), kGroundStep, 1e-4);
  EXPECT_LE(most, kGroundStep + 1e-9);
  EXPECT_LT(fastest, kRate * kGroundStep / std::exp(1.0) * 1.02) << "w h / e, the exact solution's";
}

TEST(GroundFollow, AtRestNothingMoves) {
  GroundFollow ground(kRate);
  ground.rest(0.2);
  ground.advance(0.2, kDt);
  EXPECT_EQ(ground.height(), 0.2);
  EXPECT_EQ(ground.acceleration(), 0.0);
}

}  // namespace
}  // namespace twinbus
