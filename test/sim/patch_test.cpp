// Contact patch: areas, volumes and moments against closed forms, soles over edges and seams, and the law in both engines.

#include "geometry/mesh_contact/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "common/math/index.h"
#include "geometry/bounds/shape_mesh.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/contact/contact_solve.h"
#include "sim/contact/ground_contacts.h"
#include "sim/contact/sole_patches.h"
#include "sim/engine/articulated_world.h"
#include "sim/engine/make_world.h"
#include "test/contact_shapes.h"
#include "common/allocation/no_alloc.h"
#include "test/sim/both_engines.h"
#include "test/sim/test_models.h"

namespace twinbus {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d placed(double x, double y, double z, double angle = 0.0,
                  const Vector3d& axis = Vector3d::UnitX()) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(x, y, z);
  pose.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  return pose;
}

// Force of unit stiffness per area and its moment about the origin, from the four points.
struct Wrench {
  double force = 0.0;
  Vector3d moment = Vector3d::Zero();
};
Wrench wrench_of(const Patch& patch) {
  Wrench w;
  for (const PatchPoint& p : patch.point) {
    const double f = 0.25 * patch.area * p.depth;
    w.force += f;
    w.moment += f * p.position.cross(patch.normal);
  }
  return w;
}

ContactMesh box(const Vector3d& size, int cuts = 0) {
  TriangleMesh mesh = test::box_triangles(size);
  for (int i = 0; i < cuts; ++i) mesh = test::split(mesh);
  return ContactMesh(mesh);
}

TEST(Patch, AFlatBoxPressesWithItsFaceHoweverItIsCut) {
  PatchFinder finder;
  Patch whole, cut, slabs;
  ASSERT_TRUE(finder.with_ground(box({0.2, 0.1, 0.3}), placed(1, 2, 0.149), whole));
  EXPECT_NEAR(whole.area, 0.02, 1e-12);
  EXPECT_NEAR(whole.volume, 0.02 * 1e-3, 1e-14);
  ASSERT_TRUE(finder.with_ground(box({0.2, 0.1, 0.3}, 2), placed(1, 2, 0.149), cut));
  ASSERT_TRUE(finder.between(box({0.2, 0.1, 0.3}, 1), placed(1, 2, 0.149), box({9, 9, 1}, 2),
                             placed(1, 2, -0.5), Vector3d::UnitZ(), 0.01, slabs));
  for (const Patch& other : {cut, slabs}) {
    EXPECT_NEAR(other.area, whole.area, 1e-12);
    for (int i = 0; i < Patch::kPoints; ++i) {
      EXPECT_NEAR(other.point[at(i)].depth, 1e-3, 1e-12);
      EXPECT_NEAR(std::abs(other.point[at(i)].position.x() - 1.0), 0.1 / std::sqrt(3.0), 1e-9);
      EXPECT_NEAR(std::abs(other.point[at(i)].position.y() - 2.0), 0.05 / std::sqrt(3.0), 1e-9);
    }
  }
}

// A little tilt: the force and where it acts, of a depth that is linear over the face.
TEST(Patch, ATiltedBoxPressesWhereItsVolumeSays) {
  PatchFinder finder;
  Patch patch;
  const double tilt = 1e-3, length = 0.2, width = 0.1, mean = 5e-4;
  ASSERT_TRUE(finder.with_ground(box({length, width, 0.1}),
                                 placed(0, 0, 0.05 - mean, tilt, Vector3d::UnitY()), patch));
  const Wrench w = wrench_of(patch);
  EXPECT_NEAR(w.force / (length * width * mean), 1.0, 1e-3);
  // The slope times the second moment of the area, about the middle of the face.
  EXPECT_NEAR(-w.moment.y() / (tilt * width * std::pow(length, 3) / 12.0), 1.0, 0.1);
  EXPECT_NEAR(patch.rough, 0.0, 1e-12);
}

