#include "control/walk/footsteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "control/legs/leg_reach.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "control/walk/listed_steps.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

Gait gait() { return gait_of(test::hrp1s(), test::hrp1s().walking, 0.01); }

// Where the middle between the feet has gone in so many steps: x, y, heading.
Eigen::Vector3d walked(const Gait& g, const Eigen::Vector3d& velocity, int steps) {
  Foothold at[2];
  at[0].position << 0.0, 0.5 * g.width;
  at[1].position << 0.0, -0.5 * g.width;
  for (int n = 0; n < steps; ++n) {
    const int stands = n % 2;
    at[1 - stands] = next_foothold(at[stands], stands, velocity, g.period(), g.width);
  }
  const Eigen::Vector2d middle = 0.5 * (at[0].position + at[1].position);
  return {middle.x(), middle.y(), 0.5 * (at[0].yaw() + at[1].yaw())};
}

TEST(Footsteps, WithoutVelocityTheFeetStayWhereTheyAre) {
  EXPECT_LT(walked(gait(), Eigen::Vector3d::Zero(), 10).norm(), 1e-12);
}

TEST(Footsteps, TheMiddleBetweenTheFeetMovesAtTheVelocity) {
  const Gait g = gait();
  const auto gone = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d((walked(g, v, 24) - walked(g, v, 4)) / (20.0 * g.period()));
  };
  EXPECT_NEAR(gone({0.4, 0.0, 0.0}).x(), 0.4, 1e-9);
  EXPECT_NEAR(gone({-0.3, 0.0, 0.0}).x(), -0.3, 1e-9);
  EXPECT_NEAR(gone({0.0, 0.1, 0.0}).y(), 0.1, 1e-9);
  EXPECT_NEAR(gone({0.0, -0.1, 0.0}).y(), -0.1, 1e-9);
  EXPECT_NEAR(gone({0.0, 0.0, 0.2}).z(), 0.2, 1e-9);
}

TEST(Footsteps, NarrowSolesAreAskedToStepAsideAndTurnSlower) {
  Model narrow = test::hrp1s();
  for (Sole& sole : narrow.soles) sole.left = sole.right = 0.035;
  const Gait slow = gait_of(narrow, narrow.walking, 0.01), usual = gait();
  EXPECT_NEAR(slow.most_velocity.z(), usual.most_velocity.z() * 0.07 / 0.13, 1e-9);
  EXPECT_LT(slow.acceleration.y(), 0.8 * usual.acceleration.y());
  EXPECT_GT(slow.most_velocity.x(), 0.9 * usual.most_velocity.x());
}

// What a narrow sole lacks to hold the robot where it bears on its rim, steps hold that have room inwards.
TEST(Footsteps, NarrowSolesStandWiderOnRoughGround) {
  Model narrow = test::hrp1s();
  for (Sole& sole : narrow.soles) sole.left = sole.right = 0.035;
  const Gait g = gait_of(narrow, narrow.walking, 0.01);
  EXPECT_GT(g.rough_wider, 0.04);
  EXPECT_LE(g.width + g.rough_wider, g.max_width);
  EXPECT_EQ(gait().rough_wider, 0.0);
}

TEST(Footsteps, SolesNeverComeNearerThanTheyMay) {
  const Gait g = gait();
  for (const double vy : {-0.2, 0.0, 0.2}) {
    for (const double wz : {-0.5, 0.0, 0.5}) {
      Foothold at[2];
      at[0].position << 0.0, 0.5 * g.width;
      at[1].position << 0.0, -0.5 * g.width;
      for (int n = 0; n < 12; ++n) {
        const int stands = n % 2;
        at[1 - stands] = next_foothold(at[stands], stands, {0.1, vy, wz}, g.period(), g.width);
        const Eigen::Vector2d between =
            at[stands].unturn(at[1 - stands].position - at[stands].position);
        EXPECT_GT(side_of(1 - stands) * between.y(), g.min_width - 0.01);
      }
    }
  }
}

