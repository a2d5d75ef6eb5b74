#include "control/loop/arm_follow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr double kArmDt = 0.002;

// One arm joint from 0 to 0.4 rad in 2 s, in three pieces.
struct ArmFollowRig {
  const Model& model = test::hrp1s();
  Posture posture{model};
  ArmFollow follow{model};
  int joint = model.hands[0].joints.front();
  int bus = -1;
  std::vector<ArmPathPiece> pieces;

  ArmFollowRig() {
    for (int k = 0; k < model.bus_count(); ++k) {
      if (model.bus_joints[static_cast<std::size_t>(k)] == joint) bus = k;
    }
    PerJoint<double> q{};
    posture.rest(q);
    pieces = path(1, posture.q(bus));
  }
  double way(double t) const { return 0.4 * (3.0 * t * t - 2.0 * t * t * t); }
  std::vector<ArmPathPiece> path(std::int64_t id, double from) const {
    std::vector<ArmPathPiece> all(3);
    for (int p = 0; p < 3; ++p) {
      ArmPathPiece& piece = all[static_cast<std::size_t>(p)];
      piece.path_id = id;
      piece.pieces = 3;
      piece.piece = static_cast<std::int16_t>(p);
      piece.joint_count = 1;
      piece.joint[0] = static_cast<std::int16_t>(joint);
      piece.knot_count = kKnotsPerPiece;
      for (int k = 0; k < kKnotsPerPiece; ++k) {
        const double s = (p * kKnotsPerPiece + k) / (3.0 * kKnotsPerPiece - 1.0);
        piece.time[static_cast<std::size_t>(k)] = 2.0 * s;
        piece.q[static_cast<std::size_t>(k)][0] = from + way(s);
        piece.qd[static_cast<std::size_t>(k)][0] =
            static_cast<float>(0.4 * (6.0 * s - 6.0 * s * s) / 2.0);
      }
    }
    return all;
  }
  void hear() {
    for (const ArmPathPiece& piece : pieces) follow.add(piece);
  }
  void tick(std::int64_t mask = 0) {
    posture.advance(kArmDt);
    follow.update(posture, mask, kArmDt);
  }
  std::int64_t bit() const { return std::int64_t{1} << bus; }
};

TEST(ArmFollow, FollowsAWholePathToItsEndSmoothly) {
  ArmFollowRig f;
  f.hear();
  const double begin = f.posture.q(f.bus);
  double last = begin, speed = 0.0;
  for (int i = 0; i < 1400; ++i) {
    f.tick();
    const double now = (f.posture.q(f.bus) - last) / kArmDt;
    ASSERT_LT(std::abs(now - speed), 0.02) << i;
    ASSERT_NEAR(f.posture.qd(f.bus), now, 0.02) << i;
    speed = now;
    last = f.posture.q(f.bus);
  }
  EXPECT_NEAR(last, begin + 0.4, 1e-9);
  EXPECT_EQ(f.follow.state(), ArmState::kDone);
  EXPECT_EQ(f.follow.take_refusal(), nullptr);
}

TEST(ArmFollow, PiecesMayComeInAnyOrderAndTwice) {
  ArmFollowRig f;
  for (int i : {2, 0, 2, 1, 1}) f.follow.add(f.pieces[static_cast<std::size_t>(i)]);
  f.tick();
  EXPECT_EQ(f.follow.state(), ArmState::kFollowing);
  EXPECT_EQ(f.follow.path_id(), 1);
}

TEST(ArmFollow, AnIncompletePathNeverStarts) {
  ArmFollowRig f;
  f.follow.add(f.pieces[0]);
  f.follow.add(f.pieces[2]);
  for (int i = 0; i < 500; ++i) f.tick();
  EXPECT_EQ(f.follow.state(), ArmState::kNone);
}

TEST(ArmFollow, APathThatMakesNoSenseIsRefusedWithAReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto spoil = [&](int how, ArmPathPiece& p) {
    switch (how) {
      case 0:
        p.q[2][0] = nan;
        break;
      case 1:
        p.q[2][0] = 50.0;
        break;
      case 2:
        p.qd[2][0] = 1000.0F;
        break;
      case 3:
        p.time[2] = -1.0;
        break;
      case 4:
        p.time[2] = p.time[1];
        break;
      case 5:
        p.knot_count = 99;
        break;
      case 6:
        p.joint[0] = 10000;
        break;
      case 7:
        p.joint[0] = -1;
        break;
      default:
        p.joint[0] = static_cast<std::int16_t>(test::hrp1s().leg_joints.front());
        break;
    }
  };
  for (int how = 0; how < 9; ++how) {
    ArmFollowRig f;
    for (ArmPathPiece& piece : f.pieces) {
      if (how >= 6 || piece.piece == 1) spoil(how, piece);
    }
    f.hear();
    for (int i = 0; i < 100; ++i) f.tick();
    EXPECT_EQ(f.follow.state(), ArmState::kNone) << how;
    EXPECT_NE(f.follow.take_refusal(), nullptr) << how;
    // The next good path is followed.
    f.pieces = f.path(2, f.posture.q(f.bus));
    f.hear();
    f.tick();
    EXPECT_EQ(f.follow.state(), ArmState::kFollowing) << how;
  }
}

