#include "sim/engine/make_world.h"
#include "sim/world/link_hull.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "test/contact_shapes.h"
#include "test_models.h"

namespace twinbus {
namespace {

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

}  // namespace
}  // namespace twinbus