// In curves too: striding, stepping aside and turning at once, neither sole lies before, behind or beside the other, nor comes
// there on its way.
TEST(Footsteps, SolesKeepOutOfEachOthersWayInCurves) {
  const Gait g = gait();
  const double gap = g.min_width - 2.0 * g.inner;
  EXPECT_NEAR(gap, 0.035, 1e-9);
  int moved = 0;
  for (const double vx : {-0.3, 0.0, 0.2, 0.4, 0.55}) {
    for (const double vy : {-0.15, 0.0, 0.1}) {
      for (const double wz : {-0.8, -0.3, 0.0, 0.5}) {
        const Eigen::Vector3d v = g.possible({vx, vy, wz});
        const double width = g.turning_width(v.z() * g.period());
        Foothold at[2];
        at[0].position << 0.0, 0.5 * width;
        at[1].position << 0.0, -0.5 * width;
        for (int n = 0; n < 12; ++n) {
          const int stands = n % 2, moves = 1 - stands;
          const double out = side_of(moves);
          const Foothold from = at[moves], stand = at[stands];
          const Foothold plain = next_foothold(stand, stands, v, g.period(), width);
          const Foothold to = kept_apart(g, stand, stands, plain);
          EXPECT_LE(out * stand.unturn(to.position - stand.position).y(), g.max_width + 1e-9);
          moved += (to.position - plain.position).norm() > 1e-3 ? 1 : 0;
          for (const double x : {-g.heel, g.toe}) {
            // The one that stands, seen from where the other lands: the next step leads it past there.
            const Eigen::Vector2d corner = stand.position + stand.turn({x, out * g.inner});
            EXPECT_GT(-out * to.unturn(corner - to.position).y(), g.inner + gap - 1e-6) << vx << ' ' << vy << ' ' << wz;
            for (double s = n == 0 ? 1.0 : 0.0; s <= 1.0; s += 0.125) {
              Foothold way = from;
              way.position += s * (to.position - from.position);
              way.set_yaw(from.yaw() + s * std::remainder(to.yaw() - from.yaw(), 2.0 * M_PI));
              const Eigen::Vector2d edge = way.position + way.turn({x, -out * g.inner});
              EXPECT_GT(out * stand.unturn(edge - stand.position).y(), g.inner + 0.7 * gap)
                  << vx << ' ' << vy << ' ' << wz << " at " << s;
            }
          }
          at[moves] = to;
        }
      }
    }
  }
  EXPECT_GT(moved, 50);
}

// The corners of both soles, seen across the way they stand: 35 mm apart however fast they turn.
TEST(Footsteps, SolesThatTurnKeepHeelsAndToesApart) {
  const Gait g = gait();
  const double inner = 0.5 * (g.min_width - 0.035);
  EXPECT_EQ(g.turning_width(0.0), g.width);
  for (const double wz : {-1.0, -0.7, 0.3, 0.85}) {
    const double width = g.turning_width(wz * g.period());
    ASSERT_LT(width, g.max_width);
    Foothold at[2];
    at[0].position << 0.0, 0.5 * width;
    at[1].position << 0.0, -0.5 * width;
    for (int n = 0; n < 12; ++n) {
      const int stands = n % 2;
      at[1 - stands] = next_foothold(at[stands], stands, {0.0, 0.0, wz}, g.period(), width);
      Foothold middle;
      middle.set_yaw(at[0].yaw() + 0.5 * std::remainder(at[1].yaw() - at[0].yaw(), 2.0 * M_PI));
      double left = 1e9, right = -1e9;
      for (const double x : {g.toe, -g.heel}) {
        left = std::min(left, middle.unturn(at[0].position + at[0].turn({x, -inner})).y());
        right = std::max(right, middle.unturn(at[1].position + at[1].turn({x, inner})).y());
      }
      EXPECT_GT(left - right, 0.0349) << wz << ' ' << n;
    }
  }
}

