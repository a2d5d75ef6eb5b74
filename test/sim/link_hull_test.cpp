#include "sim/world/link_hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <numbers>

#include "both_engines.h"
#include "common/allocation/no_alloc.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/contact/link_patches.h"
#include "sim/engine/make_world.h"
#include "test/contact_shapes.h"
#include "test_models.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The block of the tests, its box as triangles of a file.
Model block_of_triangles(const std::string& name) {
  Model model = test::block();
  Shape& shape = model.links[0].collision[0];
  const std::string path = testing::TempDir() + name + ".obj";
  std::ofstream file(path);
  const TriangleMesh box = test::box_triangles(shape.size);
  for (const Eigen::Vector3d& p : box.points)
    file << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (const auto& t : box.triangles)
    file << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  shape.kind = ShapeKind::kMesh;
  shape.mesh = path;
  shape.size.setOnes();
  return model;
}

// The same with a plate of no thickness for its box, where the box has its top.
Model block_with_a_plate() {
  Model model = test::block();
  Shape& shape = model.links[0].collision[0];
  const std::string path = testing::TempDir() + "hull_plate.obj";
  std::ofstream(path) << "v -0.2 -0.2 0.1\nv 0.2 -0.2 0.1\nv 0.2 0.2 0.1\nv -0.2 0.2 0.1\n"
                         "f 1 2 3\nf 1 3 4\n";
  shape.kind = ShapeKind::kMesh;
  shape.mesh = path;
  shape.size.setOnes();
  return model;
}

// On its back, so that no sole touches: where its origin comes to rest.
double rest(const Model& model, Engine engine) {
  WorldConfig config;
  config.engine = engine;
  const auto world = make_world(model, config);
  Configuration start(model);
  start.base.linear() = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  start.base.translation().z() = 0.21;
  if (world->set(start) != Status::kOk) return 0.0;
  (void)world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 10});
  for (int i = 0; i < 1000; ++i) {
    if (world->step() != Status::kOk) return 0.0;
  }
  EXPECT_LT(world->configuration().base_velocity.norm(), 1e-3);
  return world->configuration().base.translation().z();
}

TWINBUS_BOTH_ENGINES(LinkHullTest);

TEST_P(LinkHullTest, ALinkOfTrianglesLiesAsItsBoxDoes) {
  const double box = rest(test::block(), GetParam());
  const double triangles =
      rest(block_of_triangles("hull_" + test::engine_name(GetParam())), GetParam());
  EXPECT_NEAR(box, 0.2, 1e-3);
  EXPECT_NEAR(triangles, box, 3e-4);
}

TEST_P(LinkHullTest, AMeshWithoutVolumeHolds) {
  EXPECT_NEAR(rest(block_with_a_plate(), GetParam()), 0.2, 2e-3);
}

TEST_P(LinkHullTest, AMeshThatIsGoneIsRefused) {
  Model model = test::block();
  model.links[0].collision[0].kind = ShapeKind::kMesh;
  model.links[0].collision[0].mesh = "no_such_file.stl";
  EXPECT_THROW((void)make(model), std::runtime_error);
}

TEST(LinkHull, ALooseBoxLiesOnALinkOfTriangles) {
  const Model model = block_of_triangles("hull_under");
  WorldConfig config;
  config.step = 1e-3;
  LooseBody body;
  body.name = "box";
  body.solid = {SolidShape::kBox, {0.1, 0.1, 0.1}};
  body.start.pose.translation() = Eigen::Vector3d(0.1, 0.1, 0.26);
  config.loose.push_back(body);
  const auto world = make_world(model, config);
  ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
  (void)world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 1000, .kd = 10});
  for (int i = 0; i < 1500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  EXPECT_NEAR(world->loose(0).pose.translation().z(), 0.25, 2e-3);  // on soft soles
  EXPECT_LT(world->loose(0).velocity.norm(), 1e-3);
}

TEST(LinkHull, ItsCornersAreFewAndOfTheMesh) {
  Shape ball;
  ball.kind = ShapeKind::kSphere;
  ball.size.x() = 0.3;
  const TriangleMesh hull = link_hull(ball);
  EXPECT_GE(hull.points.size(), 20U);
  EXPECT_LE(hull.points.size(), 26U);
  EXPECT_FALSE(hull.triangles.empty());
  for (const Eigen::Vector3d& point : hull.points) EXPECT_NEAR(point.norm(), 0.3, 0.02);
}

// With contact patch a link that is no sole touches with its area.
// Without feet, of that one shape about its middle, 20.5 kg in all.
Model trunk(ShapeKind kind, const Vector3d& size) {
  Model model = test::block();
  for (Sole& sole : model.soles) sole.link = -1;
  model.links[0].com.setZero();
  model.joints[0].placement.translation().setZero();
  Shape shape;
  shape.kind = kind;
  shape.size = size;
  model.links[0].collision = {shape};
  return model;
}

WorldConfig trunk_world(ContactModel contact) {
  WorldConfig config;
  config.contact = contact;
  config.step = 1e-3;
  config.dissipation = 20.0;  // it comes to rest soon
  return config;
}

Obstacle box_at(const Vector3d& size, double x, double z) {
  return {ObstacleShape::kBox, size, Isometry3d(Eigen::Translation3d(x, 0.0, z))};
}

