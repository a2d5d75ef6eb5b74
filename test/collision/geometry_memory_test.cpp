#include "robot/collision/links/geometry_cache.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

#include "common/file/disk_cache.h"
#include "common/math/index.h"
#include "robot/collision/links/inscribed_spheres.h"
#include "robot/collision/exact/posture_cells_cache.h"
#include "robot/description/load.h"
#include "common/file/byte_pack.h"
#include "geometry/bounds/triangle_clusters.h"
#include "test/collision/post_and_arm.h"
#include "test/collision/postures.h"
#include "test/temporary_folder.h"

namespace twinbus {
namespace {

namespace fs = std::filesystem;

std::vector<Shape> some_shapes() {
  Shape box, rod;
  box.size = {0.1, 0.2, 0.3};
  rod.kind = ShapeKind::kCylinder;
  rod.size = {0.05, 0.4, 0.0};
  rod.pose.translation() = Eigen::Vector3d(0.05, 0.0, 0.1);
  return {box, rod};
}

struct GeometryMemory : testing::Test {
  test::TemporaryFolder folder;
  std::vector<std::string> said;

  GeometryMemory() {
    disk_cache() = DiskCache(folder.path());
    disk_cache().say = [this](const std::string& line) { said.push_back(line); };
  }
  ~GeometryMemory() override { disk_cache() = DiskCache(); }

  std::vector<fs::path> files(const std::string& kind) const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (entry.path().extension() == "." + kind) all.push_back(entry.path());
    }
    return all;
  }
};

template <class Item>
bool same_bytes(const std::vector<Item>& a, const std::vector<Item>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0;
}

void expect_same(const LinkGeometry& a, const LinkGeometry& b) {
  EXPECT_TRUE(same_bytes(a.mesh.points, b.mesh.points));
  EXPECT_TRUE(same_bytes(a.hull.points, b.hull.points));
  EXPECT_TRUE(same_bytes(a.hull.triangles, b.hull.triangles));
  EXPECT_TRUE(same_bytes(a.clusters, b.clusters));
  EXPECT_EQ(a.sphere.center, b.sphere.center);
  EXPECT_EQ(a.sphere.radius, b.sphere.radius);
  EXPECT_EQ(a.capsule.a, b.capsule.a);
  EXPECT_EQ(a.capsule.b, b.capsule.b);
  EXPECT_EQ(a.capsule.radius, b.capsule.radius);
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
}

