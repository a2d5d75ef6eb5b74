#include "control/joint/posture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

const Joint& joint(int k) {
  const Model& model = test::hrp1s();
  return model.joints[static_cast<std::size_t>(model.bus_joints[static_cast<std::size_t>(k)])];
}

TEST(Posture, RestsInsideTheLimitsWhateverItIsGiven) {
  Posture posture(test::hrp1s());
  PerJoint<double> q{};
  q.fill(100.0);
  posture.rest(q);
  for (int k = 0; k < test::hrp1s().bus_count(); ++k)
    EXPECT_DOUBLE_EQ(posture.q(k), joint(k).upper);
}

TEST(Posture, AMoveTakesItsDurationButIsNeverFasterThanTheJoints) {
  const int k = test::hrp1s().bus_count() - 1;
  for (const double duration : {3.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
    Posture posture(test::hrp1s());
    posture.rest({});
    PerJoint<double> q{};
    q[static_cast<std::size_t>(k)] = 0.9 * joint(k).upper;
    posture.move(q, std::int64_t{1} << k, duration);
    double fastest = 0.0;
    for (int i = 0; i < 5000 && posture.moving(); ++i) {
      posture.advance(0.002);
      fastest = std::max(fastest, std::abs(posture.qd(k)));
    }
    EXPECT_FALSE(posture.moving());
    EXPECT_NEAR(posture.q(k), 0.9 * joint(k).upper, 1e-12);
    EXPECT_LE(fastest, joint(k).velocity) << duration;
    EXPECT_GT(fastest, 0.0);
  }
}

TEST(Posture, JointsOutsideTheMaskStay) {
  Posture posture(test::hrp1s());
  posture.rest({});
  const double before = posture.q(1);
  PerJoint<double> q{};
  q.fill(0.2);
  posture.move(q, 1, 1.0);
  for (int i = 0; i < 600; ++i) posture.advance(0.002);
  EXPECT_EQ(posture.q(1), before);
}

// Held half way it stays with its joint, goes on when it is let go, and is given up where that happens again and again.
TEST(Posture, AJointThatIsHeldOnItsWayWaitsThereAndGoesOnUntilItIsHeldThrice) {
  Posture posture(test::hrp1s());
  posture.rest({});
  const int k = test::hrp1s().bus_count() - 1;
  const auto i = static_cast<std::size_t>(k);
  const std::int64_t mask = std::int64_t{1} << k;
  PerJoint<double> q{}, held{};
  q[i] = 0.5 * joint(k).upper;
  posture.move(q, mask, 2.0);
  const auto go = [&](double seconds, std::int64_t by) {
    for (int n = 0; n < static_cast<int>(seconds / 0.002); ++n) {
      posture.advance(0.002);
      posture.yield(by, held, {}, 0.002);
    }
  };
  for (int block = 1; block <= 3; ++block) {
    go(block == 1 ? 0.5 : 0.06, 0);
    held[i] = posture.q(k) - 0.01;  // braked behind it
    go(1.0, mask);
    EXPECT_EQ(posture.q(k), held[i]);
    EXPECT_EQ(posture.qd(k), 0.0);
    const Posture::Held told = posture.take_held();
    EXPECT_EQ(told.waits, block < 3 ? mask : 0) << block;
    EXPECT_EQ(told.given_up, block < 3 ? 0 : mask) << block;
    EXPECT_EQ(posture.waits(mask), block < 3) << block;
    go(0.4, 0);
    EXPECT_EQ(posture.q(k), held[i]) << "not at once";
    go(0.1, 0);
    EXPECT_EQ(posture.moving(), block < 3) << block;
  }
  EXPECT_TRUE(posture.gave_up(mask));
  // Held as it is, a new way leads on for a moment, so that a guard can see where to.
  q[i] = 0.0;
  posture.move(q, mask, 0.5);
  go(0.04, mask);
  EXPECT_LT(posture.q(k), held[i]);
  go(0.1, 0);
  EXPECT_LT(posture.q(k), held[i]);
  go(3.0, 0);
  EXPECT_NEAR(posture.q(k), 0.0, 1e-12);
  EXPECT_FALSE(posture.gave_up(mask));
}

TEST(Posture, OneThatIsLetGoWhileItIsFastComesToRestFirst) {
  Posture posture(test::hrp1s());
  const int k = test::hrp1s().bus_count() - 1;
  const auto i = static_cast<std::size_t>(k);
  PerJoint<double> q{}, qd{};
  qd[i] = 0.5 * joint(k).velocity;
  posture.rest(q);
  posture.yield(std::int64_t{1} << k, q, qd, 0.002);
  EXPECT_EQ(posture.qd(k), qd[i]);
  posture.advance(0.002);
  posture.yield(0, q, qd, 0.002);
  EXPECT_NEAR(posture.qd(k), qd[i], 0.05 * qd[i]);
  for (int n = 0; n < 200; ++n) {
    posture.advance(0.002);
    posture.yield(0, q, qd, 0.002);
  }
  EXPECT_EQ(posture.qd(k), 0.0);
  EXPECT_GT(posture.q(k), 0.0);
}

// A look that a guard had no time for holds everything for a tick: what comes far in between is not given up.
TEST(Posture, OneThatGoesOnBetweenHoldsArrives) {
  Posture posture(test::hrp1s());
  posture.rest({});
  const int k = test::hrp1s().bus_count() - 1;
  const auto i = static_cast<std::size_t>(k);
  const std::int64_t mask = std::int64_t{1} << k;
  PerJoint<double> q{}, last{}, rate{};
  q[i] = 0.9 * joint(k).upper;
  ASSERT_GT(q[i], 0.5);
  posture.move(q, mask, 2.0);
  int holds = 0;
  for (int n = 0; n < 10000 && std::abs(posture.q(k) - q[i]) > 1e-9; ++n) {
    last[i] = posture.q(k);
    rate[i] = posture.qd(k);
    posture.advance(0.002);
    const bool held = n % 450 == 400 && posture.moving();
    holds += held ? 1 : 0;
    posture.yield(held ? mask : 0, last, rate, 0.002);
    ASSERT_FALSE(posture.gave_up(mask)) << holds;
  }
  EXPECT_NEAR(posture.q(k), q[i], 1e-9);
  EXPECT_GE(holds, 3);
}

// What was fast when it was held leaves nothing behind where the posture begins anew, and a way that begins meanwhile begins as fast.
TEST(Posture, WhatWasBrakedIsForgottenWhenItRestsAndGoesOnWhenItMoves) {
  const int k = test::hrp1s().bus_count() - 1;
  const auto i = static_cast<std::size_t>(k);
  const std::int64_t mask = std::int64_t{1} << k;
  PerJoint<double> q{}, qd{};
  qd[i] = 0.5 * joint(k).velocity;
  const auto held_fast = [&] {
    Posture posture(test::hrp1s());
    posture.rest(q);
    posture.yield(mask, q, qd, 0.002);
    return posture;
  };
  Posture rests = held_fast();
  EXPECT_TRUE(rests.moving()) << "it is being braked";
  rests.rest(q);
  rests.advance(0.002);
  rests.yield(0, q, qd, 0.002);
  EXPECT_EQ(rests.qd(k), 0.0);
  EXPECT_FALSE(rests.moving());
  Posture moves = held_fast();
  PerJoint<double> to{};
  to[i] = -0.3;
  moves.move(to, mask, 1.0);
  moves.advance(1e-4);
  EXPECT_NEAR(moves.qd(k), qd[i], 0.01 * qd[i]) << "no jump of velocity";
  for (int n = 0; n < 1000; ++n) {
    moves.advance(0.002);
    moves.yield(0, q, qd, 0.002);
  }
  EXPECT_NEAR(moves.q(k), -0.3, 1e-9) << "and comes there";
}

TEST(Posture, ABrakeBeginsWithTheVelocityAndEndsAtRest) {
  Posture posture(test::hrp1s());
  PerJoint<double> q{}, qd{};
  const int k = test::hrp1s().bus_count() - 1;
  qd[static_cast<std::size_t>(k)] = 0.5;
  posture.brake(q, qd, 0.3);
  EXPECT_DOUBLE_EQ(posture.qd(k), 0.5);
  for (int i = 0; i < 160; ++i) posture.advance(0.002);
  EXPECT_EQ(posture.qd(k), 0.0);
  EXPECT_NEAR(posture.q(k), 0.075, 1e-9);
}

TEST(Posture, AJointMovedByAPathKeepsThePathsVelocityForThatTick) {
  Posture posture(test::hrp1s());
  posture.rest({});
  posture.advance(0.002);
  const int k = test::hrp1s().bus_count() - 1;
  posture.set(k, 0.1, 0.7);
  EXPECT_DOUBLE_EQ(posture.q(k), 0.1);
  EXPECT_DOUBLE_EQ(posture.qd(k), 0.7);
  posture.advance(0.002);
  EXPECT_EQ(posture.qd(k), 0.0);
}

}  // namespace
}  // namespace twinbus
