// Contact of triangle sets: bodies whose contact is known by hand.

#include "geometry/mesh_contact/manifold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"
#include "common/math/random.h"
#include "test/contact_shapes.h"
#include "common/allocation/no_alloc.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180.0;

Isometry3d moved(double x, double y, double z) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

Isometry3d turned(double angle, const Vector3d& axis, const Vector3d& to) {
  Isometry3d pose = moved(to.x(), to.y(), to.z());
  pose.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  return pose;
}

TriangleMesh fine(TriangleMesh mesh, int times) {
  for (int i = 0; i < times; ++i) mesh = test::split(mesh);
  return mesh;
}

const TriangleMesh kCube = test::box_triangles(Vector3d::Constant(0.1));
const TriangleMesh kSlab = test::box_triangles(Vector3d(1.0, 1.0, 0.1));

Manifold manifold_of(const TriangleMesh& a, const Isometry3d& pose_a, const TriangleMesh& b,
                     const Isometry3d& pose_b) {
  const ContactMesh mesh_a(a), mesh_b(b);
  ManifoldFinder finder;
  finder.reserve(mesh_a);
  finder.reserve(mesh_b);
  Manifold manifold;
  const bool touches = finder.between(mesh_a, pose_a, mesh_b, pose_b, manifold);
  EXPECT_EQ(touches, manifold.count > 0);
  return manifold;
}

Manifold on_slab(const TriangleMesh& a, const Isometry3d& pose, int splits = 0) {
  return manifold_of(a, pose, fine(kSlab, splits), Isometry3d::Identity());
}

double deepest(const Manifold& m) {
  double depth = 0.0;
  for (int i = 0; i < m.count; ++i) depth = std::max(depth, m.point[at(i)].depth);
  return depth;
}

double worst_degrees(const Manifold& m, const Vector3d& normal) {
  double worst = 0.0;
  for (int i = 0; i < m.count; ++i) {
    const double cosine = m.point[at(i)].normal.dot(normal);
    worst = std::max(worst, std::acos(std::clamp(cosine, -1.0, 1.0)) / kDegree);
  }
  return worst;
}

double within(Random& random, double most) { return most * (2.0 * random.uniform() - 1.0); }

// At most eight, all of them apart, finite and deep.
void expect_sound(const Manifold& m) {
  EXPECT_LE(m.count, Manifold::kMost);
  for (int i = 0; i < m.count; ++i) {
    const ManifoldPoint& p = m.point[at(i)];
    EXPECT_TRUE(p.position.allFinite() && p.normal.allFinite());
    EXPECT_NEAR(p.normal.norm(), 1.0, 1e-9);
    EXPECT_GT(p.depth, 0.0);
    for (int k = 0; k < i; ++k) {
      EXPECT_GT((p.position - m.point[at(k)].position).norm(), 1e-9);
    }
  }
}

// The same points in any order, found from the other side or in other axes.
void expect_same(const Manifold& a, const Manifold& b, const Isometry3d& b_to_a, double normal_sign,
                 double tolerance) {
  ASSERT_EQ(a.count, b.count);
  for (int i = 0; i < a.count; ++i) {
    const ManifoldPoint& p = a.point[at(i)];
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < b.count; ++k) {
      const ManifoldPoint& q = b.point[at(k)];
      const Vector3d normal = normal_sign * (b_to_a.linear() * q.normal);
      nearest = std::min(nearest, (p.position - b_to_a * q.position).norm() +
                                      (p.normal - normal).norm() + std::abs(p.depth - q.depth));
    }
    EXPECT_LT(nearest, tolerance) << i;
  }
}

// The four corners of a square of 0.1 m in these axes, pushed straight up.
void expect_square(const Manifold& m, const Isometry3d& axes, double depth, double tolerance) {
  expect_sound(m);
  ASSERT_EQ(m.count, 4);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1e-6);
  for (int i = 0; i < 4; ++i) {
    const ManifoldPoint& p = m.point[at(i)];
    EXPECT_NEAR(p.depth, depth, 1e-12);
    const Vector3d local = axes.inverse() * p.position;
    EXPECT_NEAR(std::abs(local.x()), 0.05, tolerance);
    EXPECT_NEAR(std::abs(local.y()), 0.05, tolerance);
  }
}

// The four cases whose answer other libraries miss: 5 mm deep, straight up.
TEST(Manifold, CubeOnSlabStandsOnItsFourCorners) {
  for (const double yaw : {0.0, 0.3}) {
    for (const int splits : {0, 3}) {
      SCOPED_TRACE(std::to_string(yaw) + " " + std::to_string(splits));
      const Isometry3d pose = turned(yaw, Vector3d::UnitZ(), {0.0, 0.0, 0.095});
      const Manifold m = on_slab(fine(kCube, splits), pose, splits);
      expect_square(m, pose, 0.005, 1e-12);
    }
  }
}

