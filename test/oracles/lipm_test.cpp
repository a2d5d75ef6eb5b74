#include "test/oracles/lipm.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus {
namespace {

constexpr double kHeight = 0.8;  // [m]

TEST(Lipm, RejectsImpossibleHeights) {
  for (double height : {0.0, -0.8, std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(Lipm{height}, std::invalid_argument) << height;
  }
}

TEST(Lipm, TwoHalfStepsEqualOneStep) {
  const Lipm lipm(kHeight);
  const LipmState start{.position = 0.02, .velocity = -0.1};
  const LipmState once = lipm.advance(start, 0.03, 0.4);
  const LipmState twice = lipm.advance(lipm.advance(start, 0.03, 0.2), 0.03, 0.2);
  EXPECT_NEAR(once.position, twice.position, 1e-12);
  EXPECT_NEAR(once.velocity, twice.velocity, 1e-12);
}

// Orbital energy v^2/2 - omega^2 x^2/2 is constant while the ZMP is at the origin.
TEST(Lipm, ConservesOrbitalEnergy) {
  const Lipm lipm(kHeight);
  const auto energy = [&](const LipmState& s) {
    return 0.5 * s.velocity * s.velocity - 0.5 * std::pow(lipm.omega() * s.position, 2);
  };
  LipmState state{.position = -0.1, .velocity = 0.5};
  const double initial = energy(state);
  for (int tick = 0; tick < 200; ++tick) state = lipm.advance(state, 0.0, 0.005);
  EXPECT_NEAR(energy(state), initial, 1e-9 * std::abs(initial) + 1e-12);
}

TEST(Lipm, StandingOnTheCapturePointComesToRest) {
  const Lipm lipm(kHeight);
  const LipmState start{.position = 0.0, .velocity = 0.4};
  const double foot = lipm.capture_point(start);
  const LipmState end = lipm.advance(start, foot, 3.0);
  EXPECT_NEAR(end.position, foot, 1e-4);
  EXPECT_NEAR(end.velocity, 0.0, 1e-3);
}

TEST(Lipm, ZmpToReachIsTheInverseOfAdvance) {
  const Lipm lipm(kHeight);
  const LipmState start{.position = 0.01, .velocity = 0.2};
  const double zmp = lipm.zmp_to_reach(0.15, start, 0.3);
  EXPECT_NEAR(lipm.capture_point(lipm.advance(start, zmp, 0.3)), 0.15, 1e-12);
}

// A point mass whose leg pushes it along a sloped plane, in three dimensions, by small steps of the mechanics alone.
TEST(Lipm, TheSlopeOfTheConstraintPlaneDoesNotChangeHorizontalMotion) {
  const ConstraintPlane plane{.kx = 0.3, .ky = -0.2, .zc = kHeight};
  const Eigen::Vector3d normal = Eigen::Vector3d(-plane.kx, -plane.ky, 1.0).normalized();
  Eigen::Vector3d x(-0.1, 0.08, plane.height(-0.1, 0.08));
  Eigen::Vector3d v(0.45, -0.2, plane.kx * 0.45 + plane.ky * -0.2);
  const Lipm lipm(plane);
  const LipmState forward{.position = x.x(), .velocity = v.x()};
  const LipmState sideways{.position = x.y(), .velocity = v.y()};
  constexpr int kSteps = 100000;
  constexpr double kTime = 0.5, dt = kTime / kSteps;
  const Eigen::Vector3d gravity(0.0, 0.0, -kGravity);
  for (int i = 0; i < kSteps; ++i) {
    const auto acceleration = [&](const Eigen::Vector3d& at) {
      // The push along the leg that leaves no acceleration across the plane.
      return Eigen::Vector3d(gravity - normal.dot(gravity) / normal.dot(at) * at);
    };
    const Eigen::Vector3d middle = v + 0.5 * dt * acceleration(x);
    const Eigen::Vector3d half = x + 0.5 * dt * v;
    v += dt * acceleration(half);
    x += dt * middle;
  }
  EXPECT_NEAR(x.z(), plane.height(x.x(), x.y()), 1e-9);
  EXPECT_NEAR(x.x(), lipm.advance(forward, 0.0, kTime).position, 1e-8);
  EXPECT_NEAR(v.x(), lipm.advance(forward, 0.0, kTime).velocity, 1e-8);
  EXPECT_NEAR(x.y(), lipm.advance(sideways, 0.0, kTime).position, 1e-8);
  EXPECT_NEAR(v.y(), lipm.advance(sideways, 0.0, kTime).velocity, 1e-8);
}

}  // namespace
}  // namespace twinbus
