#include "control/walk/walk_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "control/walk/dcm_plan.h"
#include "test/oracles/lipm.h"
#include "control/walk/step_adjust.h"
#include "test/control/hrp1s.h"

namespace twinbus {
namespace {

constexpr double kPatternDt = 0.002, kOmega = 3.74;

Gait pattern_gait() { return gait_of(test::hrp1s(), test::hrp1s().walking, 0.01); }

// A robot that does what the pattern says: a pendulum on the reference ZMP, and soles that land where they were sent.
struct Puppet {
  explicit Puppet(const Gait& how = pattern_gait()) : pattern(how) {
    std::array<Foothold, 2> feet;
    for (int f = 0; f < 2; ++f)
      feet[static_cast<std::size_t>(f)].position << 0.0, side_of(f) * 0.5 * pattern.gait().width;
    pattern.start(feet);
    dcm = com = pattern.middle();
  }
  void tick() {
    std::array<bool, 2> touching{true, true};
    std::array<Foothold, 2> measured{pattern.foot(0), pattern.foot(1)};
    if (pattern.single()) {
      const auto moves = static_cast<std::size_t>(1 - pattern.support());
      measured[moves] = pattern.swing().place();
      touching[moves] = pattern.swing().height() <= ground;
      measured[1 - moves].gradient.y() = gradient;
    }
    pattern.advance(touching, measured, kPatternDt);
    pattern.plan(dcm, kOmega);
    jump = std::max(jump, (pattern.dcm() - dcm).norm());
    const Eigen::Vector2d zmp = pattern.zmp() + (1.0 + 4.0 / kOmega) * (dcm - pattern.dcm());
    dcm += kPatternDt * kOmega * (dcm - zmp);
    com += kPatternDt * kOmega * (dcm - com);
    most_height = std::max(most_height, pattern.single() ? pattern.swing().height() : 0.0);
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kPatternDt)); ++i) tick();
  }
  WalkPattern pattern;
  Eigen::Vector2d dcm, com;
  double ground = 0.0, jump = 0.0, most_height = 0.0;
  double gradient = 0.0;  // to the left, under the sole that stands
};

TEST(DcmPlan, APieceRunsForwardsAsItWasComputedBackwards) {
  const ZmpPiece piece{{0.0, 0.1}, {0.2, -0.1}, 0.3};
  const Eigen::Vector2d end(0.35, 0.02);
  Eigen::Vector2d xi = dcm_before(piece, end, kOmega);
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector2d p = piece.from + (piece.to - piece.from) * ((i + 0.5) / n);
    xi += piece.duration / n * kOmega * (xi - p);
  }
  EXPECT_LT((xi - end).norm(), 2e-5);
}

// Steps of 20 mm up and down, then level ground again.
TEST(WalkPattern, NarrowSolesWalkWiderWhileTheGroundIsRough) {
  for (const double wider : {0.0, 0.06}) {
    Gait gait = pattern_gait();
    gait.rough_wider = wider;
    Puppet puppet(gait);
    puppet.pattern.want({0.2, 0.0, 0.0});
    const auto walk = [&](double high, double seconds) {
      double apart = 0.0;
      int steps = -1;
      for (int i = 0; i < static_cast<int>(seconds / kPatternDt); ++i) {
        puppet.tick();
        if (puppet.pattern.steps() == steps) continue;
        steps = puppet.pattern.steps();
        puppet.ground = steps % 2 == 0 ? high : 0.0;
        apart = (puppet.pattern.foot(0).position - puppet.pattern.foot(1).position).y();
      }
      return apart;
    };
    EXPECT_NEAR(walk(0.0, 4.0), gait.width, 0.01);
    EXPECT_NEAR(walk(0.02, 6.0), gait.width + wider, 0.01) << wider;
    EXPECT_NEAR(walk(0.0, 25.0), gait.width, 0.01) << wider;
  }
}