class LinkPatchTest : public test::BothEngines {
 protected:
  // Where its middle comes to rest that begins at that height.
  double rest(const Model& model, const WorldConfig& config, double height) {
    const auto world = make(model, config);
    Configuration start(model);
    start.q.setZero();
    start.qd.setZero();
    start.base.translation().z() = height;
    EXPECT_EQ(world->set(start), Status::kOk);
    EXPECT_EQ(world->set_servo(0, {.q = 0, .qd = 0, .tau = 0, .kp = 100, .kd = 10}), Status::kOk);
    for (int i = 0; i < 3000; ++i) EXPECT_EQ(world->step(), Status::kOk);
    const NoAlloc guard;
    for (int i = 0; i < 20; ++i) (void)world->step();
    if (!is_ode()) {
      EXPECT_EQ(guard.count(), 0);
    }
    Vector3d force = Vector3d::Zero();
    for (const ContactPoint& c : world->contacts()) force += c.force;
    EXPECT_NEAR(force.z() / (world->mass() * kGravity), 1.0, 2e-2);
    return world->link_in_world(0).translation().z();
  }
};

TEST_P(LinkPatchTest, ATrunkLiesOnTheAreaThatPresses) {
  const Vector3d size(0.4, 0.3, 0.2);
  const Model model = trunk(ShapeKind::kBox, size);
  const double face = (0.4 * 0.3 + 0.3 * 0.2 + 0.2 * 0.4) / 3.0, per_area = kLinkStiffness * kSoleCorners / face;
  const double sunk = model.total_mass() * kGravity / (per_area * size.x() * size.y());
  EXPECT_NEAR((0.1 - rest(model, trunk_world(ContactModel::kPatch), 0.0999)) / sunk, 1.0, 0.02);
  // On a table that carries half of its length and on another as high.
  WorldConfig tables = trunk_world(ContactModel::kPatch);
  tables.obstacles = {box_at({1.0, 1.0, 0.5}, -0.5, 0.25), box_at({0.1, 1.0, 0.5}, 0.15, 0.25)};
  EXPECT_NEAR((0.6 - rest(model, tables, 0.5999)) / (sunk * 0.4 / 0.3), 1.0, 0.04);
}

TEST_P(LinkPatchTest, ABallSinksAsDeepAsItsCapSays) {
  const double radius = 0.15;
  const Model model = trunk(ShapeKind::kSphere, Vector3d(radius, 0.0, 0.0));
  const double per_area = kLinkStiffness * kSoleCorners / (4.0 * radius * radius);
  const double sunk = radius - rest(model, trunk_world(ContactModel::kPatch), radius);
  EXPECT_NEAR(per_area * std::numbers::pi * sunk * sunk * (radius - sunk / 3.0) / (model.total_mass() * kGravity), 1.0, 0.02);
}

// Two ridges that lie between its corners and the middles of its edges.
TEST_P(LinkPatchTest, AnEdgeBetweenItsPointsHoldsIt) {
  const Model model = trunk(ShapeKind::kBox, {0.4, 0.3, 0.2});
  WorldConfig config = trunk_world(ContactModel::kPatch);
  config.obstacles = {box_at({0.02, 1.0, 0.5}, -0.1, 0.25), box_at({0.02, 1.0, 0.5}, 0.1, 0.25)};
  EXPECT_NEAR(rest(model, config, 0.6), 0.6, 5e-3);
  if (is_ode()) return;
  config.contact = ContactModel::kHuntCrossley;  // what the area is for
  EXPECT_LT(rest(model, config, 0.6), 0.5);
}

// Carried over the edge of a table: no step of 0.1 mm changes its force by more than 2 % of the whole.
TEST(LinkPatches, AnEdgeIsCrossedWithoutAJump) {
  const Model model = trunk(ShapeKind::kBox, {0.2, 0.1, 0.1});
  WorldConfig config = trunk_world(ContactModel::kPatch);
  config.obstacles = {box_at({1.0, 1.0, 0.5}, 0.5, 0.25)};
  const LinkPatches patches(model, config);
  const int which = patches.of(0, 0);
  ASSERT_EQ(which, 0);
  double before = -1.0, most = 0.0, last = 0.0;
  for (double x = -0.09; x < 0.12; x += 1e-4) {
    LinkPress press;
    const Isometry3d pose(Eigen::Translation3d(x, 0.0, 0.55 - 1e-3));
    double force = 0.0;
    if (patches.find(which, pose, Vector3d::Zero(), Vector3d::Zero(), 1e-3, 1, press)) {
      for (int i = 0; i < press.count; ++i) force += press.weight * press.point[static_cast<std::size_t>(i)].depth;
    }
    if (before >= 0.0) most = std::max(most, std::abs(force - before));
    before = last = force;
  }
  EXPECT_GT(last, 0.0);
  EXPECT_LT(most, 0.02 * last);
}

// Its points are those of the end of the step, set back.
TEST(LinkPatches, WhatWillPressIsFoundBeforeItDoes) {
  const Model model = trunk(ShapeKind::kBox, {0.2, 0.1, 0.1});
  const LinkPatches patches(model, trunk_world(ContactModel::kPatch));
  const Isometry3d pose(Eigen::Translation3d(0.0, 0.0, 0.0505));
  LinkPress press;
  EXPECT_FALSE(patches.find(0, pose, Vector3d(0, 0, -0.4), Vector3d::Zero(), 1e-3, 0, press));
  ASSERT_TRUE(patches.find(0, pose, Vector3d(0, 0, -1.0), Vector3d::Zero(), 1e-3, 0, press));
  EXPECT_EQ(press.count, Patch::kPoints);
  for (const LinkPoint& point : press.point) EXPECT_NEAR(point.depth, -5e-4, 1e-12);
}

TWINBUS_FOR_BOTH_ENGINES(LinkPatchTest);

}  // namespace
}  // namespace twinbus
