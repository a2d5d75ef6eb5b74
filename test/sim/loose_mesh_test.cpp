// Loose bodies of triangles: they rest where their shape rests, carried by their weight.

#include "sim/engine/make_world.h"
#include "sim/objects/rigid_object_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "robot/description/load.h"
#include "sim/engine/articulated_world.h"
#include "sim/scene/scene.h"
#include "test/contact_shapes.h"
#include "common/allocation/no_alloc.h"
#include "test_models.h"

namespace twinbus {
namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;

LooseBody triangles(const TriangleMesh& mesh, double mass, const Vector3d& position) {
  LooseBody body;
  body.name = "body";
  body.mass = mass;
  body.start.pose.translation() = position;
  body.stiffness = 1e6;
  body.damping = std::sqrt(15.0 * body.stiffness);
  give_mesh(mesh, body);
  return body;
}

Obstacle step_of(const Vector3d& size, const Vector3d& position) {
  Obstacle step{.shape = ObstacleShape::kBox, .size = size, .pose = Eigen::Isometry3d::Identity()};
  step.pose.translation() = position;
  return step;
}

double upward(const ArticulatedWorld& world) {
  double force = 0.0;
  for (const Contact& c : world.solved()) force += c.now.force.z();
  return force;
}

void run(World& world, double seconds, double step) {
  for (int i = 0; i < static_cast<int>(seconds / step); ++i) {
    ASSERT_EQ(world.step(), Status::kOk) << i;
  }
}

// As a box of corners does: m g / 4 k into the ground, or into a step, and a height map's tile.
TEST(LooseMesh, CubeOfTrianglesRestsLikeABox) {
  const Model model = test::bystander();
  TriangleMesh cube = test::box_triangles(Vector3d::Constant(0.2));
  cube = test::split(test::split(cube));
  for (const int under : {0, 1, 2}) {
    WorldConfig config;
    config.step = 0.001;
    const double ground = under == 0 ? 0.0 : 0.1;
    const Obstacle step = step_of({0.6, 0.6, 0.1}, {0.0, 0.0, 0.05});
    if (under == 1) config.obstacles.push_back(step);
    if (under == 2) config.tiles.push_back(step);
    config.loose.push_back(triangles(cube, 8.0, {0.05, 0.0, ground + 0.11}));
    ArticulatedWorld world(model, config);
    run(world, 2.0, config.step);
    const double sink = 8.0 * kGravity / (4.0 * 1e6);
    EXPECT_NEAR(world.loose(0).pose.translation().z(), ground + 0.1 - sink, 1e-6) << under;
    EXPECT_LT(world.loose(0).velocity.norm(), 1e-6) << under;
    EXPECT_NEAR(upward(world), 8.0 * kGravity, 1e-3) << under;
    EXPECT_LT(world.loose(0).pose.translation().head<2>().norm(), 0.0501) << under;
  }
}

// ODE finds other points than ours, and others each step: the cube lies as high as some of them carry it, and trembles.
TEST(LooseMesh, EngineOdeHasCubesOfTrianglesToo) {
  const Model model = test::bystander();
  for (const int under : {0, 1, 2}) {
    WorldConfig config;
    config.engine = Engine::kOde;
    config.step = 0.001;
    const double ground = under == 0 ? 0.0 : 0.1;
    const Obstacle step = step_of({0.6, 0.6, 0.1}, {0.0, 0.0, 0.05});
    if (under == 1) config.obstacles.push_back(step);
    if (under == 2) config.tiles.push_back(step);
    const TriangleMesh cube = test::box_triangles(Vector3d::Constant(0.2));
    config.loose.push_back(triangles(cube, 8.0, {0.05, 0.0, ground + 0.11}));
    const std::unique_ptr<World> world = make_world(model, config);
    run(*world, 2.0, config.step);
    const double sink = ground + 0.1 - world->loose(0).pose.translation().z();
    EXPECT_GT(sink, 8.0 * kGravity / (8.0 * 1e6)) << under;
    EXPECT_LT(sink, 8.0 * kGravity / (2.0 * 1e6)) << under;
    EXPECT_LT(world->loose(0).velocity.norm(), 1e-3) << under;
  }
}

TEST(LooseMesh, BodiesOfTrianglesLieOnOneAnotherAndOnSimpleOnes) {
  const Model model = test::bystander();
  const TriangleMesh cube = test::box_triangles(Vector3d::Constant(0.1));
  WorldConfig config;
  config.step = 0.001;
  LooseBody simple;
  simple.name = "plate";
  simple.solid = {SolidShape::kBox, {0.4, 0.4, 0.05}};
  simple.mass = 5.0;
  simple.start.pose.translation() = Vector3d(0, 0, 0.025);
  simple.stiffness = 1e6;
  simple.damping = 4e3;
  config.loose = {simple, triangles(cube, 2.0, {0, 0, 0.102}),
                  triangles(cube, 1.0, {0.01, 0, 0.205})};
  ArticulatedWorld world(model, config);
  run(world, 2.0, config.step);
  EXPECT_NEAR(world.loose(1).pose.translation().z(), 0.1, 1e-4);
  EXPECT_NEAR(world.loose(2).pose.translation().z(), 0.2, 2e-4);
  EXPECT_LT(world.loose(2).velocity.norm(), 1e-4);
}

TEST(LooseMesh, HookHangsOverTheEdgeOfItsStep) {
  const Scene scene = load_scene("hook_on_step");
  const Model model = test::bystander();
  WorldConfig config;
  config.step = scene.step;
  config.obstacles = scene.obstacles;
  config.loose = scene.loose;
  ArticulatedWorld world(model, config);
  run(world, 3.0, config.step);
  const LooseEnd& end = scene.criteria.loose.at(0);
  EXPECT_LT((world.loose(0).pose.translation() - end.position).norm(), end.within);
  EXPECT_NEAR(upward(world), scene.loose[0].mass * kGravity, 1e-2);
  NoAlloc none;
  ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_EQ(none.count(), 0);
}

TEST(LooseMesh, AxesArePrincipalAndTheMiddleIsThatOfTheMass) {
  TriangleMesh box = test::box_triangles(Vector3d(0.1, 0.2, 0.3));
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5, Vector3d(1, 2, 3).normalized()));
  for (Vector3d& p : box.points) p = turn * p + Vector3d(1, 2, 3);
  const LooseBody body = triangles(box, 1.0, Vector3d(0, 0, 1));
  const Eigen::Matrix3d inertia = body.mesh->inertia();
  EXPECT_LT((inertia - Eigen::Matrix3d(inertia.diagonal().asDiagonal())).norm(),
            1e-12 * inertia.norm());
  EXPECT_LT(body.mesh->middle().norm(), 1e-12);
  // In the world it is turned as its file is.
  for (const Vector3d& vertex : body.mesh->vertices()) {
    const Vector3d local = turn.conjugate() * (body.start.pose.linear() * vertex);
    EXPECT_LT((local.cwiseAbs() - Vector3d(0.05, 0.1, 0.15)).norm(), 1e-9);
  }
}

TEST(LooseMesh, WhatHasNoVolumeIsRefused) {
  TriangleMesh open = test::box_triangles(Vector3d::Constant(0.2));
  open.triangles.pop_back();
  EXPECT_THROW(triangles(open, 1.0, Vector3d::Zero()), std::runtime_error);
}

// What load_scene says of a scene with this file.
std::string mesh_complaint(const std::string& mesh) {
  const std::string path = testing::TempDir() + "loose_mesh_scene.yaml";
  std::ofstream(path) << "loose:\n  - {name: a, shape: mesh, file: " << mesh
                      << ", mass: 1, position: [0, 0, 1]}\n";
  try {
    load_scene(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(LooseMesh, FileLiesBesideItsScene) {
  EXPECT_NE(mesh_complaint("../hook.obj").find("scene's folder"), std::string::npos);
  EXPECT_NE(mesh_complaint("/etc/hook.obj").find("scene's folder"), std::string::npos);
  EXPECT_NE(mesh_complaint("no_such.obj").find("no_such.obj"), std::string::npos);
}

}  // namespace
}  // namespace twinbus