TEST(Manifold, SphereOnSlabIsAsDeepAsItIs) {
  const Manifold m = on_slab(test::sphere_triangles(0.05, 4), moved(0.013, 0.007, 0.095), 3);
  expect_sound(m);
  EXPECT_NEAR(deepest(m), 0.005, 1e-4);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 2.0);
}

TEST(Manifold, SpheresTouchAlongTheLineOfTheirCentres) {
  const TriangleMesh sphere = test::sphere_triangles(0.05, 4);
  const Vector3d along = Vector3d(0.3, -0.5, 0.7).normalized();
  const Vector3d to = 0.096 * along;
  const Manifold m =
      manifold_of(sphere, moved(to.x(), to.y(), to.z()), sphere, Isometry3d::Identity());
  expect_sound(m);
  EXPECT_GT(m.count, 0);
  EXPECT_NEAR(deepest(m), 0.004, 2.5e-4);  // corners of a polyhedron, not a sphere
  EXPECT_LT(worst_degrees(m, along), 2.0);
}

TEST(Manifold, OrderOfTheBodiesOnlyTurnsTheNormals) {
  const ContactMesh cube(fine(kCube, 1)), slab(kSlab), sphere(test::sphere_triangles(0.05, 3));
  ManifoldFinder finder;
  for (const ContactMesh* mesh : {&cube, &slab, &sphere}) finder.reserve(*mesh);
  const Isometry3d tilted = turned(0.07, {0.3, 1.0, 0.2}, {0.11, -0.07, 0.097});
  for (const ContactMesh* upper : {&cube, &sphere}) {
    Manifold one, other;
    ASSERT_TRUE(finder.between(*upper, tilted, slab, Isometry3d::Identity(), one));
    ASSERT_TRUE(finder.between(slab, Isometry3d::Identity(), *upper, tilted, other));
    expect_same(one, other, Isometry3d::Identity(), -1.0, 1e-9);
  }
}

TEST(Manifold, TurningTheWorldTurnsTheManifold) {
  const ContactMesh cube(kCube), slab(kSlab);
  ManifoldFinder finder;
  finder.reserve(cube);
  finder.reserve(slab);
  const Isometry3d pose = turned(0.05, {1.0, 0.4, 0.0}, {0.02, 0.03, 0.096});
  Manifold still;
  ASSERT_TRUE(finder.between(cube, pose, slab, Isometry3d::Identity(), still));
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Vector3d axis(within(random, 1), within(random, 1), within(random, 1));
    const Isometry3d world = turned(within(random, 3), axis, 3.0 * axis);
    Manifold m;
    ASSERT_TRUE(finder.between(cube, world * pose, slab, world, m));
    expect_same(m, still, world, 1.0, 1e-9);
  }
}

TEST(Manifold, CrossedBeamsTouchWhereTheyCross) {
  const TriangleMesh beam = test::box_triangles(Vector3d(1.0, 0.1, 0.1));
  const Manifold m = manifold_of(beam, moved(0.0, 0.0, 0.097), beam,
                                 turned(std::numbers::pi / 2, Vector3d::UnitZ(), Vector3d::Zero()));
  expect_square(m, Isometry3d::Identity(), 0.003, 1e-9);
}

TEST(Manifold, CrossedEdgesArePushedApartSquareToBoth) {
  // Square beams on edge, one along x, one along y.
  const double edge = 0.1 / std::sqrt(2.0);
  const TriangleMesh beam = test::box_triangles(Vector3d(1.0, 0.1, 0.1));
  const Isometry3d below = turned(std::numbers::pi / 4, Vector3d::UnitX(), Vector3d::Zero());
  const Isometry3d above =
      turned(std::numbers::pi / 2, Vector3d::UnitZ(), {0, 0, 2 * edge - 0.002}) *
      turned(std::numbers::pi / 4, Vector3d::UnitX(), Vector3d::Zero());
  const Manifold m = manifold_of(beam, above, beam, below);
  expect_sound(m);
  ASSERT_GT(m.count, 0);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1e-6);
  EXPECT_NEAR(deepest(m), 0.002, 1e-9);
}

TEST(Manifold, CornerInAFaceIsOnePoint) {
  // A cube on its corner.
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::Ones(), -Vector3d::UnitZ()).toRotationMatrix();
  pose.translation().z() = 0.05 + 0.05 * std::sqrt(3.0) - 0.004;
  const Manifold m = on_slab(kCube, pose);
  expect_sound(m);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.point[0].depth, 0.004, 1e-12);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1e-6);
}

