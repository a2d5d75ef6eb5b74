// Boxes whose edges cross, and hulls: by how much they overlap, and what the engines make of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "both_engines.h"
#include "common/math/random.h"
#include "geometry/bounds/convex_hull.h"
#include "geometry/mesh_contact/hull_overlap.h"
#include "geometry/mesh_contact/patch.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/objects/box_overlap.h"
#include "sim/objects/rigid_object_mesh.h"
#include "sim/engine/articulated_world.h"
#include "sim/engine/energy_balance.h"
#include "sim/scene/scene.h"
#include "test/rounds.h"
#include "sim/scene/scene_seed.h"
#include "common/allocation/no_alloc.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

Eigen::Isometry3d placed(const Eigen::Vector3d& at, double turn, const Eigen::Vector3d& axis) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = at;
  pose.linear() = Eigen::AngleAxisd(turn, axis.normalized()).toRotationMatrix();
  return pose;
}

LooseBody box(const std::string& name, double mass, const Eigen::Vector3d& size,
              const Eigen::Isometry3d& pose, double stiffness = 1e6) {
  return test::loose_box(name, mass, size, pose, stiffness, std::sqrt(0.25 * stiffness * mass));
}

// A beam 0.1 m thick on the ground, and another across it at this height of its middle [m] and turn [rad].
WorldConfig crossed_beams(double height, double turn) {
  WorldConfig config;
  config.step = 1e-3;
  config.loose = {box("low", 2.0, {1.0, 0.1, 0.1}, placed({0, 0, 0.05}, 0, {0, 0, 1})),
                  box("high", 1.0, {0.1, 1.0, 0.1}, placed({0, 0, height}, turn, {0, 0, 1}))};
  return config;
}

TEST(BoxOverlap, IsTheLeastOfFacesAndCrossedEdges) {
  const Eigen::Vector3d half(0.5, 0.5, 0.5);
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  EXPECT_NEAR(box_overlap(still, half, placed({0.9, 0.1, 0}, 0, {1, 0, 0}), half).depth, 0.1, 1e-15);
  EXPECT_NEAR(box_overlap(still, half, placed({0, -1.25, 0}, 0, {1, 0, 0}), half).depth, -0.25, 1e-15);
  // A corner of a box on its edge in a face.
  EXPECT_NEAR(box_overlap(still, half, placed({0, 0, 1.2}, M_PI / 4, {1, 0, 0}), half).depth,
              0.5 + std::sqrt(0.5) - 1.2, 1e-15);
  // Both on an edge, these across one another: the edges are sqrt(1/2) from the middles.
  const Eigen::Isometry3d low = placed({0, 0, 0}, M_PI / 4, {1, 0, 0});
  const Eigen::Isometry3d high = placed({0, 0, 1.4}, M_PI / 4, {0, 1, 0});
  EXPECT_NEAR(box_overlap(low, half, high, half).depth, 2.0 * std::sqrt(0.5) - 1.4, 1e-15);
  EXPECT_NEAR(box_overlap(high, half, low, half).depth, 2.0 * std::sqrt(0.5) - 1.4, 1e-15);
}

// Under a face the corners of the other's face, cut off at its sides; no deeper than they overlap.
TEST(BoxOverlap, ItsPointsAreOfTheFaceThatIsCutOrWhereTheEdgesCross) {
  const Eigen::Vector3d half(0.5, 0.5, 0.5), beam(1.0, 0.05, 0.05);
  const Eigen::Isometry3d still = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d above = placed({0, 0, 0.54}, 0.3, {0, 0, 1});
  BoxOverlap overlap = box_overlap(above, beam, still, half);
  box_contact(above, beam, still, half, overlap);
  ASSERT_EQ(overlap.count, 4);
  EXPECT_NEAR(overlap.normal.z(), 1.0, 1e-12);
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d& p = overlap.point[static_cast<std::size_t>(i)];
    EXPECT_NEAR(overlap.deep[static_cast<std::size_t>(i)], 0.01, 1e-12);
    EXPECT_NEAR(p.z(), 0.495, 1e-12);
    EXPECT_NEAR(std::abs(p.x()), 0.5, 1e-12);  // cut where the beam leaves the block
  }
  const Eigen::Isometry3d low = placed({0.1, 0, 0}, M_PI / 4, {1, 0, 0});
  const Eigen::Isometry3d high = placed({0, 0.2, 1.4}, M_PI / 4, {0, 1, 0});
  overlap = box_overlap(high, half, low, half);
  box_contact(high, half, low, half, overlap);
  ASSERT_EQ(overlap.count, 1);
  EXPECT_NEAR((overlap.normal - Eigen::Vector3d::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((overlap.point[0] - Eigen::Vector3d(0.0, 0.0, 0.7)).norm(), 0.0, 1e-12);
}

TWINBUS_BOTH_ENGINES(BoxEdges);

// No corner of either is in the other.
TEST_P(BoxEdges, ABeamLiesAcrossABeam) {
  const Model model = test::bystander();
  const auto world = make_at(Configuration(model), model, crossed_beams(0.151, 0));
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(1).pose.translation().z(), 0.15, 2e-4);
  EXPECT_LT(world->loose(1).velocity.norm(), 2e-3);
}

