#include "control/walk/rattle_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace twinbus {
namespace {

constexpr double kRattleDt = 0.002;
const Eigen::Vector2d kLargest(60.0, 120.0);

TEST(RattleFilter, WhatSpringsAndIsNoisyPassesAsItIs) {
  RattleFilter filter(kLargest, 0.01);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.05);
  for (int i = 0; i < 5000; ++i) {
    const bool loaded = i % 400 < 300;  // steps
    const double t = kRattleDt * i;
    const Eigen::Vector2d moment(50.0 * std::sin(30.0 * t) + 60.0 * noise(random),
                                 100.0 * std::cos(20.0 * t) + 120.0 * noise(random));
    EXPECT_EQ(filter.update(moment, loaded, kRattleDt), moment);
  }
  EXPECT_LT(filter.rattle(), 0.25);
}

// Ground that damps: the moment follows the rate at which the admittance turned in the last tick.
double moment_left(double gain, bool filtered) {
  RattleFilter filter(kLargest, 0.01);
  const Eigen::Vector2d wanted(0.0, 20.0);
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d seen = filtered ? filter.update(moment, true, kRattleDt) : moment;
    moment = -gain * (seen - wanted);
    moment = moment.cwiseMin(kLargest).cwiseMax(-kLargest);
  }
  return (moment - gain / (1.0 + gain) * wanted).norm();
}

TEST(RattleFilter, WhatDampsMakesTheMomentJumpToAndFroWithoutItAndNotWithIt) {
  EXPECT_GT(moment_left(1.7, false), 20.0);
  EXPECT_LT(moment_left(1.7, true), 0.1);
  EXPECT_LT(moment_left(4.0, true), 0.1);
}

TEST(RattleFilter, StartsAnew) {
  RattleFilter filter(kLargest, 0.01);
  for (int i = 0; i < 200; ++i) (void)filter.update(i % 2 == 0 ? kLargest : Eigen::Vector2d(-kLargest), true, kRattleDt);
  EXPECT_GT(filter.rattle(), 0.4);
  EXPECT_LT(filter.update(kLargest, true, kRattleDt).norm(), kLargest.norm());
  filter.start();
  EXPECT_EQ(filter.update(kLargest, true, kRattleDt), kLargest);
}

}  // namespace
}  // namespace twinbus