// On its edge, at any slope: a wedge of two walls.
TEST(Patch, AnEdgeInTheGroundIsAWedge) {
  PatchFinder finder;
  Patch patch;
  for (const double angle : {0.1, 0.4, std::numbers::pi / 4.0, 1.2}) {
    const double depth = 1e-3, length = 0.3;
    const double lowest = 0.1 * (std::sin(angle) + std::cos(angle));  // of a bar of 0.2 m square
    ASSERT_TRUE(
        finder.with_ground(box({length, 0.2, 0.2}), placed(0, 0, lowest - depth, angle), patch));
    const double base = depth * (std::tan(angle) + 1.0 / std::tan(angle));
    EXPECT_NEAR(patch.area / (base * length), 1.0, 1e-9);
    EXPECT_NEAR(patch.volume / (0.5 * base * depth * length), 1.0, 1e-9);
    // The squared depth: what the fit has and what it says that it lost.
    double square = patch.rough;
    for (const PatchPoint& p : patch.point) square += 0.25 * patch.area * p.depth * p.depth;
    EXPECT_NEAR(square / (base * depth * depth * length / 3.0), 1.0, 1e-9);
  }
}

TEST(Patch, RoundBodiesPressWithTheirCaps) {
  PatchFinder finder;
  Patch patch;
  const double radius = 0.1, depth = 4e-3;
  const ContactMesh ball(test::sphere_triangles(radius, 6));
  ASSERT_TRUE(finder.with_ground(ball, placed(0, 0, radius - depth), patch));
  EXPECT_NEAR(patch.volume / (std::numbers::pi * depth * depth * (radius - depth / 3.0)), 1.0,
              0.02);
  EXPECT_NEAR(patch.area / (std::numbers::pi * depth * (2.0 * radius - depth)), 1.0, 0.02);
  ASSERT_TRUE(finder.between(ball, placed(0.3, 0, radius - depth), box({2, 2, 1}),
                             placed(0, 0, -0.5), Vector3d::UnitZ(), 2.0 * depth, patch));
  EXPECT_NEAR(patch.volume / (std::numbers::pi * depth * depth * (radius - depth / 3.0)), 1.0,
              0.02);
  // A lying cylinder: the segment of a circle.
  TriangleMesh bar;
  constexpr int kSides = 180;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    for (const double x : {-0.2, 0.2})
      bar.points.push_back({x, radius * std::sin(angle), radius * std::cos(angle)});
    const int a = 2 * i, b = 2 * ((i + 1) % kSides);
    bar.triangles.push_back({a, b, a + 1});
    bar.triangles.push_back({b, b + 1, a + 1});
  }
  ASSERT_TRUE(finder.with_ground(ContactMesh(bar), placed(0, 0, radius - depth), patch));
  const double half = std::acos(1.0 - depth / radius);
  EXPECT_NEAR(patch.volume / (0.4 * radius * radius * (half - std::sin(half) * std::cos(half))),
              1.0, 0.02);
}

// Two roofs that cross: the depth is d - |x| - |y|.
TEST(Patch, CrossingEdgesShareAPyramid) {
  PatchFinder finder;
  Patch patch, turned;
  const double depth = 1e-3, half = 0.05 * std::sqrt(2.0);
  const ContactMesh beam = box({0.1, 0.1, 0.6});
  Isometry3d lower = Isometry3d::Identity(), upper = lower;
  // Edges up and down, the one along x, the other along y.
  lower.linear() = (Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()) *
                    Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitZ()))
                       .toRotationMatrix();
  upper.linear() = (Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()) *
                    Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitZ()))
                       .toRotationMatrix();
  upper.translation().z() = 2.0 * half - depth;
  ASSERT_TRUE(finder.between(beam, upper, beam, lower, Vector3d::UnitZ(), 2.0 * depth, patch));
  EXPECT_NEAR(patch.area / (2.0 * depth * depth), 1.0, 1e-6);
  EXPECT_NEAR(patch.volume / (2.0 * std::pow(depth, 3) / 3.0), 1.0, 1e-6);
  // Exchanged, the normal turns round and nothing else.
  ASSERT_TRUE(finder.between(beam, lower, beam, upper, -Vector3d::UnitZ(), 2.0 * depth, turned));
  EXPECT_NEAR(turned.volume / patch.volume, 1.0, 1e-9);
  EXPECT_LT((wrench_of(turned).moment + wrench_of(patch).moment).norm(), 1e-15);
}