// Dropped edge on edge, the lower one fixed: it rebounds or slides off, and never has more energy
// than it fell with.
TEST_P(BoxEdges, AnEdgeThatFallsOnAnEdgeGainsNothing) {
  const Model model = test::bystander();
  WorldConfig config;
  config.step = 1e-3;
  Obstacle low;
  low.shape = ObstacleShape::kBox;
  low.size << 0.4, 0.4, 0.4;
  low.pose = placed({0, 0, 0.5}, M_PI / 4, {1, 0, 0});
  config.obstacles = {low};
  const Eigen::Isometry3d start = placed({0.003, 0.002, 1.0}, M_PI / 4, {0, 1, 0});
  config.loose = {box("high", 0.1, {0.1, 0.1, 0.1}, start, 1e5)};
  const auto world = make(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  const double edge = 0.5 + 0.2 * std::sqrt(2.0) + 0.05 * std::sqrt(2.0);  // of the middle, touching
  double lowest = 1.0, highest_after = 0.0;
  for (int i = 0; i < 700; ++i) {
    ASSERT_EQ(world->step(), Status::kOk);
    const double z = world->loose(0).pose.translation().z();
    if (i < 300) lowest = std::min(lowest, z);
    if (i > 250) highest_after = std::max(highest_after, z);
  }
  EXPECT_LT(highest_after, 1.0);
  EXPECT_GT(lowest, edge - 0.02);
}

TEST(BoxEdgesOfOurs, MeetingAllocatesNothing) {
  const Model model = test::bystander();
  ArticulatedWorld world(model, crossed_beams(0.16, 0.3));
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  test::step_without_allocation(world, 300);
  EXPECT_NEAR(world.loose(1).pose.translation().z(), 0.15, 2e-4);
}

// Of the scene only what is loose, begun elsewhere by up to 5 mm, 20 times.
TEST(BoxEdgesOfOurs, NothingIsFlungWhereBoxesTumble) {
  const Model model = test::bystander();
  for (std::uint64_t seed = 1; seed <= test::rounds(std::uint64_t{20}); ++seed) {
    Scene scene = load_scene("boxes_tumble");
    apply_seed(scene, Model{}, seed);
    for (const int order : {1, 2}) {
      WorldConfig config;
      config.step = 1e-3;
      config.order = order;
      config.loose = scene.loose;
      ArticulatedWorld world(model, config);
      ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
      double highest = 0.0;
      for (int i = 0; i < 1500; ++i) {
        ASSERT_EQ(world.step(), Status::kOk);
        for (int b = 0; b < world.loose_count(); ++b)
          highest = std::max(highest, world.loose(b).pose.translation().z());
      }
      EXPECT_LT(highest, 1.5) << "seed " << seed << " order " << order;
    }
  }
}

// It holds by 1 % more friction than it needs; at order 3 nothing may make it ring on.
TEST(LyingStill, ABrickThatHoldsOnASlopeDoesNotCreepAtAnyOrder) {
  const Model model = test::bystander();
  const Eigen::Isometry3d slope = placed({4, 3, 1}, 20.0 * M_PI / 180.0, {0, 1, 0});
  for (const int order : {1, 2, 3}) {
    WorldConfig config;
    config.step = 5e-5;
    config.order = order;
    config.ground_friction = 1.0;
    Obstacle ground;
    ground.shape = ObstacleShape::kBox;
    ground.size << 4, 6, 0.2;
    ground.pose = slope;
    config.obstacles = {ground};
    LooseBody brick = box("brick", 2.0, {0.4, 0.3, 0.1}, slope, 1e8);
    brick.start.pose.translation() = Eigen::Vector3d(2.923672, 3, 1.551378);
    brick.friction = 0.1351371;
    config.loose = {brick};
    ArticulatedWorld world(model, config);
    ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
    for (int i = 0; i < 8000; ++i) ASSERT_EQ(world.step(), Status::kOk);
    const Eigen::Vector3d way = world.loose(0).pose.translation() - brick.start.pose.translation();
    EXPECT_LT(std::abs(slope.linear().col(0).dot(way)), 2e-6) << order;
    EXPECT_LT(world.loose(0).velocity.norm(), 1e-8) << order;
  }
}

// A corner in the rim of a thin plate was pushed out along the plate, through half of it: with up to 120 J in a step.
TEST(BoxEdges, PlatesThatFallOnOneAnotherAreNotFlung) {
  const Model model = test::bystander();
  for (const std::uint64_t seed : {120U, 260U, 297U, 740U}) {
    Scene scene = load_scene("pile_plates");
    apply_seed(scene, model, seed);
    WorldConfig config;
    config.step = 1e-3;
    config.fixed_base = true;
    config.ground_friction = scene.ground_friction;
    config.loose = scene.loose;
    const auto world = make_world(model, config);
    ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
    EnergyBalance balance(model, config);
    balance.begin(*world);
    double highest = 0.0, gained = 0.0;
    for (int i = 0; i < 1000; ++i) {
      ASSERT_EQ(world->step(), Status::kOk);
      (void)balance.add(*world, 0.0);
      gained = std::max(gained, balance.gain());
      for (int b = 0; b < world->loose_count(); ++b) highest = std::max(highest, world->loose(b).pose.translation().z());
    }
    EXPECT_LT(highest, 1.5) << seed;  // from where the highest falls
    EXPECT_LT(gained, 1.0) << seed;
  }
}

TWINBUS_BOTH_ENGINES(FixedBase);

// Wherever the base is, its pendulum swings as at the origin.
TEST_P(FixedBase, APendulumSwingsTheSameWhereverItsBaseIs) {
  const Model model = test::pendulum();
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-3;
  const auto swing = [&](const Eigen::Isometry3d& base) {
    const auto world = make(model, config);
    Configuration start(model);
    start.base = base;
    start.q[0] = 0.5;
    EXPECT_EQ(world->set(start), Status::kOk);
    (void)world->set_servo(0, {});
    for (int i = 0; i < 400; ++i) EXPECT_EQ(world->step(), Status::kOk);
    const Eigen::Vector3d hinge = base.inverse() * world->link_in_world(1).translation();
    EXPECT_NEAR((hinge - Eigen::Vector3d(0, 0, 2)).norm(), 0.0, 1e-3);
    return world->configuration().q[0];
  };
  const double here = swing(Eigen::Isometry3d::Identity());
  const double there = swing(placed({3, -2, 5}, 1.0, {0, 0, 1}));
  EXPECT_LT(here, 0.3);
  EXPECT_NEAR(here, there, 1e-6);
}

// A prism on a polygon of so many corners about the vertical.
TriangleMesh prism(int corners, double radius, double height) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    for (const double side : {-0.5, 0.5}) points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), side * height);
  }
  return convex_hull(points);
}