TriangleMesh egg() {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  TriangleMesh mesh;
  for (int i = 0; i < 1500; ++i) {
    const Eigen::Vector3d d(normal(random), normal(random), normal(random));
    mesh.points.push_back(Eigen::Vector3d(0.2, 0.1, 0.05).cwiseProduct(d.normalized()));
    if (i >= 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  return mesh;
}

TEST_F(GeometryMemory, CoarseHullsAreTheSameWhetherKeptOrNotAndMustHoldTheMesh) {
  disk_cache() = DiskCache();
  const TriangleMesh mesh = egg(), found = kept_coarse_hull(mesh).value();
  disk_cache() = DiskCache(folder.path());
  disk_cache().say = [this](const std::string& line) { said.push_back(line); };
  for (int run = 0; run < 2; ++run) {  // keeps, then recalls
    const TriangleMesh kept = kept_coarse_hull(mesh).value();
    EXPECT_TRUE(same_bytes(kept.points, found.points));
    EXPECT_TRUE(same_bytes(kept.triangles, found.triangles));
  }
  ASSERT_EQ(files("coarse").size(), 1u);
  EXPECT_TRUE(said.empty());
  // The corners of a smaller egg do not hold this one.
  TriangleMesh smaller = mesh;
  for (Eigen::Vector3d& p : smaller.points) p *= 0.9;
  const Fingerprint key = fingerprint_of(mesh).value(), other = fingerprint_of(smaller).value();
  ASSERT_TRUE(kept_coarse_hull(smaller));
  disk_cache().keep("coarse", key, disk_cache().find("coarse", other).value());
  EXPECT_TRUE(same_bytes(kept_coarse_hull(mesh).value().points, found.points));
  EXPECT_EQ(said.size(), 1u);
  disk_cache().keep("coarse", key, "nonsense");
  EXPECT_TRUE(same_bytes(kept_coarse_hull(mesh).value().points, found.points));
}

TEST_F(GeometryMemory, GivesBackWhatWasFoundBitByBit) {
  disk_cache() = DiskCache();
  const LinkGeometry found = link_geometry(some_shapes());
  const std::vector<Ball> inner = inner_balls(found, 24, 8);
  const Capsule capsule = kept_capsule(found.hull.points);
  disk_cache() = DiskCache(folder.path());
  for (int run = 0; run < 2; ++run) {  // keeps, then recalls
    expect_same(link_geometry(some_shapes()), found);
    EXPECT_TRUE(same_bytes(inner_balls(found, 24, 8), inner));
    EXPECT_EQ(kept_capsule(found.hull.points).a, capsule.a);
    EXPECT_EQ(kept_capsule(found.hull.points).radius, capsule.radius);
  }
  EXPECT_EQ(files("bounds").size(), 1U);
  EXPECT_EQ(files("inner").size(), 1U);
  EXPECT_EQ(files("capsule").size(), 1U);
  EXPECT_TRUE(said.empty());
}

TEST_F(GeometryMemory, IsOfTheMesh) {
  (void)link_geometry(some_shapes());
  (void)link_geometry(some_shapes());
  std::vector<Shape> others = some_shapes();
  others[0].size.x() += 1e-9;
  (void)link_geometry(others);
  EXPECT_EQ(files("bounds").size(), 2U);
}

TEST_F(GeometryMemory, RecallsInsteadOfFinding) {
  LinkGeometry link = link_geometry(some_shapes());
  link.hull = {};
  link.clusters.clear();
  EXPECT_TRUE(recall_bounds(link));
  EXPECT_FALSE(link.clusters.empty());
  link.mesh.points[0].x() += 1e-9;
  EXPECT_FALSE(recall_bounds(link));
}

TEST_F(GeometryMemory, WhatDoesNotHoldTheMeshIsRefusedThoughItsFileIsWhole) {
  const LinkGeometry good = link_geometry(some_shapes());
  std::vector<int> order;
  (void)triangle_clusters(good.mesh, order);
  std::string why;
  const auto accepted = [&](const LinkGeometry& changed, const std::vector<int>& by) {
    LinkGeometry link = good;
    const bool taken = unpack_bounds(packed_bounds(changed, by), link, why);
    if (!taken) expect_same(link, good);  // as it was
    return taken;
  };
  EXPECT_TRUE(accepted(good, order)) << why;
  const auto refused = [&](auto change) {
    LinkGeometry link = good;
    std::vector<int> by = order;
    change(link, by);
    return !accepted(link, by);
  };
  using Order = std::vector<int>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.sphere.radius -= 2e-6; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.sphere.radius = 1e9; }));
  EXPECT_TRUE(refused([&](LinkGeometry& g, Order&) { g.sphere.center.x() = nan; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.capsule.radius -= 2e-6; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.capsule.b = g.capsule.a; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.clusters[0].radius -= 2e-6F; }));
  EXPECT_TRUE(
      refused([&](LinkGeometry& g, Order&) { g.clusters[0].radius = static_cast<float>(nan); }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { ++g.clusters[0].count; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.clusters[0].count = 0; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.clusters.pop_back(); }));
  EXPECT_TRUE(refused([](LinkGeometry&, Order& o) { o[0] = o[1]; }));
  EXPECT_TRUE(refused([](LinkGeometry&, Order& o) { o[0] = -1; }));
  EXPECT_TRUE(refused([](LinkGeometry&, Order& o) { o[0] = 1 << 30; }));
  EXPECT_TRUE(refused([](LinkGeometry&, Order& o) { o.pop_back(); }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.hull.triangles.pop_back(); }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.hull.triangles[0][0] = 1 << 20; }));
  EXPECT_TRUE(refused(
      [](LinkGeometry& g, Order&) { std::swap(g.hull.triangles[0][0], g.hull.triangles[0][1]); }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) { g.hull.points[0] *= 0.99; }));
  EXPECT_TRUE(refused([](LinkGeometry& g, Order&) {  // a hull of its own, but a smaller one
    g.hull.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    g.hull.points.resize(4);
  }));
}