TEST(Patch, MomentsMoveWithTheirArea) {
  PatchPolygon here, there;
  Eigen::Matrix2d turn;
  turn << 0.9, -0.3, 0.2, 1.1;
  constexpr double kCorners[][2] = {{-0.1, -0.05}, {0.15, -0.06}, {0.16, 0.04}, {0.0, 0.07}};
  for (const auto& [x, y] : kCorners) {
    here.add({x, y});
    there.add(turn * Eigen::Vector2d(x, y));
  }
  const PatchMoments moved = mapped(moments_of(here), turn), found = moments_of(there);
  EXPECT_NEAR(moved.area, found.area, 1e-17);
  EXPECT_LT((moved.first - found.first).norm(), 1e-18);
  EXPECT_LT((moved.second - found.second).norm(), 1e-19);
}

// A sole on blocks.
class SoleRig {
 public:
  explicit SoleRig(const std::vector<Obstacle>& tiles, bool solid = false) : model_(test::block()) {
    (solid ? config_.obstacles : config_.tiles) = tiles;
    soles_.emplace(model_, config_);
  }
  // Sum of weight times depth, and its centre.
  double press(const Isometry3d& sole, Eigen::Vector2d* centre = nullptr, double ground = -1.0) const {
    SolePatches::Points points;
    const int count =
        soles_->find(0, sole, Vector3d::Zero(), Vector3d::Zero(), 0.0, ground, {}, points);
    double force = 0.0;
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();
    for (int i = 0; i < count; ++i) {
      const double f = 0.25 * points[at(i)].weight * points[at(i)].depth;
      force += f;
      moment += f * points[at(i)].position.head<2>();
    }
    if (centre != nullptr && force > 0.0) *centre = moment / force;
    return force;
  }
  const Sole& sole() const { return model_.soles[0]; }

 private:
  Model model_;
  WorldConfig config_;
  std::optional<SolePatches> soles_;
};

Obstacle block(double x, double length) {
  return {ObstacleShape::kBox, {length, 2.0, 0.2}, placed(x + 0.5 * length, 0, -0.1)};
}

// Swept over the edge of a tile and of a block in steps of 0.1 mm: no step changes the force by more than 2 % of the whole.
TEST(SolePatches, AnEdgeIsCrossedWithoutAJump) {
  for (const bool solid : {false, true}) {
    const SoleRig rig({block(0.0, 1.0)}, solid);
    for (const double yaw : {0.0, 0.1, 0.5}) {
      for (const double depth : {2e-4, 5e-4, 3e-3}) {
        const double whole = depth;
        double before = -1.0, most = 0.0, least = 1.0;
        for (double x = -0.3; x < 0.3; x += 1e-4) {
          const double force = rig.press(placed(x, 0, -depth, yaw, Vector3d::UnitZ()));
          if (before >= 0.0) most = std::max(most, std::abs(force - before) / whole);
          least = x > 0.25 ? std::min(least, force / whole) : least;
          before = force;
        }
        EXPECT_LT(most, 0.02) << solid << " " << yaw << " " << depth;
        EXPECT_NEAR(least, 1.0, 1e-9);
      }
    }
  }
}

// Where all of it is in the ground its moments are known; a tile cuts it out of the sole.
TEST(SolePatches, TheGroundPressesAsATileDoes) {
  const SoleRig ground({}), tile({block(-1.0, 2.0)});
  for (const double tilt : {0.0, 1e-3, 5e-3, 2e-2}) {  // the last two leave a part of it above
    for (const double yaw : {0.0, 0.4, 2.0}) {
      const Isometry3d turned = placed(0.02, 0.01, -5e-4, yaw, Vector3d::UnitZ());
      const Isometry3d sole = turned * placed(0, 0, 0, tilt, Vector3d(0.3, 1.0, 0.0));
      Eigen::Vector2d on_ground = Eigen::Vector2d::Zero(), on_tile = Eigen::Vector2d::Zero();
      const double force = ground.press(sole, &on_ground, 0.0);
      EXPECT_GT(force, 0.0);
      EXPECT_NEAR(force, tile.press(sole, &on_tile), 1e-15);
      EXPECT_LT((on_ground - on_tile).norm(), 1e-12);
    }
  }
}