double polygon_area(int corners, double radius) { return 0.5 * corners * radius * radius * std::sin(2.0 * std::numbers::pi / corners); }

Eigen::Isometry3d drawn(Random& random, double most) {
  const auto within = [&](double bound) { return bound * (2.0 * random.uniform() - 1.0); };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const double x = within(most), y = within(most), z = within(most);
  pose.translation() = Eigen::Vector3d(x, y, z);
  const double a = within(1.0), b = within(1.0), c = within(1.0), angle = within(std::numbers::pi);
  pose.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d(a, b, c).normalized()).toRotationMatrix();
  return pose;
}

// All fifteen directions of two boxes, against what hulls of the same corners find.
TEST(HullOverlap, BoxesOfTrianglesOverlapAsBoxesDo) {
  Random random(7);
  const Eigen::Vector3d size_a(0.2, 0.3, 0.1), size_b(0.15, 0.25, 0.35);
  const auto a = mesh_of({SolidShape::kBox, size_a}), b = mesh_of({SolidShape::kBox, size_b});
  ASSERT_TRUE(is_hull(*a));
  int over = 0, crossing = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Isometry3d pose_a = drawn(random, 0.15), pose_b = drawn(random, 0.15);
    const BoxOverlap boxes = box_overlap(pose_a, 0.5 * size_a, pose_b, 0.5 * size_b);
    const HullOverlap hulls = hull_overlap(*a, pose_a, *b, pose_b);
    ASSERT_EQ(hulls.depth > 0.0, boxes.depth > 0.0) << i;
    // Half through one another, edges that cross may lie outside of what overlaps along the best face.
    if (!(boxes.depth > 0.0 && boxes.depth < 0.05)) continue;
    ++over;
    crossing += boxes.axis >= 6 ? 1 : 0;
    ASSERT_NEAR(hulls.depth, boxes.depth, 1e-12) << i;
    ASSERT_NEAR(hulls.normal.dot(boxes.normal), 1.0, 1e-9) << i;
  }
  EXPECT_GT(over, 500);
  EXPECT_GT(crossing, 30);
}