// What nobody could know ahead, the end of walking, moves the reference of the closed form at once.
TEST(WalkPattern, PreviewControlBendsTheReferenceThatTheClosedFormLetsJump) {
  Gait preview = pattern_gait();
  preview.preview = true;
  double jump[2] = {};  // of the DCM in a tick [m]
  for (const bool with : {false, true}) {
    Puppet puppet(with ? preview : pattern_gait());
    Eigen::Vector2d last = puppet.pattern.dcm();
    for (int i = 0; i < 4500; ++i) {
      puppet.pattern.want({i < 2000 ? 0.3 : 0.0, 0.0, 0.0});
      puppet.tick();
      jump[with] = std::max(jump[with], (puppet.pattern.dcm() - last).norm());
      last = puppet.pattern.dcm();
    }
    EXPECT_FALSE(puppet.pattern.walking());
    EXPECT_GT(puppet.pattern.middle().x(), 0.8);
    EXPECT_LT((puppet.com - puppet.pattern.middle()).norm(), 0.01);
    EXPECT_LT((puppet.pattern.dcm() - puppet.pattern.middle()).norm(), 0.001);
  }
  EXPECT_GT(jump[0], 0.03);
  EXPECT_LT(jump[1], 0.005);
}

// How fast the foot in the air is in the last part of its swings [m/s].
double fastest_landing(Puppet& puppet, double seconds) {
  double fastest = 0.0;
  Eigen::Vector2d last = puppet.pattern.swing().place().position;
  bool was_single = false;
  for (int i = 0; i < static_cast<int>(seconds / kPatternDt); ++i) {
    puppet.tick();
    const Eigen::Vector2d now = puppet.pattern.swing().place().position;
    const bool lands = puppet.pattern.single() && puppet.pattern.swing().progress() > 0.85;
    if (lands && was_single) fastest = std::max(fastest, (now - last).norm() / kPatternDt);
    was_single = puppet.pattern.single();
    last = now;
  }
  return fastest;
}

// Drawn back until it lands it would land in motion, and slide.
TEST(WalkPattern, AFootAboutToLandIsNotDrawnBackByAnotherVelocity) {
  Puppet puppet;
  puppet.pattern.want({0.5, 0.0, 0.0});
  puppet.run(4.0);
  const double usual = fastest_landing(puppet, 2.0);
  EXPECT_GT(usual, 0.0);
  puppet.pattern.want(Eigen::Vector3d::Zero());
  EXPECT_LT(fastest_landing(puppet, 2.0), 1.05 * usual);
}

TEST(WalkPattern, StandsUntilAVelocityIsWantedAndAgainAfterwards) {
  Puppet puppet;
  puppet.run(1.0);
  EXPECT_FALSE(puppet.pattern.walking());
  puppet.pattern.want({0.3, 0.0, 0.0});
  puppet.run(5.0);
  EXPECT_TRUE(puppet.pattern.walking());
  puppet.pattern.want(Eigen::Vector3d::Zero());
  puppet.run(4.0);
  EXPECT_FALSE(puppet.pattern.walking());
  EXPECT_LT((puppet.com - puppet.pattern.middle()).norm(), 0.01);
  const Eigen::Vector2d between = puppet.pattern.foot(0).unturn(puppet.pattern.foot(0).position -
                                                                puppet.pattern.foot(1).position);
  EXPECT_NEAR(between.x(), 0.0, 0.01) << "feet side by side";
}

TEST(WalkPattern, WalksAtTheVelocityWanted) {
  for (const Eigen::Vector3d& v :
       {Eigen::Vector3d(0.5, 0.0, 0.0), Eigen::Vector3d(-0.2, 0.0, 0.0),
        Eigen::Vector3d(0.0, 0.1, 0.0), Eigen::Vector3d(0.0, 0.0, 0.3)}) {
    Puppet puppet;
    puppet.pattern.want(v);
    puppet.run(5.0);
    const Eigen::Vector2d from = puppet.pattern.middle();
    const double heading = puppet.pattern.heading();
    puppet.run(12.0 * puppet.pattern.gait().period());
    const double time = 12.0 * puppet.pattern.gait().period();
    const Eigen::Vector2d gone = puppet.pattern.middle() - from;
    if (v.z() == 0.0) {
      EXPECT_LT((gone / time - v.head<2>()).norm(), 0.1 * v.norm()) << v.transpose();
    }
    EXPECT_NEAR(std::remainder(puppet.pattern.heading() - heading, 6.283185307) / time, v.z(),
                0.1 * std::abs(v.z()) + 1e-6);
  }
}