// The seam of two tiles is not felt, and ground below a tile adds nothing.
TEST(SolePatches, ASeamIsNotFelt) {
  const SoleRig one({block(-1.0, 2.0)}), two({block(-1.0, 1.0), block(0.0, 1.0)});
  for (const double tilt : {0.0, 2e-3}) {
    for (double x = -0.2; x < 0.2; x += 0.013) {
      const Isometry3d sole = placed(x, 0, -5e-4, tilt, Vector3d(0.3, 1.0, 0.0));
      Eigen::Vector2d at_one = Eigen::Vector2d::Zero(), at_two = Eigen::Vector2d::Zero();
      EXPECT_NEAR(one.press(sole, &at_one), two.press(sole, &at_two), 1e-12);
      EXPECT_LT((at_one - at_two).norm(), 1e-9);
    }
  }
}

// Against many points of equal area, over an edge, yawed and tilted.
TEST(SolePatches, PressesWhereManyPointsDo) {
  const SoleRig rig({block(0.0, 1.0)});
  const Sole& sole = rig.sole();
  const double length = sole.front + sole.back, width = sole.left + sole.right;
  for (const double yaw : {0.0, 0.1, 0.3, 0.5}) {
    for (const double tilt : {0.0, 1e-3, 2e-3}) {
      for (double x = -0.1; x <= 0.05; x += 0.025) {
        const Isometry3d pose = placed(x, 0, -5e-4) * placed(0, 0, 0, yaw, Vector3d::UnitZ()) *
                                placed(0, 0, 0, tilt, Vector3d(1.0, 0.7, 0.0));
        double force = 0.0;
        Eigen::Vector2d moment = Eigen::Vector2d::Zero();
        constexpr int kAlong = 400, kAcross = 200;
        for (int i = 0; i < kAlong * kAcross; ++i) {
          const Vector3d local(-sole.back + length * (i % kAlong + 0.5) / kAlong,
                               -sole.right + width * (i / kAlong + 0.5) / kAcross, 0.0);
          const Vector3d p = pose * local;
          if (p.x() < 0.0 || p.z() > 0.0) continue;
          force -= p.z() / (kAlong * kAcross);
          moment -= p.z() / (kAlong * kAcross) * p.head<2>();
        }
        Eigen::Vector2d centre = Eigen::Vector2d::Zero();
        const double pressed = rig.press(pose, &centre);
        if (!(force > 2e-6)) continue;
        EXPECT_NEAR(pressed / force, 1.0, 0.02) << yaw << " " << tilt << " " << x;
        EXPECT_LT((centre - moment / force).norm(), 1e-3) << yaw << " " << tilt << " " << x;
      }
    }
  }
}

// The sole is pushed up by the block that it stands on by a finger's breadth, not aside.
TEST(SolePatches, AHeelOverAnEdgeIsPushedUp) {
  const Model model = test::block();
  WorldConfig config;
  config.obstacles = {block(0.0, 1.0)};
  const SolePatches soles(model, config);
  SolePatches::Points points;
  const double x = -model.soles[0].front + 1e-4;  // 0.1 mm of it are on the block, 0.5 mm deep
  const int count =
      soles.find(0, placed(x, 0, -5e-4), Vector3d::Zero(), Vector3d::Zero(), 0.0, -1.0, {}, points);
  ASSERT_EQ(count, Patch::kPoints);
  for (int i = 0; i < count; ++i) EXPECT_GT(points[at(i)].normal.z(), 0.999);
  EXPECT_TRUE(soles.stands_on(0, Vector3d(1e-4, 0, -5e-4)));
  EXPECT_FALSE(soles.stands_on(0, Vector3d(1e-4, 0, -0.1)));
}

LooseBody loose(const Vector3d& size, const Vector3d& at) {
  LooseBody body;
  body.name = "body";
  body.solid.size = size;
  body.mass = 2.0;
  body.start.pose.translation() = at;
  return body;
}