TEST_F(GeometryMemory, ARandomlyDamagedContentNeverGivesBoundsThatDoNotHold) {
  const LinkGeometry good = link_geometry(some_shapes());
  std::vector<int> order;
  (void)triangle_clusters(good.mesh, order);
  const std::string bytes = packed_bounds(good, order);
  std::mt19937 random(5);
  int taken = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string damaged = bytes;
    for (int k = 0; k <= i % 4; ++k)
      damaged[random() % damaged.size()] = static_cast<char>(random());
    if (i % 10 == 0) damaged.resize(random() % damaged.size());
    LinkGeometry link = good;
    std::string why;
    if (!unpack_bounds(damaged, link, why)) continue;
    ++taken;
    EXPECT_NO_THROW(verify(link));
  }
  EXPECT_LT(taken, 600);
}

TEST_F(GeometryMemory, BallsThatAreNotInsideAreRefused) {
  const LinkGeometry link = link_geometry(some_shapes());
  std::vector<Ball> balls = inner_balls(link, 24, 8);
  ASSERT_FALSE(balls.empty());
  EXPECT_TRUE(are_inside(link, balls));
  const auto refused = [&](const Ball& ball) {
    std::vector<Ball> with = balls;
    with.push_back(ball);
    keep_inner_balls(link, 24, 8, with);
    std::vector<Ball> found;
    return !recall_inner_balls(link, 24, 8, found) && found.empty();
  };
  EXPECT_TRUE(refused({Eigen::Vector3d(1.0, 0.0, 0.0), 0.01}));  // outside, near nothing
  EXPECT_TRUE(refused({balls[0].center, balls[0].radius + 1e-4}));
  EXPECT_TRUE(refused({balls[0].center, -1.0}));
  EXPECT_TRUE(refused({balls[0].center, std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_TRUE(refused({Eigen::Vector3d(0.01, 0.02, 0.03), 0.0}));  // no corner of the hull
  EXPECT_EQ(said.size(), 5U);
}

TEST_F(GeometryMemory, ACapsuleThatLeavesAPointOutIsFoundAnew) {
  const std::vector<Eigen::Vector3d> points = link_geometry(some_shapes()).hull.points;
  const Capsule capsule = kept_capsule(points);
  const Fingerprint key = fingerprint_of_code().add_all(points).value();
  const std::string content = disk_cache().find("capsule", key).value();
  std::string small = content;
  const double radius = 0.5 * capsule.radius;
  std::memcpy(small.data() + 3 * sizeof(double), &radius, sizeof radius);
  disk_cache().keep("capsule", key, small);
  EXPECT_EQ(kept_capsule(points).radius, capsule.radius);
  EXPECT_EQ(said.size(), 1U);
  EXPECT_EQ(disk_cache().find("capsule", key), content);
}

struct CellsMemory : GeometryMemory {
  Model model = post_and_arm();
  RobotGeometry geometry = build_geometry(model);
  std::vector<CollisionPair> pairs{{0, 1}};
  std::vector<JointCells> cells = find_joint_cells(model, geometry, pairs);

  bool fits(const std::vector<JointCells>& some) const {
    std::string why;
    return unpack_cells(packed_cells(some), model, geometry, pairs, why).has_value();
  }
};

TEST_F(CellsMemory, AreReadAgainAndSayTheSame) {
  SelfCollision first(model, geometry, pairs), second(model, geometry, pairs),
      plain(model, geometry, pairs);
  EXPECT_FALSE(use_kept_cells(model, geometry, first));
  find_and_keep_cells(model, geometry, first);
  EXPECT_TRUE(use_kept_cells(model, geometry, second));
  for (int k = 0; k <= 400; ++k) {
    const Eigen::VectorXd q = Eigen::VectorXd::Constant(1, -2.0 + 0.01 * k);
    for (SelfCollision* check : {&first, &second, &plain}) check->place(q);
    const bool touches = plain.any_touching();
    EXPECT_EQ(first.any_touching(), touches) << k;
    EXPECT_EQ(second.any_touching(), touches) << k;
  }
  EXPECT_LT(second.work().rows, plain.work().rows);
  EXPECT_TRUE(said.empty());
}

TEST_F(CellsMemory, AreThoseOfTheLimitsAndTheGeometry) {
  SelfCollision check(model, geometry, pairs);
  find_and_keep_cells(model, geometry, check);
  Model other = model;
  other.joints[0].upper = 1.9;
  EXPECT_FALSE(use_kept_cells(other, geometry, check));
  other = model;
  other.links[1].collision[0].size.x() = 0.31;
  EXPECT_FALSE(use_kept_cells(other, build_geometry(other), check));
  EXPECT_TRUE(use_kept_cells(model, geometry, check));
}

TEST_F(CellsMemory, WhatCannotBeCellsOfThisRobotIsRefused) {
  ASSERT_TRUE(fits(cells));
  ASSERT_GT(cells[0].lists.size(), 3U);
  const auto refused = [&](auto change) {
    std::vector<JointCells> changed = cells;
    change(changed[0]);
    return !fits(changed);
  };
  EXPECT_FALSE(fits({}));
  EXPECT_TRUE(refused([](JointCells& c) { c.joints = 3; }));
  EXPECT_TRUE(refused([](JointCells& c) { c.joints = -1; }));
  EXPECT_TRUE(refused([](JointCells& c) { c.joint[0] = 99; }));
  EXPECT_TRUE(refused([](JointCells& c) { c.count[0] = 1 << 30; }));
  EXPECT_TRUE(refused([](JointCells& c) { c.low[0] += 1e-9; }));
  EXPECT_TRUE(
      refused([](JointCells& c) { c.per_unit[0] = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](JointCells& c) { c.cell.pop_back(); }));
  EXPECT_TRUE(refused([](JointCells& c) { c.cell[0] = 1 << 30; }));
  EXPECT_TRUE(refused([](JointCells& c) { c.cell[0] = 3; }));  // within a list
  EXPECT_TRUE(refused([](JointCells& c) { c.lists[2] = 1 << 30; }));
  EXPECT_TRUE(refused([](JointCells& c) { c.lists[3] = 0xFFFF; }));  // a cluster that is not there
  EXPECT_TRUE(refused([](JointCells& c) { c.lists.clear(); }));
}

TEST_F(CellsMemory, CellsThatWouldMissAContactAreRefusedAndNotUsed) {
  SelfCollision check(model, geometry, pairs);
  find_and_keep_cells(model, geometry, check);
  const fs::path file = files("cells").at(0);
  std::vector<JointCells> wrong = cells;
  for (std::uint32_t& cell : wrong[0].cell) cell = JointCells::kFree;
  // A whole file with the right name.
  std::string hex = file.stem().string();
  const Fingerprint key{std::stoull(hex.substr(0, 16), nullptr, 16),
                        std::stoull(hex.substr(16), nullptr, 16)};
  disk_cache().keep("cells", key, packed_cells(wrong));
  SelfCollision fresh(model, geometry, pairs);
  EXPECT_FALSE(use_kept_cells(model, geometry, fresh));
  EXPECT_EQ(said.size(), 1U);
  fresh.place(Eigen::VectorXd::Zero(1));
  EXPECT_TRUE(fresh.any_touching());
}

}  // namespace
}  // namespace twinbus