TEST(WalkPattern, AnUndisturbedPendulumStaysOnItsPlanHoweverTheCommandChanges) {
  Puppet puppet;
  for (const Eigen::Vector3d& v :
       {Eigen::Vector3d(0.4, 0.0, 0.0), Eigen::Vector3d(0.0, 0.1, 0.2),
        Eigen::Vector3d(-0.2, 0.0, 0.0), Eigen::Vector3d(0.3, -0.05, -0.3)}) {
    puppet.pattern.want(v);
    puppet.run(2.3);
  }
  EXPECT_LT(puppet.jump, 0.035);
  EXPECT_LT((puppet.com - puppet.pattern.middle()).norm(), 0.3);
}

TEST(WalkPattern, TheFootLiftsAsFarAsItShouldAndLandsSlowly) {
  Puppet puppet;
  puppet.pattern.want({0.3, 0.0, 0.0});
  double last = 0.0, landing_speed = 0.0;
  bool was_single = false;
  for (int i = 0; i < 3000; ++i) {
    puppet.tick();
    const bool single = puppet.pattern.single();
    const double height = puppet.pattern.swing().height();
    if (single && was_single && puppet.pattern.swing().progress() > 0.97)
      landing_speed = std::max(landing_speed, (last - height) / kPatternDt);
    last = height;
    was_single = single;
  }
  EXPECT_NEAR(puppet.most_height, puppet.pattern.gait().lift, 0.005);
  EXPECT_LT(landing_speed, 0.11);
}

TEST(WalkPattern, AFootThatFindsNoGroundFeelsForIt) {
  Puppet puppet;
  puppet.ground = -0.03;
  puppet.pattern.want({0.2, 0.0, 0.0});
  puppet.run(6.0);
  EXPECT_GT(puppet.pattern.steps(), 4);
}

TEST(WalkPattern, AFootholdIsAsHighAsTheGroundThatWasMetThere) {
  Puppet puppet;
  puppet.pattern.want({0.2, 0.0, 0.0});
  puppet.run(3.0);
  puppet.ground = 0.02;
  puppet.run(3.0);
  for (int f = 0; f < 2; ++f) EXPECT_NEAR(puppet.pattern.foot(f).height, 0.02, 0.003) << f;
  EXPECT_NEAR(puppet.pattern.ground(), 0.02, 0.003);
}

TEST(WalkPattern, DaresLessSpeedWhileLandingsFindStepsOrSolesStandOnEdges) {
  const double most = pattern_gait().most_velocity.x();
  for (const bool edges : {false, true}) {
    Puppet puppet;
    puppet.pattern.want({most, 0.0, 0.0});
    puppet.run(6.0);
    EXPECT_NEAR(puppet.pattern.velocity().x(), most, 1e-9);
    for (int i = 0; i < 2500; ++i) {
      const double side = puppet.pattern.steps() % 2 == 0 ? 1.0 : -1.0;
      (edges ? puppet.gradient : puppet.ground) = edges ? 0.12 * side : 0.01 + 0.01 * side;
      puppet.tick();
    }
    EXPECT_LT(puppet.pattern.velocity().x(), 0.5 * most) << edges;
    puppet.pattern.want({0.3 * most, 0.0, 0.0});  // what is slow enough is done as asked
    puppet.run(3.0);
    EXPECT_NEAR(puppet.pattern.velocity().x(), 0.3 * most, 1e-9) << edges;
    puppet.pattern.want({most, 0.0, 0.0});
    puppet.gradient = 0.0;
    puppet.run(15.0);
    EXPECT_NEAR(puppet.pattern.velocity().x(), most, 1e-9) << edges;
  }
}

TEST(WalkPattern, FeetThatStandNearEachOtherComeApartBeforeTheyTurn) {
  Puppet puppet;
  std::array<Foothold, 2> feet;
  for (int f = 0; f < 2; ++f)
    feet[static_cast<std::size_t>(f)].position << 0.0,
        side_of(f) * 0.45 * puppet.pattern.gait().min_width;
  puppet.pattern.start(feet);
  puppet.dcm = puppet.com = puppet.pattern.middle();
  puppet.pattern.want({0.0, 0.0, 0.5});
  while (puppet.pattern.steps() == 0) puppet.tick();
  EXPECT_NEAR(puppet.pattern.heading(), 0.0, 1e-6);
  puppet.run(1.5);
  EXPECT_GT(puppet.pattern.heading(), 0.1);
}