WorldConfig with_patches() {
  WorldConfig config;
  config.contact = ContactModel::kPatch;
  return config;
}

// a (v + v_out) = ln((1 + a v) / (1 - a v_out)), of a box, of a box on its edge and of a ball, against a wall: without weight.
TEST(PatchContact, AnImpactLeavesAsHuntAndCrossleySay) {
  for (const int shape : {0, 1, 2}) {
    const Model model = test::bystander();
    WorldConfig config = with_patches();
    config.dissipation = 0.5;
    config.step = 1e-5;
    config.ground_friction = 0.0;
    config.obstacles.push_back({ObstacleShape::kBox, {0.2, 2.0, 2.0}, placed(0.1, 0, 5)});
    const double reach = shape == 1 ? 0.05 * std::sqrt(2.0) : 0.05;
    LooseBody body = loose({0.1, 0.1, 0.1}, {-reach - 0.002, 0, 5});
    if (shape == 1)
      body.start.pose.linear() = placed(0, 0, 0, std::numbers::pi / 4, Vector3d::UnitY()).linear();
    if (shape == 2) {
      body.solid.shape = SolidShape::kSphere;
      body.solid.size = {0.05, 0.0, 0.0};
    }
    body.start.velocity.x() = 1.0;
    config.loose.push_back(body);
    const auto world = make_world(model, config);
    ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
    for (int i = 0; i < 6000 && world->loose(0).pose.translation().x() > -reach - 0.003; ++i)
      ASSERT_EQ(world->step(), Status::kOk);
    const double out = -world->loose(0).velocity.x(), a = config.dissipation;
    EXPECT_LT(out, 0.95) << shape;
    // What the law says of this speed: within 1 % of it.
    const double off = a * (1.0 + out) - std::log((1.0 + a) / (1.0 - a * out));
    const double slope = a - a / (1.0 - a * out);
    EXPECT_LT(std::abs(off / slope), 0.01 * out) << shape << " leaves at " << out;
  }
}

TEST(PatchContact, ABoxHoldsOnASlopeAndBoxesStandOnOneAnother) {
  const Model model = test::bystander();
  for (const int order : {1, 2}) {
    WorldConfig config = with_patches();
    config.step = 1e-3;
    config.order = order;
    const double slope = 0.3;
    config.obstacles.push_back(
        {ObstacleShape::kBox, {4, 1, 0.2}, placed(5, 0, 1, slope, Vector3d::UnitY())});
    const Isometry3d top = config.obstacles[0].pose * placed(0, 0, 0.1);
    LooseBody brick = loose({0.2, 0.1, 0.06}, Vector3d::Zero());
    brick.start.pose = top * placed(0, 0, 0.03);
    config.loose.push_back(brick);
    for (int i = 0; i < 3; ++i) {
      config.loose.push_back(loose({0.2, 0.2, 0.2}, {0.01 * i, 0, 0.1 + 0.2 * i}));
      config.loose.back().mass = 1.0;
    }
    const auto world = make_world(model, config);
    ASSERT_EQ(world->set(Configuration(model)), Status::kOk);
    for (int i = 0; i < 500; ++i) ASSERT_EQ(world->step(), Status::kOk);
    const Vector3d settled = world->loose(0).pose.translation();
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(world->step(), Status::kOk);
    EXPECT_LT((world->loose(0).pose.translation() - settled).norm(), 2e-6)
        << "it creeps at order " << order;
    EXPECT_LT((settled - brick.start.pose.translation()).norm(), 2e-3);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(world->loose(i + 1).pose.translation().z(), 0.1 + 0.2 * i, 3e-4) << i;
      // Hunt and Crossley damp little what hardly moves: no more than the springs gave at the start, g sqrt(3 m / k).
      EXPECT_LT(world->loose(i + 1).velocity.norm(), 0.03) << i;
    }
  }
}

