// What no scene should ask for: every engine answers within bounds or freezes, and can be set anew.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "test_models.h"
#include "world_helpers.h"

namespace twinbus {
namespace {

class RobustnessTest : public test::BothEngines {
 protected:
  // Finite and in bounds as long as it goes on; whether it did to the end.
  static bool goes_on(World& world, int steps) {
    for (int i = 0; i < steps; ++i) {
      const Status status = world.step();
      const Configuration& now = world.configuration();
      EXPECT_EQ(check_configuration(static_cast<std::size_t>(now.q.size()), now), Status::kOk) << i;
      for (int k = 0; k < world.loose_count(); ++k) {
        EXPECT_EQ(check_loose(world.loose(k)), Status::kOk) << i << ' ' << k;
      }
      if (status == Status::kOk) continue;
      EXPECT_EQ(status, Status::kDiverged) << i;
      return false;
    }
    return true;
  }
  static Configuration standing(const Model& model) {
    Configuration start(model);
    start.q.setZero();
    start.qd.setZero();
    const double sink = model.total_mass() * kGravity / (2.0 * model.soles[0].stiffness);
    start.base.translation().z() = -sink;
    return start;
  }
  static void stands(World& world, const Model& model) {
    ASSERT_EQ(world.set(standing(model)), Status::kOk);
    ASSERT_TRUE(goes_on(world, 100));
    EXPECT_NEAR(world.link_in_world(0).translation().z(), 0.0, 2e-3);
  }
  static LooseBody box(double mass, double z) {
    LooseBody body;
    body.name = "box";
    body.solid.size = {0.2, 0.2, 0.2};
    body.mass = mass;
    body.stiffness = 1e6;
    body.damping = std::sqrt(body.stiffness * mass);
    body.start.pose.translation() = Eigen::Vector3d(3.0, 0.0, z);
    return body;
  }
};
TWINBUS_FOR_BOTH_ENGINES(RobustnessTest);

TEST_P(RobustnessTest, APushOfAMillionNewtonsIsAnsweredOrFreezes) {
  const Model model = test::block();
  const auto world = make(model);
  ASSERT_EQ(world->set(standing(model)), Status::kOk);
  const Eigen::Vector3d middle(0.1, 0.1, 0.1);
  EXPECT_EQ(world->push(0, middle, {1.001e6, 0.0, 0.0}), Status::kOutOfRange);
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(world->push(0, middle, {1e6, 1e6, 1e6}), Status::kOk);
    if (!goes_on(*world, 1)) break;
  }
  (void)goes_on(*world, 50);
  stands(*world, model);
}

TEST_P(RobustnessTest, AStartHalfAMetreInTheGroundIsThrownOutOrFreezes) {
  const Model model = test::block();
  const auto world = make(model);
  Configuration start = standing(model);
  start.base.translation().z() = -0.5;
  ASSERT_EQ(world->set(start), Status::kOk);
  (void)goes_on(*world, 300);
  stands(*world, model);
}

TEST_P(RobustnessTest, BoxesThatBeginInOneAnotherPartOrFreeze) {
  const Model model = test::block();
  WorldConfig config;
  config.loose = {box(1.0, 0.1), box(1.0, 0.1), box(1.0, 0.15)};
  const auto world = make(model, config);
  ASSERT_EQ(world->set(standing(model)), Status::kOk);
  (void)goes_on(*world, 500);
}

TEST_P(RobustnessTest, MassesSevenOrdersApartStayInBounds) {
  const Model model = test::block();
  WorldConfig config;
  config.step = 1e-3;
  config.loose = {box(1e-3, 0.1), box(1e4, 0.3)};
  const auto world = make(model, config);
  ASSERT_EQ(world->set(standing(model)), Status::kOk);
  (void)goes_on(*world, 500);
  stands(*world, model);
}

TEST_P(RobustnessTest, ALooseBodyWithoutMassOrSizeIsRefusedByName) {
  const Model model = test::block();
  for (const bool mass : {true, false}) {
    WorldConfig config;
    config.loose = {box(1.0, 0.1)};
    if (mass) {
      config.loose[0].mass = 0.0;
    } else {
      config.loose[0].solid.size.setZero();
    }
    try {
      (void)make(model, config);
      ADD_FAILURE() << "taken: " << mass;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("box"), std::string::npos) << error.what();
    }
  }
}

// Heaps that fall at the same time, each in a thread of its own, are to the bit what one by itself is.
TEST_P(RobustnessTest, WorldsInThreadsDoNotDisturbOneAnother) {
  const Model model = test::pendulum();
  WorldConfig config;
  config.fixed_base = true;
  config.step = 1e-3;
  for (int i = 0; i < 8; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() << 3.0, 0.0, 0.1 + 0.1 * i;
    pose.linear() = Eigen::AngleAxisd(0.9 * i, Eigen::Vector3d(0.1, 0.2, 1.0).normalized()).toRotationMatrix();
    config.loose.push_back(test::loose_box("beam" + std::to_string(i), 0.6, {0.5, 0.05, 0.05}, pose, 1e5, 150.0));
  }
  const auto fall = [&](std::vector<double>& end) {
    const auto world = make(model, config);
    EXPECT_EQ(world->set(Configuration(model)), Status::kOk);
    for (int i = 0; i < 700; ++i) ASSERT_EQ(world->step(), Status::kOk) << i;
    for (int i = 0; i < world->loose_count(); ++i) {
      const Eigen::Isometry3d pose = world->loose(i).pose;
      end.insert(end.end(), pose.data(), pose.data() + 16);
    }
  };
  std::vector<double> alone;
  std::array<std::vector<double>, 4> together;
  fall(alone);
  std::vector<std::thread> threads;
  for (auto& each : together) threads.emplace_back(fall, std::ref(each));
  for (std::thread& thread : threads) thread.join();
  for (const auto& each : together) EXPECT_EQ(each, alone);
}

}  // namespace
}  // namespace twinbus