TEST(Footsteps, WhatIsAskedIsCutToWhatTheLegsReach) {
  const Gait g = gait();
  const Eigen::Vector3d fast = g.possible({5.0, 0.0, 0.0});
  EXPECT_NEAR(fast.x(), g.most_velocity.x(), 1e-12);
  EXPECT_LT(fast.x() * g.period(), g.max_forward);
  const Eigen::Vector3d slow(0.1, 0.02, 0.05);
  EXPECT_EQ(g.possible(slow), slow);
  EXPECT_LE(g.possible({-5.0, 0.0, 0.0}).norm(), g.max_back / g.period());
  EXPECT_EQ(g.possible({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}),
            Eigen::Vector3d::Zero());
}

TEST(Footsteps, ALowerRobotMakesLongerSteps) {
  Walking low = test::hrp1s().walking, high = low;
  low.com_height = 0.64;
  high.com_height = 0.72;
  EXPECT_GT(gait_of(test::hrp1s(), low, 0.01).max_forward,
            gait_of(test::hrp1s(), high, 0.01).max_forward);
}

TEST(Footsteps, ARobotOfWeakKneesWalksOnStraighterLegs) {
  Model weak = test::hrp1s();
  Walking unsaid = weak.walking;
  unsaid.com_height = 0.0;
  const double bent = gait_of(weak, unsaid, 0.01).com_height;
  for (int foot = 0; foot < 2; ++foot)
    weak.joints[static_cast<std::size_t>(leg_reach(weak, foot).knee)].effort = 170.0;
  EXPECT_GT(gait_of(weak, unsaid, 0.01).com_height, bent + 0.02);
}

// The torque that holds the zero-moment point ahead of the ankle is the weight times its lever.
TEST(Footsteps, ARobotOfWeakAnklesKeepsTheZmpNearThem) {
  Model weak = test::hrp1s();
  Walking unsaid;
  EXPECT_NEAR(gait_of(weak, unsaid, 0.01).zmp_forward, 0.03, 1e-12);
  const double weight = weak.total_mass() * kGravity;
  weak.joints[static_cast<std::size_t>(weak.find_joint("LLEG_ANKLE_R"))].effort = 1.0;  // it rolls the foot
  EXPECT_NEAR(gait_of(weak, unsaid, 0.01).zmp_forward, 0.03, 1e-12);
  weak.joints[static_cast<std::size_t>(weak.find_joint("RLEG_ANKLE_P"))].effort = 0.02 * weight;
  EXPECT_NEAR(gait_of(weak, unsaid, 0.01).zmp_forward, 0.35 * 0.02, 1e-9);
  unsaid.zmp_forward = 0.02;  // said: as it is
  EXPECT_EQ(gait_of(weak, unsaid, 0.01).zmp_forward, 0.02);
}

TEST(Footsteps, AGaitThatTheLegsCannotDoIsRefusedWithItsReason) {
  Walking w = test::hrp1s().walking;
  w.com_height = 1.5;
  EXPECT_THROW((void)gait_of(test::hrp1s(), w, 0.01), std::runtime_error);
  w = test::hrp1s().walking;
  w.width = 0.05;
  EXPECT_THROW((void)gait_of(test::hrp1s(), w, 0.01), std::runtime_error);
}

TEST(LegReach, FindsTheKneeAndTheLengthOfTheStraightLeg) {
  const Model& model = test::hrp1s();
  for (int foot = 0; foot < 2; ++foot) {
    const LegReach reach = leg_reach(model, foot);
    EXPECT_NE(model.joints[static_cast<std::size_t>(reach.knee)].name.find("KNEE"),
              std::string::npos);
    EXPECT_NEAR(reach.longest, 0.3535 + 0.30, 1e-4);
    EXPECT_NEAR(reach.straight, 0.0, 0.01);
    EXPECT_EQ(reach.bends, 1.0);
    EXPECT_NEAR(reach.hip_width, 0.18, 1e-9);
    EXPECT_NEAR(reach.ankle_height, 0.07, 1e-3);
    Model weak = model;
    weak.joints[static_cast<std::size_t>(weak.find_joint(foot == 0 ? "LLEG_HIP_P" : "RLEG_HIP_P"))].effort *= 0.5;
    EXPECT_NEAR(leg_reach(weak, foot).swing.x(), 0.5 * reach.swing.x(), 1e-9);
    EXPECT_EQ(leg_reach(weak, foot).swing.y(), reach.swing.y());
  }
}