TEST(WalkPattern, AHaltTakesAtMostTwoMoreSteps) {
  for (int phase = 0; phase < 12; ++phase) {
    Puppet puppet;
    puppet.pattern.want({0.5, 0.0, 0.0});
    puppet.run(5.0 + 0.1 * phase);
    const int steps = puppet.pattern.steps();
    puppet.pattern.halt();
    puppet.run(3.0);
    EXPECT_FALSE(puppet.pattern.walking());
    EXPECT_LE(puppet.pattern.steps() - steps, 2) << phase;
  }
}

// A stop was foreseen while nobody knew of the robot; it goes on as fast as its DCM is, not as the stop would have it.
TEST(WalkPattern, AWalkThatGoesOnAfterAForeseenHaltHasTheSpeedThatFitsTheDcm) {
  Puppet puppet;
  puppet.pattern.want({0.5, 0.0, 0.0});
  puppet.run(5.03);
  while (!(puppet.pattern.single() && puppet.pattern.swing().progress() < 0.2)) puppet.tick();
  puppet.pattern.halt();
  puppet.run(0.06);
  EXPECT_LT(puppet.pattern.velocity().x(), 0.3);
  puppet.pattern.want({0.5, 0.0, 0.0});
  WalkPattern fast = puppet.pattern, slow = puppet.pattern;
  const Eigen::Vector2d on = puppet.dcm + Eigen::Vector2d(0.06, 0.0);
  fast.walk_on(on, kOmega);
  EXPECT_GT(fast.velocity().x(), slow.velocity().x() + 0.1);
  slow.walk_on(puppet.dcm - Eigen::Vector2d(0.06, 0.0), kOmega);
  EXPECT_LT(slow.velocity().x(), fast.velocity().x());
}

// As after a walk that was stopped: the front foot carries the robot already, so the other one steps.
TEST(WalkPattern, ACaptureStepIsMadeWithTheFootThatNeedsToStepLessFar) {
  const Gait g = pattern_gait();
  for (int front = 0; front < 2; ++front) {
    WalkPattern pattern(g);
    std::array<Foothold, 2> feet;
    for (int f = 0; f < 2; ++f)
      feet[static_cast<std::size_t>(f)].position << (f == front ? 0.6 * g.max_forward : 0.0), side_of(f) * 0.5 * g.width;
    pattern.start(feet);
    const Eigen::Vector2d ahead(pattern.foot(front).position.x() + g.sole_high.x() - 0.03, side_of(front) * 0.45 * g.width);
    pattern.plan(ahead, kOmega);
    pattern.capture(ahead, kOmega);
    EXPECT_TRUE(pattern.walking());
    EXPECT_EQ(pattern.support(), front);
  }
  for (int foot = 0; foot < 2; ++foot) {  // pushed to a side: that foot goes there
    Puppet puppet;
    const Eigen::Vector2d aside(puppet.dcm.x(), side_of(foot) * g.width);
    puppet.pattern.capture(aside, kOmega);
    EXPECT_EQ(puppet.pattern.support(), 1 - foot);
  }
}

TEST(WalkPattern, AListOfFootholdsIsSteppedOnOneByOne) {
  Puppet puppet;
  const double half = 0.5 * puppet.pattern.gait().width;
  Foothold list[3];
  list[0].position << 0.2, half;  // left first: the right foot stands
  list[1].position << 0.35, -half;
  list[2].position << 0.35, half;
  puppet.pattern.follow(list, 3, 1);
  puppet.run(6.0);
  EXPECT_FALSE(puppet.pattern.walking());
  EXPECT_LT((puppet.pattern.foot(1).position - list[1].position).norm(), 0.01);
  EXPECT_LT((puppet.pattern.foot(0).position - list[2].position).norm(), 0.01);
}

TEST(StepAdjust, AnUndisturbedStepIsLeftAlone) {
  const Gait g = pattern_gait();
  StepNow now;
  now.foot = 1;
  now.planned.position << 0.3, g.width;
  now.offset << 0.1, -0.1;
  now.left_planned = now.left_now = 0.3;
  const double grown = std::exp(kOmega * 0.3);
  const Eigen::Vector2d end = now.planned.position + now.offset;
  now.dcm =
      (end - Eigen::Vector2d(g.zmp_forward, 0.0)) / grown + Eigen::Vector2d(g.zmp_forward, 0.0);
  const StepAdjusted step = adjust_step(g, now, kOmega);
  EXPECT_LT(step.moved, 1e-9);
  EXPECT_NEAR(step.left, 0.3, 1e-9);
}

