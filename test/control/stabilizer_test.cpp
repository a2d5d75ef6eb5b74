#include "control/stabilizer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "control/lipm.h"

namespace twinbus {
namespace {

constexpr double kDt = 0.002;
constexpr double kHeight = 0.75;

// Equations, not tuned numbers: a pendulum that does what the stabilizer asks.
struct Pendulum {
  Lipm lipm{kHeight};
  LipmState x, y;
  Eigen::Vector2d com() const { return {x.position, y.position}; }
  Eigen::Vector2d velocity() const { return {x.velocity, y.velocity}; }
  Eigen::Vector2d dcm() const { return com() + velocity() / lipm.omega(); }
  void advance(const Eigen::Vector2d& zmp) {
    x = lipm.advance(x, zmp.x(), kDt);
    y = lipm.advance(y, zmp.y(), kDt);
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
  for (int i = 0; i < static_cast<int>(seconds / kDt); ++i) {
    stabilizer.update(plan, pendulum.com(), pendulum.dcm(), stance(), pendulum.lipm.omega(), kDt);
    pendulum.advance(stabilizer.share().zmp);
  }
  return (pendulum.com() - plan.position).norm();
}

TEST(Stabilizer, RestOnThePlanAsksForTheZmpOfThePlan) {
  Pendulum pendulum;
  Stabilizer stabilizer({});
  stabilizer.start(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), pendulum.lipm.omega());
  stabilizer.update({}, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), stance(),
                    pendulum.lipm.omega(), kDt);
  EXPECT_NEAR(stabilizer.zmp_wanted().norm(), 0.0, 1e-12);
  EXPECT_NEAR(stabilizer.excess().norm(), 0.0, 1e-12);
}

TEST(Stabilizer, APushThatTheSolesCanAnswerDies) {
  for (const Eigen::Vector2d& push :
       {Eigen::Vector2d(0.12, 0.0), Eigen::Vector2d(-0.1, 0.15), Eigen::Vector2d(0.0, -0.2)}) {
    Pendulum pendulum;
    Stabilizer stabilizer({});
    stabilizer.start(pendulum.com(), pendulum.velocity(), pendulum.lipm.omega());
    pendulum.x.velocity = push.x();
    pendulum.y.velocity = push.y();
    EXPECT_LT(run(pendulum, stabilizer, {}, 6.0), 5e-3) << push.transpose();
    EXPECT_LT(pendulum.velocity().norm(), 5e-3);
  }
}

TEST(Stabilizer, WithoutFeedbackTheSamePushFells) {
  Pendulum pendulum;
  Stabilizer stabilizer({});
  stabilizer.start(pendulum.com(), pendulum.velocity(), pendulum.lipm.omega());
  pendulum.x.velocity = 0.12;
  for (int i = 0; i < 1500; ++i) {
    stabilizer.update({}, pendulum.com(), pendulum.dcm(), stance(), pendulum.lipm.omega(), kDt,
                      false);
    pendulum.advance(stabilizer.share().zmp);
  }
  EXPECT_GT(pendulum.com().norm(), 0.3);
}

TEST(Stabilizer, AZmpOutsideTheSolesIsExcessAndNotAsked) {
  Pendulum pendulum;
  Stabilizer stabilizer({});
  stabilizer.start(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), pendulum.lipm.omega());
  stabilizer.update({}, Eigen::Vector2d::Zero(), {0.3, 0.0}, stance(), pendulum.lipm.omega(), kDt);
  EXPECT_LE(stabilizer.share().zmp.x(), 0.12);
  EXPECT_GT(stabilizer.excess().x(), 0.0);
  EXPECT_NEAR((stabilizer.zmp_wanted() - stabilizer.share().zmp - stabilizer.excess()).norm(), 0.0,
              1e-12);
}

TEST(Stabilizer, AtAChangeOfSourceAStepOfTheMeasurementIsLetInSlowly) {
  Pendulum pendulum;
  Stabilizer stabilizer({});
  const double omega = pendulum.lipm.omega();
  stabilizer.start(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), omega);
  stabilizer.update({}, Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), stance(), omega, kDt);
  const Eigen::Vector2d before = stabilizer.zmp_wanted(), step(0.01, -0.01);
  Stabilizer unwarned = stabilizer;
  stabilizer.rebase();
  stabilizer.update({}, Eigen::Vector2d::Zero(), step, stance(), omega, kDt);
  unwarned.update({}, Eigen::Vector2d::Zero(), step, stance(), omega, kDt);
  EXPECT_LT((stabilizer.zmp_wanted() - before).norm(),
            0.05 * (unwarned.zmp_wanted() - before).norm());
}

TEST(Stabilizer, TheReferenceStaysWithinReachInAFall) {
  Stabilizer stabilizer({});
  stabilizer.start(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), 3.6);
  for (int i = 0; i < 5000; ++i) stabilizer.update({}, {3.0, 3.0}, {9.0, 9.0}, stance(), 3.6, kDt);
  EXPECT_TRUE(stabilizer.com_reference().allFinite());
  EXPECT_LT(stabilizer.com_reference().norm(), 0.5);
}

}  // namespace
}  // namespace twinbus