StepList one_step(FootSide foot, double x, double y, double yaw) {
  StepList list;
  list.first_foot = foot;
  list.count = 1;
  list.x[0] = static_cast<float>(x);
  list.y[0] = static_cast<float>(y);
  list.yaw[0] = static_cast<float>(yaw);
  return list;
}

// Whatever a velocity within the limits leads to is within the limits of a list too.
TEST(ListedSteps, StepsOfAPossibleVelocityArePossible) {
  const Gait g = gait();
  for (const Eigen::Vector3d& share :
       {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0),
        Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1),
        Eigen::Vector3d(0.5, 0.3, 0.2)}) {
    const Eigen::Vector3d v = g.possible(share.cwiseProduct(g.most_velocity));
    for (int stands = 0; stands < 2; ++stands) {
      const Foothold next =
          next_foothold({}, stands, v, g.period(), g.turning_width(v.z() * g.period()));
      const StepList list = one_step(stands == 0 ? FootSide::kRight : FootSide::kLeft,
                                     next.position.x(), next.position.y(), next.yaw());
      const StepRefusal refusal = check_steps(g, list);
      EXPECT_EQ(refusal.why, nullptr) << refusal.why << " " << share.transpose();
    }
  }
}

TEST(ListedSteps, ReachTurnAndOverlapAreRefusedOnBothSides) {
  const Gait g = gait();
  for (const double side : {1.0, -1.0}) {
    const FootSide foot = side > 0.0 ? FootSide::kLeft : FootSide::kRight;
    const auto why = [&](double x, double y, double yaw) {
      const StepRefusal refusal = check_steps(g, one_step(foot, x, side * y, side * yaw));
      return std::string(refusal.why != nullptr ? refusal.why : "");
    };
    EXPECT_EQ(why(0.2, 0.2, 0.0), "");
    EXPECT_NE(why(g.max_forward + 0.01, 0.2, 0.0).find("legs reach"), std::string::npos);
    EXPECT_NE(why(-g.max_back - 0.01, 0.2, 0.0).find("legs reach"), std::string::npos);
    EXPECT_NE(why(0.0, g.max_width + 0.01, 0.0).find("legs reach"), std::string::npos);
    EXPECT_NE(why(0.8 * g.max_forward, g.max_width - 0.01, 0.0).find("legs reach"),
              std::string::npos);
    EXPECT_NE(why(0.1, -0.2, 0.0).find("on the other"), std::string::npos) << "crossed";
    EXPECT_NE(why(0.0, g.min_width - 0.005, 0.0).find("on the other"), std::string::npos);
    EXPECT_NE(why(0.0, 0.2, -0.4).find("on the other"), std::string::npos) << "toes closed";
    EXPECT_NE(why(0.0, 0.3, g.max_turn + 0.01).find("hips"), std::string::npos);
  }
}

TEST(ListedSteps, EachIsInTheFrameOfTheFootThatStandsThen) {
  StepList list;
  list.first_foot = FootSide::kLeft;
  list.count = 2;
  list.x = {0.2F, 0.1F};
  list.y = {0.2F, -0.2F};
  list.yaw = {1.0F, 0.0F};
  std::array<Foothold, 2> feet;
  feet[1].position << 1.0, 2.0;
  feet[1].set_yaw(1.5707963);
  std::array<Foothold, kMostSteps> places;
  ASSERT_EQ(place_steps(list, feet, places), 2);
  EXPECT_LT((places[0].position - Eigen::Vector2d(0.8, 2.2)).norm(), 1e-6);
  EXPECT_NEAR(places[1].yaw(), 2.5707963, 1e-6);
  EXPECT_LT((places[1].position - places[0].position - places[0].turn({0.1, -0.2})).norm(), 1e-6);
}

}  // namespace
}  // namespace twinbus