TEST(Manifold, BlockInAGrooveIsUnderBothFaces) {
  // A V of two slabs as one set; a block on edge lies in it, 1 mm into each side.
  TriangleMesh groove;
  groove.points = {{-1, -1, 1}, {1, -1, 1}, {0, -1, 0}, {-1, 1, 1}, {1, 1, 1}, {0, 1, 0},
                   {-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}};
  groove.triangles = {{0, 2, 5}, {0, 5, 3}, {2, 1, 4}, {2, 4, 5},    // the V
                      {6, 8, 9}, {6, 9, 7},                          // bottom
                      {0, 3, 8}, {0, 8, 6}, {1, 7, 9}, {1, 9, 4},    // sides
                      {0, 6, 2}, {6, 7, 2}, {7, 1, 2},               // ends
                      {3, 5, 8}, {8, 5, 9}, {9, 5, 4}};
  const double lift = 0.1 / std::sqrt(2.0) - 0.001 * std::sqrt(2.0);
  const TriangleMesh block = test::box_triangles(Vector3d(0.1, 1.0, 0.1));
  const Manifold m =
      manifold_of(block, turned(std::numbers::pi / 4, Vector3d::UnitY(), {0, 0, lift}), groove,
                  Isometry3d::Identity());
  expect_sound(m);
  int left = 0, right = 0;
  for (int i = 0; i < m.count; ++i) {
    const ManifoldPoint& p = m.point[at(i)];
    EXPECT_NEAR(p.depth, 0.001, 1e-9);
    left += p.normal.isApprox(Vector3d(1, 0, 1).normalized(), 1e-9) ? 1 : 0;
    right += p.normal.isApprox(Vector3d(-1, 0, 1).normalized(), 1e-9) ? 1 : 0;
  }
  EXPECT_GE(left, 1);
  EXPECT_GE(right, 1);
  EXPECT_EQ(left + right, m.count);
}

// The same once more, 0.5 m on and 50 mm up.
TriangleMesh on_two_levels(TriangleMesh mesh) {
  TriangleMesh other = mesh;
  for (Vector3d& p : other.points) p += Vector3d(0.5, 0.0, 0.05);
  append(other, mesh);
  return mesh;
}

TEST(Manifold, FeetOfATableShareTheEightPoints) {
  const TriangleMesh feet = on_two_levels(test::box_triangles(Vector3d(0.1, 0.1, 0.1)));
  const TriangleMesh treads = on_two_levels(test::box_triangles(Vector3d(0.3, 0.3, 0.1)));
  const Manifold m = manifold_of(feet, moved(0.0, 0.0, 0.098), treads, Isometry3d::Identity());
  expect_sound(m);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1e-6);
  EXPECT_NEAR(deepest(m), 0.002, 1e-12);
  double least = 1.0, most = -1.0;
  for (int i = 0; i < m.count; ++i) {
    least = std::min(least, m.point[at(i)].position.x());
    most = std::max(most, m.point[at(i)].position.x());
  }
  EXPECT_NEAR(least, -0.05, 1e-9);
  EXPECT_NEAR(most, 0.55, 1e-9);
}

TEST(Manifold, DeepAndWhollyInside) {
  // Half way in, upwards; wholly inside, out of the nearest face.
  const Manifold half = on_slab(kCube, moved(0.1, 0.0, 0.05));
  expect_sound(half);
  EXPECT_LT(worst_degrees(half, Vector3d::UnitZ()), 1e-6);
  EXPECT_NEAR(deepest(half), 0.05, 1e-9);
  const TriangleMesh small = test::box_triangles(Vector3d::Constant(0.02));
  const Manifold inside = on_slab(small, moved(0.1, 0.0, 0.03));
  expect_sound(inside);
  EXPECT_LT(worst_degrees(inside, Vector3d::UnitZ()), 1e-6);
  EXPECT_NEAR(deepest(inside), 0.03, 1e-9);
  const Manifold around = manifold_of(kSlab, Isometry3d::Identity(), small, moved(0.1, 0.0, 0.03));
  expect_sound(around);
  EXPECT_LT(worst_degrees(around, -Vector3d::UnitZ()), 1e-6);
}

TEST(Manifold, ApartIsNothing) {
  EXPECT_EQ(on_slab(kCube, moved(0.0, 0.0, 0.1001)).count, 0);
  EXPECT_EQ(on_slab(kCube, moved(0.0, 0.0, 0.1)).count, 0);  // faces that just touch
  EXPECT_EQ(on_slab(kCube, moved(3.0, 0.0, 0.0)).count, 0);
}

