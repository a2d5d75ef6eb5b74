#include "control/balance/stabilizer.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <new>

#include "test/oracles/lipm.h"

namespace twinbus {
namespace {

constexpr double kStabilizerDt = 0.002;
constexpr double kComHeight = 0.75;
const Eigen::Vector2d kNone = Eigen::Vector2d::Zero();

// Equations, not tuned numbers: a pendulum that does what the stabilizer asks.
struct Pendulum {
  Lipm lipm{kComHeight};
  LipmState x, y;
  Eigen::Vector2d com() const { return {x.position, y.position}; }
  Eigen::Vector2d velocity() const { return {x.velocity, y.velocity}; }
  Eigen::Vector2d dcm() const { return com() + velocity() / lipm.omega(); }
  void advance(const Eigen::Vector2d& zmp) {
    x = lipm.advance(x, zmp.x(), kStabilizerDt);
    y = lipm.advance(y, zmp.y(), kStabilizerDt);
  }
};

std::array<SoleOnGround, 2> stance() {
  std::array<SoleOnGround, 2> soles;
  for (std::size_t s = 0; s < 2; ++s) {
    soles[s].position = {0.0, s == 0 ? 0.1 : -0.1};
    soles[s].front = soles[s].back = 0.12;
    soles[s].left = soles[s].right = 0.06;
  }
  return soles;
}

double run(Pendulum& pendulum, Stabilizer& stabilizer, const ComPlan& plan, double seconds) {
  for (int i = 0; i < static_cast<int>(seconds / kStabilizerDt); ++i) {
    stabilizer.update(plan, pendulum.dcm(), kNone, stance(), pendulum.lipm.omega(), kStabilizerDt);
    pendulum.advance(stabilizer.share().zmp);
  }
  return (pendulum.com() - plan.position).norm();
}

TEST(Stabilizer, RestOnThePlanAsksForTheZmpOfThePlan) {
  Stabilizer stabilizer({});
  stabilizer.start();
  stabilizer.update({}, kNone, kNone, stance(), 3.6, kStabilizerDt);
  EXPECT_NEAR(stabilizer.zmp_wanted().norm(), 0.0, 1e-12);
  EXPECT_NEAR(stabilizer.lean_wanted().norm(), 0.0, 1e-12);
}

TEST(Stabilizer, APushThatTheSolesCanAnswerDies) {
  for (const Eigen::Vector2d& push :
       {Eigen::Vector2d(0.12, 0.0), Eigen::Vector2d(-0.1, 0.15), Eigen::Vector2d(0.0, -0.2)}) {
    Pendulum pendulum;
    Stabilizer stabilizer({});
    stabilizer.start();
    pendulum.x.velocity = push.x();
    pendulum.y.velocity = push.y();
    EXPECT_LT(run(pendulum, stabilizer, {}, 6.0), 5e-3) << push.transpose();
    EXPECT_LT(pendulum.velocity().norm(), 5e-3);
  }
}

TEST(Stabilizer, WhatTheSolesCannotGiveIsWantedOfTheTrunk) {
  Stabilizer stabilizer({});
  stabilizer.start();
  stabilizer.update({}, {0.3, 0.0}, kNone, stance(), 3.6, kStabilizerDt);
  EXPECT_LE(stabilizer.share().zmp.x(), 0.12 - StabilizerGains{}.margin + 1e-12);
  EXPECT_GT(stabilizer.lean_wanted().x(), 0.0);
  EXPECT_NEAR((stabilizer.zmp_wanted() - stabilizer.share().zmp - stabilizer.lean_wanted()).norm(),
              0.0, 1e-12);
}

// The zero-moment point and the lean of the trunk act alike: what the trunk gives the soles need not.
TEST(Stabilizer, TheZmpMakesRoomForTheLeanThereIs) {
  StabilizerGains gains;
  gains.cop_filter = 0.0;
  Stabilizer upright(gains), leaning(gains);
  upright.start();
  leaning.start();
  upright.update({}, {0.02, 0.01}, kNone, stance(), 3.6, kStabilizerDt);
  leaning.update({}, {0.02, 0.01}, {0.01, 0.0}, stance(), 3.6, kStabilizerDt);
  EXPECT_NEAR((upright.share().zmp - leaning.share().zmp - Eigen::Vector2d(0.01, 0.0)).norm(), 0.0,
              1e-9);
}

TEST(Stabilizer, AtAChangeOfSourceAStepOfTheMeasurementIsLetInSlowly) {
  Stabilizer stabilizer({});
  stabilizer.start();
  stabilizer.update({}, kNone, kNone, stance(), 3.6, kStabilizerDt);
  const Eigen::Vector2d before = stabilizer.zmp_wanted(), step(0.01, -0.01);
  Stabilizer unwarned = stabilizer;
  stabilizer.rebase();
  stabilizer.update({}, step, kNone, stance(), 3.6, kStabilizerDt);
  unwarned.update({}, step, kNone, stance(), 3.6, kStabilizerDt);
  EXPECT_LT((stabilizer.zmp_wanted() - before).norm(),
            0.05 * (unwarned.zmp_wanted() - before).norm());
}

// A robot that is started twice must do the same twice, whatever was in its memory before.
TEST(Stabilizer, BeginsAlikeInWhateverMemory) {
  alignas(Stabilizer) std::array<std::byte, sizeof(Stabilizer)> memory;
  memory.fill(std::byte{0xff});  // as numbers: NaN
  auto* used = new (memory.data()) Stabilizer({});
  Stabilizer fresh{{}};
  for (Stabilizer* one : {used, &fresh}) {
    one->start();
    one->update({}, {0.02, 0.01}, kNone, stance(), 3.6, kStabilizerDt);
  }
  EXPECT_EQ(used->share().zmp, fresh.share().zmp);
  EXPECT_EQ(used->share().cop[0], fresh.share().cop[0]);
  used->~Stabilizer();
}

}  // namespace
}  // namespace twinbus
