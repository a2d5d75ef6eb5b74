// The contact law of the paper, section 3.3.2, on manifolds known by hand.

#include "test/oracles/patch_force.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/math/index.h"
#include "test/contact_shapes.h"

namespace twinbus {
namespace {

using Eigen::Vector3d;

// A square of four points, side 0.2 m, so deep as said.
Manifold square(double a, double b, double c, double d) {
  Manifold m;
  m.count = 4;
  const double depth[] = {a, b, c, d};
  for (int i = 0; i < 4; ++i) {
    m.point[at(i)] = {{i % 2 == 0 ? -0.1 : 0.1, i < 2 ? -0.1 : 0.1, 0.0}, Vector3d::UnitZ(),
                      depth[i], i};
  }
  return m;
}

TEST(PatchForce, SpringAndDamperOfAFlatContact) {
  const PatchLaw law{1e5, 0.5};
  const Manifold m = square(1e-3, 1e-3, 1e-3, 1e-3);
  const PatchForce still = patch_force(law, m, Vector3d::Zero(), Vector3d::Zero());
  EXPECT_LT((still.force - Vector3d(0, 0, 400)).norm(), 1e-9);
  EXPECT_LT(still.moment.norm(), 1e-9);
  const PatchForce sinking = patch_force(law, m, {3.0, 0.0, -0.4}, Vector3d::Zero());
  EXPECT_LT((sinking.force - Vector3d(0, 0, 480)).norm(), 1e-9);
  const PatchForce leaving = patch_force(law, m, {0.0, 0.0, 4.0}, Vector3d::Zero());
  EXPECT_EQ(leaving.force.norm(), 0.0);  // never pulls
}

// Only what sinks is damped: a rocking contact leans against its motion.
TEST(PatchForce, VelocityIsThatOfEachPoint) {
  const PatchForce rocking = patch_force({1e5, 0.5}, square(1e-3, 1e-3, 1e-3, 1e-3),
                                         Vector3d::Zero(), Vector3d(0.0, 1.0, 0.0));
  EXPECT_NEAR(rocking.force.z(), 400.0, 1e-9);
  EXPECT_NEAR(rocking.moment.y(), -4 * 100.0 * 0.5 * 0.1 * 0.1, 1e-9);
}

TEST(PatchForce, LeastSquaresKeepSumAndMomentAndTakeOutTheRest) {
  const PatchLaw law{1e5, 0.0};
  // A tilt is kept as it is.
  const PatchForce tilted =
      patch_force(law, square(1e-3, 2e-3, 1e-3, 2e-3), Vector3d::Zero(), Vector3d::Zero());
  EXPECT_NEAR(tilted.depth[0], 1e-3, 1e-15);
  EXPECT_NEAR(tilted.depth[3], 2e-3, 1e-15);
  // A warp of 0.1 mm is not a depth nor a tilt.
  const PatchForce warped =
      patch_force(law, square(1.1e-3, 0.9e-3, 0.9e-3, 1.1e-3), Vector3d::Zero(), Vector3d::Zero());
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(warped.depth[at(i)], 1e-3, 1e-15);
  // Sum and moment of any depths stay.
  const Manifold any = square(1.0e-3, 2.2e-3, 1.7e-3, 2.4e-3);
  const PatchForce fitted = patch_force(law, any, Vector3d::Zero(), Vector3d::Zero());
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (int i = 0; i < any.count; ++i) {
    const ManifoldPoint& p = any.point[at(i)];
    force += law.stiffness * p.depth * p.normal;
    moment += p.position.cross(law.stiffness * p.depth * p.normal);
  }
  EXPECT_LT((fitted.force - force).norm(), 1e-9);
  EXPECT_LT((fitted.moment - moment).norm(), 1e-9);
}

// One point, two, points in a line, points at one place: no tilt that is not there.
TEST(PatchForce, FewPointsAreFitted) {
  Manifold m = square(1e-3, 2e-3, 0.0, 0.0);
  for (const int count : {1, 2}) {
    m.count = count;
    const PatchForce out = patch_force({1e5, 0.0}, m, Vector3d::Zero(), Vector3d::Zero());
    for (int i = 0; i < count; ++i) EXPECT_NEAR(out.depth[at(i)], m.point[at(i)].depth, 1e-15);
  }
  m.point[1].position = m.point[0].position;
  const PatchForce out = patch_force({1e5, 0.0}, m, Vector3d::Zero(), Vector3d::Zero());
  EXPECT_NEAR(out.depth[0], 1.5e-3, 1e-15);
  m.count = 0;
  EXPECT_EQ(patch_force({1e5, 0.0}, m, Vector3d::Zero(), Vector3d::Zero()).force.norm(), 0.0);
}

TEST(PatchForce, NotANumberIsNoForce) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const PatchForce out = patch_force({1e5, 0.5}, square(1e-3, 1e-3, 1e-3, 1e-3),
                                     Vector3d(nan, nan, nan), Vector3d::Zero());
  EXPECT_EQ(out.force.norm(), 0.0);
}

// Hunt and Crossley: a (v + v_out) = ln((1 + a v) / (1 - a v_out)), of a cube falling on a slab.
TEST(PatchForce, ImpactLosesWhatTheLawSays) {
  const ContactMesh cube(test::box_triangles(Vector3d::Constant(0.1)));
  const ContactMesh slab(test::box_triangles(Vector3d(1.0, 1.0, 0.1)));
  ManifoldFinder finder;
  finder.reserve(cube);
  finder.reserve(slab);
  const PatchLaw law{1e5, 0.3};
  constexpr double kMass = 2.0, kStep = 2e-6;
  double z = 0.1, v = -1.0;
  const auto acceleration = [&](double height, double speed) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation().z() = height;
    Manifold m;
    if (!finder.between(cube, pose, slab, Eigen::Isometry3d::Identity(), m)) return 0.0;
    return patch_force(law, m, Vector3d(0, 0, speed), Vector3d::Zero()).force.z() / kMass;
  };
  for (int i = 0; i < 20000 && (z < 0.1 || v < 0.0); ++i) {
    const double half = v + 0.5 * kStep * acceleration(z, v);
    const double middle = z + 0.5 * kStep * v;
    v += kStep * acceleration(middle, half);
    z += kStep * half;
  }
  EXPECT_GT(v, 0.0);
  const double a = law.dissipation;
  EXPECT_NEAR(a * (1.0 + v), std::log((1.0 + a) / (1.0 - a * v)), 1e-5);
}

}  // namespace
}  // namespace twinbus