TEST(ArmFollow, APathThatBeginsElsewhereIsRefused) {
  ArmFollowRig f;
  f.pieces = f.path(1, f.posture.q(f.bus) + 0.2);
  f.hear();
  const double before = f.posture.q(f.bus);
  for (int i = 0; i < 100; ++i) f.tick();
  EXPECT_EQ(f.posture.q(f.bus), before);
  EXPECT_NE(f.follow.take_refusal(), nullptr);
  EXPECT_EQ(f.follow.take_refusal(), nullptr) << "said once";
  // The next one has its own reason, though it is the same; one that was told of is not told of again.
  f.pieces = f.path(2, f.posture.q(f.bus) + 0.2);
  f.hear();
  f.tick();
  EXPECT_NE(f.follow.take_refusal(), nullptr);
  f.hear();
  f.tick();
  EXPECT_EQ(f.follow.take_refusal(), nullptr);
}

TEST(ArmFollow, TheGuardStopsTheArmOnItsPathAndLetsItGoOnLater) {
  ArmFollowRig f;
  f.hear();
  for (int i = 0; i < 500; ++i) f.tick();
  for (int i = 0; i < 200; ++i) f.tick(f.bit());
  EXPECT_EQ(f.follow.state(), ArmState::kStoppedByGuard);
  const double stopped = f.posture.q(f.bus);
  for (int i = 0; i < 100; ++i) f.tick(f.bit());
  EXPECT_EQ(f.posture.q(f.bus), stopped);
  for (int i = 0; i < 2000; ++i) f.tick();
  EXPECT_EQ(f.follow.state(), ArmState::kDone);
}

TEST(ArmFollow, APathBlockedAgainAndAgainIsGivenUp) {
  ArmFollowRig f;
  f.hear();
  for (int block = 0; block < 5; ++block) {
    for (int i = 0; i < 350; ++i) f.tick();
    f.tick(f.bit());
  }
  for (int i = 0; i < 1000; ++i) f.tick();
  EXPECT_EQ(f.follow.state(), ArmState::kStoppedByGuard);
  EXPECT_FALSE(f.follow.moving());
}

TEST(ArmFollow, ACancelEndsOnThePathWithoutAJerk) {
  ArmFollowRig f;
  f.hear();
  for (int i = 0; i < 500; ++i) f.tick();
  f.follow.cancel();
  double last = f.posture.q(f.bus), speed = f.posture.qd(f.bus);
  for (int i = 0; i < 300; ++i) {
    f.tick();
    const double now = (f.posture.q(f.bus) - last) / kArmDt;
    ASSERT_LT(std::abs(now - speed), 0.03);
    speed = now;
    last = f.posture.q(f.bus);
  }
  EXPECT_EQ(f.follow.state(), ArmState::kNone);
  EXPECT_EQ(f.posture.qd(f.bus), 0.0);
}

TEST(ArmFollow, ADroppedPathMovesNothingFromThatTickOn) {
  ArmFollowRig f;
  f.hear();
  for (int i = 0; i < 500; ++i) f.tick();
  f.follow.drop();
  const double before = f.posture.q(f.bus);
  f.tick();
  EXPECT_EQ(f.posture.q(f.bus), before);
}

TEST(ArmFollow, APathIsFollowedOnceThoughItIsHeardAgain) {
  ArmFollowRig f;
  f.hear();
  for (int i = 0; i < 2000; ++i) f.tick();
  ASSERT_EQ(f.follow.state(), ArmState::kDone);
  const double end = f.posture.q(f.bus);
  // Back where it began, so that nothing but its number keeps the old path from being followed.
  PerJoint<double> q{};
  f.posture.rest(q);
  f.hear();
  for (int i = 0; i < 500; ++i) f.tick();
  EXPECT_EQ(f.follow.path_id(), 0);
  EXPECT_NE(f.posture.q(f.bus), end);
  f.pieces = f.path(2, f.posture.q(f.bus));
  f.hear();
  for (int i = 0; i < 500; ++i) f.tick();
  EXPECT_EQ(f.follow.path_id(), 2);
  // Nor is one that was refused or cancelled followed later.
  f.follow.drop();
  f.pieces = f.path(3, f.posture.q(f.bus));
  f.follow.refuse(f.pieces[0], "no");
  f.hear();
  f.tick();
  EXPECT_EQ(f.follow.path_id(), 0);
}

}  // namespace
}  // namespace twinbus