TEST(StepAdjust, AFootIsNotThrownInwardShortlyBeforeItLands) {
  const Gait g = pattern_gait();
  StepNow now;
  now.foot = 1;
  now.planned.position << 0.0, g.width + 0.1;
  now.left_planned = now.left_now = now.shortest = 0.14;
  now.dcm << 0.0, -0.3;  // pushed over the foot that stands
  now.moves = now.planned;
  EXPECT_GT(adjust_step(g, now, kOmega).foothold.position.y(), g.min_width + 0.05);
  now.left_planned = now.left_now = now.shortest = 0.4;
  EXPECT_NEAR(adjust_step(g, now, kOmega).foothold.position.y(), g.min_width, 1e-9);
}

TEST(StepAdjust, AStepOfASoleThatLeansIsAsLongAsItsTimeAsks) {
  Gait g = pattern_gait();
  g.leans = true;
  g.sole_low.x() = -1.0;  // forward the sole catches it
  g.sole_high.x() = 1.0;
  StepNow now;
  now.foot = 1;
  now.planned.position << 0.3, g.width;
  now.offset << 0.05, -0.5 * g.width;
  now.elapsed = 0.2;
  now.left_planned = now.left_now = g.period() - now.elapsed;
  now.dcm << 0.05, 0.5 * g.width;  // far enough to the side: the step lands early
  const StepAdjusted step = adjust_step(g, now, kOmega);
  ASSERT_LT(step.left, now.left_planned - 0.03);
  EXPECT_NEAR(step.foothold.position.x(), 0.3 * (now.elapsed + step.left) / g.period(), 0.01);
  g.leans = false;
  EXPECT_GT(adjust_step(g, now, kOmega).foothold.position.x(), step.foothold.position.x() + 0.02);
}

TEST(StepAdjust, APushMovesTheFootholdThatWayAndTheDcmCanBeCaught) {
  const Gait g = pattern_gait();
  StepNow now;
  now.foot = 1;
  now.planned.position << 0.0, g.width;
  now.offset << 0.0, -0.5 * g.width;
  now.left_planned = now.left_now = 0.3;
  now.dcm << 0.2, 0.03;
  const StepAdjusted step = adjust_step(g, now, kOmega);
  EXPECT_GT(step.foothold.position.x(), 0.05);
  EXPECT_LE(step.foothold.position.x(), g.max_forward + 1e-12);
  EXPECT_LE(step.left, 0.3 + 1e-12);
  // With the ZMP at the front of the sole until then, the DCM is where the next step needs it.
  const double grown = std::exp(kOmega * step.left);
  const double reached = g.sole_high.x() + (now.dcm.x() - g.sole_high.x()) * grown;
  EXPECT_LT(reached - step.foothold.position.x(), 0.03);
}

TEST(StepAdjust, AStepIsNotHurriedMoreThanTheHipsCanThrowTheFoot) {
  Gait strong = pattern_gait(), weak = strong;
  weak.swing_acceleration.x() = 20.0;
  StepNow now;
  now.foot = 1;
  now.moves.position << -0.2, strong.width;
  now.planned.position << 0.2, strong.width;
  now.offset << 0.1, -0.5 * strong.width;
  now.left_planned = now.left_now = 0.5;
  now.dcm << 0.2, 0.03;
  const double hurried = adjust_step(strong, now, kOmega).left;
  EXPECT_LT(hurried, 0.4);
  const StepAdjusted step = adjust_step(weak, now, kOmega);
  EXPECT_GT(step.left, hurried + 0.03);
  const double moves = step.left - SwingGains{}.early;
  EXPECT_LE(step.foothold.position.x(), -0.2 + 20.0 / 5.77 * moves * moves + 1e-9);
  // One that cannot be reached in time as planned either goes as planned.
  weak.swing_acceleration.x() = 3.0;
  EXPECT_EQ(adjust_step(weak, now, kOmega).left, 0.5);
}

}  // namespace
}  // namespace twinbus
