#include "control/trunk_yield.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace twinbus {
namespace {

constexpr double kDt = 0.002;

TEST(TrunkYield, WithoutExcessItStaysUpright) {
  TrunkYield trunk({});
  trunk.start();
  for (int i = 0; i < 1000; ++i) trunk.update(Eigen::Vector2d::Zero(), kDt);
  EXPECT_EQ(trunk.angle().norm(), 0.0);
}

TEST(TrunkYield, BendsForwardForAForwardExcessAndToItsSides) {
  TrunkYield forward({}), left({});
  for (int i = 0; i < 20; ++i) {
    forward.update({0.02, 0.0}, kDt);
    left.update({0.0, 0.02}, kDt);
  }
  EXPECT_GT(forward.angle().y(), 0.0);  // pitch forward
  EXPECT_EQ(forward.angle().x(), 0.0);
  EXPECT_LT(left.angle().x(), 0.0);  // roll to the left
  EXPECT_NEAR(left.angle().x(), -forward.angle().y(), 1e-12);
}

TEST(TrunkYield, SpringsBackWhenTheExcessIsGone) {
  TrunkYield trunk({});
  for (int i = 0; i < 50; ++i) trunk.update({0.03, -0.02}, kDt);
  for (int i = 0; i < 3000; ++i) trunk.update(Eigen::Vector2d::Zero(), kDt);
  EXPECT_LT(trunk.angle().norm(), 1e-3);
  EXPECT_LT(trunk.rate().norm(), 1e-3);
}

TEST(TrunkYield, NeverGoesFarBeyondItsLimitHoweverLargeTheExcess) {
  const TrunkYieldGains gains;
  TrunkYield trunk(gains);
  double most = 0.0;
  for (int i = 0; i < 3000; ++i) {
    trunk.update({5.0, -5.0}, kDt);
    most = std::max(most, trunk.angle().cwiseAbs().maxCoeff());
    ASSERT_LE(trunk.acceleration().cwiseAbs().maxCoeff(), 2.0 * gains.most + 1e-9);
  }
  EXPECT_LT(most, 1.1 * gains.limit);
}

}  // namespace
}  // namespace twinbus