TEST(HullOverlap, WhatIsNotConvexIsNoHull) {
  EXPECT_TRUE(is_hull(ContactMesh(prism(12, 0.1, 0.2))));
  TriangleMesh dented = prism(12, 0.1, 0.2);
  dented.points[0] *= 0.5;
  EXPECT_FALSE(is_hull(ContactMesh(dented)));
}

// A prism is moved over the edge of a box in 0.1 mm: its force never changes by more than 2 % of the whole.
TEST(HullOverlap, AnEdgeIsCrossedWithoutAJump) {
  const ContactMesh own(prism(9, 0.05, 0.1)), box(*mesh_of({SolidShape::kBox, {0.4, 0.4, 0.2}}));
  PatchFinder finder;
  Eigen::Isometry3d under = Eigen::Isometry3d::Identity();
  under.translation().z() = -0.1;
  constexpr double kDeep = 5e-4;
  double before = -1.0, whole = 0.0, most = 0.0;
  for (int i = 0; i <= 1200; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(0.14 + 1e-4 * i, 0.02, 0.05 - kDeep);
    Patch patch;
    NoAlloc guard;
    const HullOverlap overlap = hull_overlap(own, pose, box, under);
    const bool presses = overlap.depth > 0.0 && finder.between(own, pose, box, under, overlap.normal, 1.5 * overlap.depth + 1e-4, patch);
    ASSERT_EQ(guard.count(), 0);
    const double force = presses ? patch.volume * patch.normal.z() : 0.0;
    if (i == 0) whole = force;
    if (before >= 0.0) most = std::max(most, std::abs(force - before));
    before = force;
  }
  EXPECT_NEAR(whole, kDeep * polygon_area(9, 0.05), 1e-3 * whole);
  EXPECT_LT(most, 0.02 * whole);
  EXPECT_LT(before, 0.02 * whole);  // it has left the box
}

// m g = k A d: as deep as the springs of the area say, which points of a manifold do not give.
TEST(HullPatch, APrismOfTrianglesSinksAsFarAsItsAreaSays) {
  for (const int corners : {5, 8, 12}) {
    const Model model = test::bystander();
    WorldConfig config;
    config.contact = ContactModel::kPatch;
    config.step = 1e-3;
    config.obstacles.push_back({ObstacleShape::kBox, {1.0, 1.0, 0.2}, Eigen::Isometry3d(Eigen::Translation3d(5, 0, 0.9))});
    LooseBody body;
    body.name = "prism";
    body.mass = 3.0;
    body.stiffness = 2e4;
    body.damping = 200.0;
    body.start.pose.translation() = Eigen::Vector3d(5.0, 0.0, 1.05);
    give_mesh(prism(corners, 0.06, 0.1), body);
    const double per_area = 4.0 / mean_face(body.solid, body.mesh.get());
    config.loose.push_back(body);
    const auto world = make_world(model, config);
    ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
    for (int i = 0; i < 3000; ++i) ASSERT_EQ(world->step(), Status::kOk);
    const double deep = 1.05 - world->loose(0).pose.translation().z();
    const double expected = body.mass * kGravity / (body.stiffness * per_area * polygon_area(corners, 0.06));
    EXPECT_NEAR(deep, expected, 0.02 * expected) << corners;
    EXPECT_LT(world->loose(0).velocity.norm(), 2e-3) << corners;
  }
}

}  // namespace
}  // namespace twinbus