TEST(Manifold, FacesFlushWithAFaceOfTheOther) {
  // A cube flush with two sides of the slab: faces that lie in one another.
  const Manifold m = on_slab(kCube, moved(0.45, 0.45, 0.097));
  expect_sound(m);
  EXPECT_GT(m.count, 0);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1e-6);
  EXPECT_NEAR(deepest(m), 0.003, 1e-9);
}

TEST(Manifold, BadTrianglesAreLeftOutAndBadNumbersRefused) {
  TriangleMesh cube = kCube;
  cube.points.push_back(cube.points[0]);                   // the same corner again
  cube.points.push_back(0.5 * (cube.points[0] + cube.points[1]));
  cube.triangles.push_back({0, 1, 9});                     // no area
  cube.triangles.push_back({0, 8, 1});                     // none either, once they are joined
  const Manifold m = on_slab(cube, moved(0.0, 0.0, 0.095));
  expect_sound(m);
  EXPECT_EQ(m.count, 4);
  TriangleMesh line;
  line.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_THROW(ContactMesh{line}, std::runtime_error);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e30}) {
    TriangleMesh broken = kCube;
    broken.points[3].x() = bad;
    EXPECT_THROW(ContactMesh{broken}, std::runtime_error) << bad;
  }
  Isometry3d nowhere = moved(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_EQ(on_slab(kCube, nowhere).count, 0);
}

TEST(Manifold, InsideOutIsTurnedOver) {
  TriangleMesh cube = kCube;
  for (auto& t : cube.triangles) std::swap(t[0], t[1]);
  const Manifold m = on_slab(cube, moved(0.0, 0.0, 0.095));
  EXPECT_EQ(m.count, 4);
  EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1e-6);
}

// A tenth of a millimetre of motion turns no normal and makes nothing jump.
TEST(Manifold, LittleMotionChangesLittle) {
  const ContactMesh sphere(test::sphere_triangles(0.05, 4)), slab(kSlab);
  ManifoldFinder finder;
  finder.reserve(sphere);
  finder.reserve(slab);
  double before = 0.0;
  for (int i = 0; i < 100; ++i) {
    Manifold m;
    ASSERT_TRUE(finder.between(sphere, turned(1e-3 * i, {1, 2, 3}, {1e-4 * i, 0.0, 0.095}), slab,
                               Isometry3d::Identity(), m));
    EXPECT_LT(worst_degrees(m, Vector3d::UnitZ()), 1.0);
    if (i > 0) {
      EXPECT_NEAR(deepest(m), before, 1e-4);
    }
    before = deepest(m);
  }
}

TEST(Manifold, AnyPoseIsSoundAndTakesNoMemory) {
  const ContactMesh a(fine(kCube, 2)), b(test::sphere_triangles(0.07, 3));
  ManifoldFinder finder;
  finder.reserve(a);
  finder.reserve(b);
  Random random(11);
  int touching = 0;
  for (int i = 0; i < 500; ++i) {
    const Vector3d axis(within(random, 1), within(random, 1), within(random, 1));
    const Isometry3d pose = turned(within(random, 3), axis, 0.1 * axis);
    Manifold m;
    {
      const NoAlloc none;
      (void)finder.between(a, pose, b, Isometry3d::Identity(), m);
      EXPECT_EQ(none.count(), 0);
    }
    expect_sound(m);
    touching += m.count > 0 ? 1 : 0;
  }
  EXPECT_GT(touching, 200);
}

TEST(Manifold, OfTheGroundIsWhatIsBelowIt) {
  const ContactMesh cube(fine(kCube, 2));
  ManifoldFinder finder;
  finder.reserve(cube);
  Manifold m;
  EXPECT_FALSE(finder.with_ground(cube, moved(0, 0, 0.0501), m));
  ASSERT_TRUE(finder.with_ground(cube, moved(0.3, 0, 0.049), m));
  expect_sound(m);
  EXPECT_EQ(m.count, 4);
  EXPECT_NEAR(deepest(m), 0.001, 1e-12);
}

TEST(ContactMesh, WeighsWhatItHolds) {
  const ContactMesh box(test::box_triangles(Vector3d(0.2, 0.3, 0.4)));
  EXPECT_NEAR(box.volume(), 0.024, 1e-15);
  EXPECT_TRUE(box.closed());
  EXPECT_LT(box.middle().norm(), 1e-15);
  EXPECT_NEAR(box.inertia()(0, 0), 0.024 / 12 * (0.09 + 0.16), 1e-15);
  EXPECT_TRUE(box.contains({0.09, -0.14, 0.19}));
  EXPECT_FALSE(box.contains({0.11, 0.0, 0.0}));
}

}  // namespace
}  // namespace twinbus
