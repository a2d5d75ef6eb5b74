#include "control/balance/angular_momentum_lean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace twinbus {
namespace {

constexpr double kYieldDt = 0.002;
constexpr double kTrunkHeight = 0.7;
const Eigen::Vector2d kBase(0.05, 0.04), kWaist(0.03, 0.03), kMost(0.3, 0.3);  // [m^2], [rad]

// A trunk that turns as it is asked to.
struct Trunk {
  Trunk() { yield.start(kBase, kWaist, kMost); }
  void run(const Eigen::Vector2d& wanted, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / kYieldDt); ++i) {
      yield.update(wanted, angle, rate, kTrunkHeight, kYieldDt);
      rate += kYieldDt * yield.acceleration();
      angle += kYieldDt * rate;
    }
  }
  TrunkYield yield{TrunkYieldGains{}};
  Eigen::Vector2d angle = Eigen::Vector2d::Zero(), rate = Eigen::Vector2d::Zero();
};

TEST(TrunkYield, WhenNothingIsWantedItStaysUpright) {
  Trunk trunk;
  trunk.run(Eigen::Vector2d::Zero(), 1.0);
  EXPECT_EQ(trunk.angle.norm(), 0.0);
  EXPECT_EQ(trunk.yield.waist().norm(), 0.0);
}

TEST(TrunkYield, GivesTheLeanThatIsWanted) {
  Trunk trunk;
  const Eigen::Vector2d wanted(0.012, -0.008);
  trunk.run(wanted, 3.0);
  EXPECT_NEAR((trunk.yield.lean(trunk.angle, kTrunkHeight) - wanted).norm(), 0.0, 1e-4);
}

TEST(TrunkYield, BendsForwardForALeanForwardAndToItsSides) {
  Trunk forward, left;
  forward.run({0.01, 0.0}, 0.5);
  left.run({0.0, 0.01}, 0.5);
  EXPECT_GT(forward.angle.y(), 0.0);  // pitch forward
  EXPECT_GT(forward.yield.waist().y(), 0.0);
  EXPECT_LT(left.angle.x(), 0.0);  // roll to the left
  EXPECT_LT(left.yield.waist().x(), 0.0);
}

TEST(TrunkYield, ComesBackUprightWhenNothingIsWantedAnyMore) {
  Trunk trunk;
  trunk.run({0.02, -0.02}, 0.5);
  trunk.run(Eigen::Vector2d::Zero(), 5.0);
  EXPECT_LT(trunk.angle.norm(), 1e-3);
  EXPECT_LT(trunk.yield.waist().norm(), 1e-3);
}

TEST(TrunkYield, NeverGoesFarBeyondItsLimitHoweverMuchIsWanted) {
  const TrunkYieldGains gains;
  Trunk trunk;
  for (int i = 0; i < 3000; ++i) {
    trunk.run({5.0, -5.0}, kYieldDt);
    ASSERT_LE(trunk.yield.acceleration().cwiseAbs().maxCoeff(), gains.most + 1e-9);
    ASSERT_LT(trunk.angle.cwiseAbs().maxCoeff(), 1.1 * gains.limit);
    ASSERT_LT(trunk.yield.waist().cwiseAbs().maxCoeff(), 0.31);
  }
}

}  // namespace
}  // namespace twinbus
