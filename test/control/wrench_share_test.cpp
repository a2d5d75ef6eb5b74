#include "control/legs/wrench_share.h"

#include <gtest/gtest.h>

#include <cmath>

namespace twinbus {
namespace {

std::array<SoleOnGround, 2> turned_stance(double yaw = 0.0) {
  std::array<SoleOnGround, 2> soles;
  for (std::size_t s = 0; s < 2; ++s) {
    soles[s].position = {0.0, s == 0 ? 0.1 : -0.1};
    soles[s].yaw = s == 0 ? yaw : -yaw;
    soles[s].front = 0.15;
    soles[s].back = 0.10;
    soles[s].left = soles[s].right = 0.06;
  }
  return soles;
}

// The moment of both loads about the ground origin is that of the whole weight at the ZMP.
TEST(WrenchShare, TwoFeetTogetherGiveTheZmpAsked) {
  const auto soles = turned_stance(0.3);
  for (double x : {-0.04, 0.0, 0.06}) {
    for (double y : {-0.07, 0.0, 0.05}) {
      const ZmpShare share = share_zmp(soles, {x, y}, 0.01, 0.05);
      Eigen::Vector2d zmp = Eigen::Vector2d::Zero();
      for (std::size_t s = 0; s < 2; ++s) {
        const double load = s == 0 ? share.left : 1.0 - share.left;
        zmp += load * (soles[s].position + soles[s].turn(share.cop[s]));
      }
      EXPECT_NEAR((zmp - share.zmp).norm(), 0.0, 1e-12);
      EXPECT_NEAR((zmp - Eigen::Vector2d(x, y)).norm(), 0.0, 1e-9) << x << " " << y;
    }
  }
}

TEST(WrenchShare, StandingInTheMiddleLoadsBothFeetAlike) {
  const auto soles = turned_stance();
  const ZmpShare share = share_zmp(soles, 0.5 * (soles[0].centre() + soles[1].centre()), 0.0, 0.0);
  EXPECT_DOUBLE_EQ(share.left, 0.5);
}

TEST(WrenchShare, OverOneFootThatFootCarriesAllButTheLeast) {
  const auto soles = turned_stance();
  EXPECT_DOUBLE_EQ(share_zmp(soles, soles[0].centre(), 0.0, 0.06).left, 0.94);
  EXPECT_DOUBLE_EQ(share_zmp(soles, soles[1].centre(), 0.0, 0.06).left, 0.06);
}

TEST(WrenchShare, NoCentreOfPressureComesNearerToAnEdgeThanTheMargin) {
  const double margin = 0.015;
  for (double yaw : {0.0, 0.4}) {
    const auto soles = turned_stance(yaw);
    for (int k = 0; k < 64; ++k) {
      const double angle = 0.0981747704 * k;
      const ZmpShare share =
          share_zmp(soles, {0.5 * std::cos(angle), 0.5 * std::sin(angle)}, margin, 0.05);
      for (std::size_t s = 0; s < 2; ++s) {
        EXPECT_LE(share.cop[s].x(), soles[s].front - margin + 1e-12);
        EXPECT_GE(share.cop[s].x(), -soles[s].back + margin - 1e-12);
        EXPECT_LE(std::abs(share.cop[s].y()), 0.06 - margin + 1e-12);
      }
      EXPECT_GE(share.left, 0.05);
      EXPECT_LE(share.left, 0.95);
    }
  }
}

TEST(WrenchShare, MirroredFeetGiveTheMirroredShare) {
  const auto soles = turned_stance(0.2);
  const ZmpShare a = share_zmp(soles, {0.03, 0.04}, 0.01, 0.05);
  const ZmpShare b = share_zmp(soles, {0.03, -0.04}, 0.01, 0.05);
  EXPECT_NEAR(a.left, 1.0 - b.left, 1e-12);
  EXPECT_NEAR(a.cop[0].x(), b.cop[1].x(), 1e-12);
  EXPECT_NEAR(a.cop[0].y(), -b.cop[1].y(), 1e-12);
}

TEST(SoleOnGround, UnturnIsTheInverseOfTurn) {
  SoleOnGround sole;
  sole.yaw = 0.7;
  const Eigen::Vector2d v(0.3, -0.2);
  EXPECT_NEAR((sole.unturn(sole.turn(v)) - v).norm(), 0.0, 1e-15);
}

}  // namespace
}  // namespace twinbus