// Its law bends with the speed: about that of the start a second pass is needed, about that which the last step foretells none.
TEST(PatchContact, AForeseenSpeedSavesAPass) {
  const Model model = test::block();
  Configuration start(model);
  start.base_velocity = {0.0, 0.0, -0.05};
  ArticulatedBody body(model, false, 1.0);
  ContactSolve solve({&body}, 4);
  std::vector<Contact> contacts(1);
  Contact& c = contacts[0];
  c.link = 0;
  c.params = hunt_crossley(rubber(1e5, 0.0, 0.8), 1.0);
  c.normal = Vector3d::UnitZ();
  c.depth = 1e-3;
  c.v0 = start.base_velocity;
  const std::vector<JointRow> free(model.joints.size());
  constexpr double kStep = 1e-3;
  const auto passes = [&] {
    body.place(start);
    solve.fold(contacts, kStep);
    int count = 0;
    do {
      EXPECT_TRUE(body.inward(free, kStep));
      body.outward();
      ++count;
    } while (solve.refold(contacts, kStep));
    return count;
  };
  EXPECT_EQ(passes(), 2);
  const Vector3d found = c.v, force = c.now.force;
  EXPECT_GT((found - c.v0).norm(), 1e-3);
  c.foreseen = true;
  c.gain = (found - c.v0) / kStep;
  EXPECT_EQ(passes(), 1);
  EXPECT_LT((c.v - found).norm(), 1e-12);
  EXPECT_LT((c.now.force - force).norm(), 1e-6);
}

// What the soles press is remembered for the next step; where something else is touched it is not.
TEST(PatchContact, SolesForesee) {
  const Model model = test::block();
  ArticulatedWorld world(model, with_patches());
  Configuration start(model);
  start.base_velocity = {0.0, 0.0, -0.01};
  ASSERT_EQ(world.set(start), Status::kOk);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(world.step(), Status::kOk);
  const std::vector<Contact> before = world.solved();
  ASSERT_EQ(world.step(), Status::kOk);
  ASSERT_EQ(world.solved().size(), before.size());
  ASSERT_FALSE(before.empty());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Contact& c = world.solved()[i];
    ASSERT_TRUE(c.foreseen);
    EXPECT_LT((c.gain - (before[i].v - before[i].v0) / WorldConfig().step).norm(), 1e-9 * c.gain.norm());
  }
  WorldConfig corners;
  ArticulatedWorld other(model, corners);
  ASSERT_EQ(other.set(start), Status::kOk);
  for (int i = 0; i < 4; ++i) ASSERT_EQ(other.step(), Status::kOk);
  ASSERT_FALSE(other.solved().empty());
  for (const Contact& c : other.solved()) EXPECT_FALSE(c.foreseen);
}

class PatchStanding : public test::BothEngines {};

// The soles carry the weight where it is, and the world allocates nothing.
TEST_P(PatchStanding, ABlockStandsOnItsSoles) {
  const Model model = test::block();
  const auto world = make(model, with_patches());
  Configuration start(model);
  start.q.setZero();
  start.qd.setZero();
  ASSERT_EQ(world->set(start), Status::kOk);
  ServoTarget hold;
  hold.kp = 500.0;
  hold.kd = 20.0;
  ASSERT_EQ(world->set_servo(0, hold), Status::kOk);
  for (int i = 0; i < 1500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
  for (const ContactPoint& c : world->contacts()) {
    EXPECT_GE(c.sole, 0);
    force += c.force;
    moment += c.point.cross(c.force);
  }
  EXPECT_NEAR(force.z() / (world->mass() * kGravity), 1.0, 1e-3);
  EXPECT_NEAR(-moment.y() / force.z(), world->com().x(), 1e-4);
  // Both soles whole: the springs of both under the weight.
  EXPECT_NEAR(-world->link_in_world(0).translation().z(), world->mass() * kGravity / 2e5, 1e-5);
  const NoAlloc no_alloc;
  for (int i = 0; i < 20; ++i) ASSERT_EQ(world->step(), Status::kOk);
  if (!is_ode()) {
    EXPECT_EQ(no_alloc.count(), 0);
  }
}

TWINBUS_FOR_BOTH_ENGINES(PatchStanding);

}  // namespace
}  // namespace twinbus
