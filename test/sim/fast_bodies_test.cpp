// Fast balls against thin plates, with the face of entry kept (contact.continuous).

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "common/math/random.h"
#include "sim/objects/entry_faces.h"
#include "sim/engine/articulated_world.h"
#include "sim/engine/make_world.h"
#include "test/obstacles.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

constexpr double kPlate = 0.002, kRadius = 0.01;  // [m]

// How many balls there are of each kind; the environment may ask for more.
int shots() {
  const char* text = std::getenv("TWINBUS_SHOTS");
  return text != nullptr ? std::atoi(text) : 20;
}

// A ball of 20 mm that flies at the middle of a plate across x at 50 m/s, from a side, at a place and with a spin that seed says.
WorldConfig shot(std::uint64_t seed, double stiffness, double step, int order) {
  Random random(seed);
  const auto any = [&](double most) { return most * (2.0 * random.uniform() - 1.0); };
  WorldConfig config;
  config.step = step;
  config.order = order;
  config.continuous = true;
  config.obstacles = {test::box_at({1, 0, 1}, {kPlate, 1, 1})};
  LooseBody ball;
  ball.name = "ball";
  ball.mass = 0.03;
  ball.solid = {SolidShape::kSphere, {kRadius, 0, 0}};
  ball.stiffness = stiffness;
  ball.damping = 0.1 * std::sqrt(stiffness * ball.mass);
  ball.friction = 0.3;
  const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
  ball.start.pose.translation() = Eigen::Vector3d(1.0 + side * (0.08 + 0.02 * random.uniform()), any(0.2), 1.0 + any(0.2));
  ball.start.velocity = Eigen::Vector3d(-side * 50.0, any(3.0), any(3.0));
  ball.start.angular_velocity = Eigen::Vector3d(any(50.0), any(50.0), any(50.0));
  config.loose = {ball};
  return config;
}

// Whether it ends on the side from which it came.
bool stays(const WorldConfig& config) {
  ArticulatedWorld world(test::bystander(), config);
  EXPECT_EQ(world.set(Configuration(test::bystander())), Status::kOk);
  const double side = config.loose[0].start.pose.translation().x() > 1.0 ? 1.0 : -1.0;
  for (double t = 0.0; t < 0.02; t += config.step) {
    if (world.step() != Status::kOk) return false;
  }
  return side * (world.loose(0).pose.translation().x() - 1.0) > 0.0;
}

TEST(FastBodies, NoBallGoesThroughAPlateHoweverSoftItIs) {
  for (const double stiffness : {1e5, 1e6, 1e7, 1e8, 1e9}) {
    for (const double step : {1e-5, 1e-4, 1e-3, 1e-2}) {
      for (const int order : {1, 2}) {
        if (step == 1e-5 && order == 2) continue;
        int through = 0;
        const int count = step == 1e-5 ? (shots() + 9) / 10 : shots();
        for (int i = 0; i < count; ++i)
          through += stays(shot(static_cast<std::uint64_t>(i + 1), stiffness, step, order)) ? 0 : 1;
        EXPECT_EQ(through, 0) << "of " << count << ", " << stiffness << " N/m, step " << step << " s, order " << order;
      }
    }
  }
}

// What the option is for: without it the spring lets them through.
TEST(FastBodies, WithoutItASoftPlateLetsThemThrough) {
  WorldConfig config = shot(1, 1e5, 1e-4, 1);
  config.continuous = false;
  EXPECT_FALSE(stays(config));
}

// A slow ball neither knows nor cares: the same bits.
TEST(FastBodies, ASlowBallMovesAsWithout) {
  WorldConfig with = shot(3, 1e7, 1e-4, 1);
  with.loose[0].start.velocity /= 25.0;
  WorldConfig without = with;
  without.continuous = false;
  const Model model = test::bystander();
  ArticulatedWorld a(model, with), b(model, without);
  ASSERT_EQ(a.set(Configuration(model)), Status::kOk);
  ASSERT_EQ(b.set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(a.step(), Status::kOk);
    ASSERT_EQ(b.step(), Status::kOk);
  }
  EXPECT_EQ(a.loose(0).pose.matrix(), b.loose(0).pose.matrix());
  EXPECT_GT(std::abs(a.loose(0).velocity.x()), 0.1);  // it met the plate
  EXPECT_NE(a.loose(0).velocity.x() > 0.0, with.loose[0].start.velocity.x() > 0.0);
}

// Around the edge of the plate it may go: the face of entry counts only over that face.
TEST(FastBodies, ABallThatPassesBesideThePlateIsNotHeldBack) {
  WorldConfig config = shot(1, 1e6, 1e-4, 1);
  LooseState& start = config.loose[0].start;
  start.pose.translation() = Eigen::Vector3d(0.9, 0.5 + 2.0 * kRadius, 1.0);
  start.velocity = Eigen::Vector3d(50.0, 0.0, 0.0);
  const Model model = test::bystander();
  ArticulatedWorld world(model, config);
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  test::step_without_allocation(world, 100);
  EXPECT_NEAR(world.loose(0).pose.translation().x(), 1.4, 1e-3);
}

TEST(FastBodies, TheOtherEngineSaysThatItHasNoSuchOption) {
  WorldConfig config = shot(1, 1e6, 1e-3, 1);
  config.engine = Engine::kOde;
  EXPECT_THROW((void)make_world(test::bystander(), config), std::runtime_error);
}

}  // namespace
}  // namespace twinbus
