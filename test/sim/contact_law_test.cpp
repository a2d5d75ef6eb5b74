#include "sim/contact/contact_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/math/random.h"

namespace twinbus {
namespace {

constexpr double kLawStep = 0.002;  // [s]

ContactParams params() {
  ContactParams p;
  p.stiffness = 2e5;
  p.damping = 500.0;
  p.tangent_stiffness = 8e6;
  p.tangent_damping = 1e4;
  p.friction = 0.8;
  return p;
}

// An impact on a law without friction, by small steps of the second order: the speed it leaves with.
double rebound(const ContactParams& p, double mass, double speed) {
  const double h = 1e-7;
  ContactForce force;
  const auto pull = [&](double depth, double v) {
    contact_force(p, depth, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                  Eigen::Vector3d(0.0, 0.0, v), 0.0, false, 0.0, force);
    return force.force.z() / mass;
  };
  double depth = 0.0, v = -speed;
  do {
    const double half_depth = depth - 0.5 * h * v, half_v = v + 0.5 * h * pull(depth, v);
    depth -= h * half_v;
    v += h * pull(half_depth, half_v);
  } while (depth > 0.0);
  return v;
}

struct Case {
  double depth;
  Eigen::Vector3d normal, stretch, v;
};

Case random_case(Random& random) {
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * random.normal(), size * random.normal(), size * random.normal());
  };
  Case c;
  c.depth = 1e-3 * random.normal();
  c.normal = vector(1.0).normalized();
  c.stretch = vector(1e-5);
  c.stretch -= c.normal * c.normal.dot(c.stretch);
  c.v = vector(0.05);
  return c;
}

TEST(ContactLaw, NeverPullsAndNeverLeavesTheCone) {
  Random random(3);
  ContactForce force;
  int sticks = 0, slips = 0;
  for (int i = 0; i < 20000; ++i) {
    const Case c = random_case(random);
    contact_force(params(), c.depth, c.normal, c.stretch, c.v, kLawStep, false, 0.0, force);
    const double fn = c.normal.dot(force.force);
    const double ft = (force.force - fn * c.normal).norm();
    ASSERT_GE(fn, 0.0);
    ASSERT_LE(ft, params().friction * fn * (1.0 + 1e-12) + 1e-12);
    sticks += force.mode == ContactMode::kStick;
    slips += force.mode == ContactMode::kSlip;
  }
  EXPECT_GT(sticks, 50);
  EXPECT_GT(slips, 1000);
}

// a (v + v_out) = ln((1 + a v) / (1 - a v_out)), at any stiffness and mass.
TEST(ContactLaw, AnImpactLosesWhatHuntAndCrossleySay) {
  for (const double dissipation : {0.1, 0.5, 2.0}) {
    for (const double stiffness : {1e4, 1e6}) {
      ContactParams p = params();
      p.stiffness = stiffness;
      for (const double speed : {0.1, 1.0}) {
        const double out = rebound(hunt_crossley(p, dissipation), 2.0, speed);
        const double a = dissipation;
        EXPECT_NEAR(a * (speed + out), std::log((1.0 + a * speed) / (1.0 - a * out)),
                    1e-4 * a * speed);
        EXPECT_LT(out, speed);
      }
    }
  }
}

TEST(ContactLaw, TheTangentIsItsDerivative) {
  Random random(5);
  ContactForce force, plus, minus;
  const double step = 1e-8;
  for (const double smooth : {0.0, 5.0, -1.0, -5.0}) {  // below zero: Hunt and Crossley's
    const ContactParams law = smooth < 0.0 ? hunt_crossley(params(), 2.0) : params();
    const double round = smooth == -1.0 ? 0.0 : std::abs(smooth);
    int compared = 0;
    for (int i = 0; i < 3000; ++i) {
      const Case c = random_case(random);
      contact_force(law, c.depth, c.normal, c.stretch, c.v, kLawStep, true, round, force);
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(k);
        contact_force(law, c.depth, c.normal, c.stretch, c.v + d, kLawStep, false, round, plus);
        contact_force(law, c.depth, c.normal, c.stretch, c.v - d, kLawStep, false, round, minus);
        if (plus.mode != minus.mode) continue;  // a kink
        const double end = c.depth - kLawStep * c.normal.dot(c.v);
        if (std::abs(end - kDampingRamp) < 1e-9 || std::abs(end) < 1e-9) continue;
        const Eigen::Vector3d slope = -(plus.force - minus.force) / (2.0 * step);
        ASSERT_LT((slope - force.tangent.col(k)).norm(),
                  1e-4 * (force.tangent.norm() + slope.norm()) + 1e-2)
            << i << ' ' << smooth;
        ++compared;
      }
    }
    EXPECT_GT(compared, 5000);
  }
}

TEST(ContactLaw, AtRestItIsASpring) {
  ContactForce force;
  contact_force(params(), 1e-3, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                Eigen::Vector3d::Zero(), kLawStep, false, 0.0, force);
  EXPECT_DOUBLE_EQ(force.force.z(), 200.0);
  contact_force(params(), -1e-9, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                Eigen::Vector3d::Zero(), kLawStep, false, 0.0, force);
  EXPECT_EQ(force.mode, ContactMode::kOpen);
}

TEST(TurningMoment, StaysInItsBoundsAndHasItsSlopes) {
  ContactParams p;
  p.tangent_stiffness = 1e5;
  p.tangent_damping = 200.0;
  p.rolling = 2e-3;
  p.torsional = 5e-3;
  Random random(4);
  const auto vector = [&](double size) { return Eigen::Vector3d(size * random.normal(), size * random.normal(), size * random.normal()); };
  const double h = 0.002, steep = 300.0, step = 1e-7;
  int held = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d n = vector(1.0).normalized(), turned = vector(1e-4), w = vector(i % 2 == 0 ? 0.01 : 1.0);
    const double press = 20.0 + 5.0 * random.uniform();
    const auto at = [&](const Eigen::Vector3d& dw, const Eigen::Vector3d& dv) {
      return turning_moment(p, n, turned, w + dw, press - steep * n.dot(dv), steep, h);
    };
    const TurningMoment m = at(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
    EXPECT_LE(std::abs(n.dot(m.moment)), p.torsional * press * (1.0 + 1e-12));
    EXPECT_LE((m.moment - n * n.dot(m.moment)).norm(), p.rolling * press * (1.0 + 1e-12));
    held += m.by_moving.isZero(0.0) ? 1 : 0;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d d = step * Eigen::Vector3d::Unit(k);
      const Eigen::Vector3d turning = (at(-d, Eigen::Vector3d::Zero()).moment - at(d, Eigen::Vector3d::Zero()).moment) / (2.0 * step);
      const Eigen::Vector3d moving = (at(Eigen::Vector3d::Zero(), -d).moment - at(Eigen::Vector3d::Zero(), d).moment) / (2.0 * step);
      EXPECT_NEAR((turning - m.by_turning.col(k)).norm(), 0.0, 1e-4);
      EXPECT_NEAR((moving - m.by_moving.col(k)).norm(), 0.0, 1e-4);
    }
    const Eigen::Vector3d after = turned_after(p, turned, m.moment, h);
    if (m.by_moving.isZero(0.0)) {
      EXPECT_NEAR((after - turned - h * w).norm(), 0.0, 1e-12);
    }
  }
  EXPECT_GT(held, 20);
  p.rolling = p.torsional = 0.0;
  EXPECT_FALSE(turns(p));
}

}  // namespace
}  // namespace twinbus
