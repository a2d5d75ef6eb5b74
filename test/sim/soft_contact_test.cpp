// Contact soft: its closed formulas, and MuJoCo beside it where that is installed.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "robot/description/load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/make_world.h"
#include "sim/mujoco/mujoco_library.h"
#include "sim/world/static_equilibrium.h"
#include "test_models.h"

namespace twinbus {
namespace {

constexpr double kRate = 2.0 / (0.95 * 0.02);  // b of soft_contact.h [1/s]
constexpr double kPoints = 8.0;                // of two soles

std::unique_ptr<World> made(const Model& model, Engine engine = Engine::kArticulated, ContactModel contact = ContactModel::kSoft) {
  WorldConfig config;
  config.engine = engine;
  config.contact = contact;
  return make_world(model, config);
}

const Model& block() {
  static const Model model = test::block();
  return model;
}

// Block on its soles, pushed at its centre of mass along x for a second: where it is and how fast.
struct Pushed {
  double depth, x, speed;
};
Pushed pushed(World& world, double force, int steps = 500) {
  EXPECT_EQ(world.set(Configuration(block())), Status::kOk);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(world.step(), Status::kOk);
  const double depth = -world.configuration().base.translation().z();
  const double before = world.configuration().base.translation().x();
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(world.push(0, world.com(), {force, 0.0, 0.0}), Status::kOk);
    EXPECT_EQ(world.step(), Status::kOk);
  }
  const Configuration& now = world.configuration();
  return {depth, now.base.translation().x() - before, now.base_velocity.x()};
}

bool mujoco_is_there() {
  try {
    (void)MujocoLibrary::get();
    return true;
  } catch (const std::exception&) {
    return false;
  }
}

// R f = a with mu = 0.8; the light arm hardly changes the inverse mass.
TEST(SoftContact, ABlockThatIsPushedCreepsAndOneOnRubberDoesNot) {
  const double mass = 20.5, mu = 0.8, force = 40.0;
  const auto world = made(block());
  const Pushed soft = pushed(*world, force);
  const double x = soft.depth / 1e-3, i = 0.9 + 0.05 * 2.0 * x * x;  // below half a millimetre
  ASSERT_LT(x, 0.5);
  const double tangent = (1.0 - i) / i / mass * (1.0 + mu * mu), normal = 0.5 * mu * mu * tangent;
  EXPECT_NEAR(i * soft.depth * 0.25 * kRate * kRate, normal * mass * kGravity / kPoints, 2e-3 * normal * mass * kGravity / kPoints);
  const double creep = tangent * force / kPoints / kRate;
  EXPECT_NEAR(soft.speed, creep, 0.02 * creep);
  EXPECT_NEAR(soft.x, creep * 1.0, 0.05 * creep);
  const auto hard = made(block(), Engine::kArticulated, ContactModel::kSpringDamper);
  EXPECT_LT(std::abs(pushed(*hard, force).speed), 1e-3 * creep);
}

TEST(SoftContact, BeyondTheConeItSlides) {
  const auto world = made(block());
  const Pushed slid = pushed(*world, 200.0, 250);
  const double acceleration = 200.0 / 20.5 - 0.8 * kGravity;
  EXPECT_NEAR(slid.speed, 0.5 * acceleration, 0.02);
}

TEST(SoftContact, IsNotOfEngineOde) {
  EXPECT_THROW((void)made(block(), Engine::kOde), std::runtime_error);
}

TEST(SoftContact, IsMuJoCosForABlock) {
  if (!mujoco_is_there()) GTEST_SKIP() << "MuJoCo is not installed";
  const auto ours = made(block()), theirs = made(block(), Engine::kMujoco);
  // Beyond half of the cone MuJoCo's pyramid yields sooner.
  for (const auto& [force, off] : {std::pair(20.0, 0.02), std::pair(60.0, 0.05), std::pair(100.0, 0.15)}) {
    const Pushed here = pushed(*ours, force), there = pushed(*theirs, force);
    EXPECT_NEAR(here.depth, there.depth, 0.01 * there.depth) << force;
    EXPECT_NEAR(here.x, there.x, off * there.x) << force;
  }
}

// A robot whose servos hold it, pushed sideways: its soles creep as far.
TEST(SoftContact, IsMuJoCosForARobotThatStands) {
  if (!mujoco_is_there()) GTEST_SKIP() << "MuJoCo is not installed";
  const Model model = load_robot("hrp1s");
  const NamedPose& pose = model.poses[static_cast<std::size_t>(model.find_pose("half_sitting"))];
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(pose.q.data(), model.joint_count());
  std::vector<double> crept;
  using Case = std::pair<Engine, ContactModel>;
  for (const auto& [engine, contact] : {Case{Engine::kArticulated, ContactModel::kSoft}, Case{Engine::kMujoco, ContactModel::kSoft},
                                        Case{Engine::kArticulated, ContactModel::kSpringDamper}}) {
    const auto world = made(model, engine, contact);
    const Standing standing = stand(model, q, 1.0, {world->corner_stiffness(0), world->corner_stiffness(1)}, {0.0, 0.0}, false);
    ASSERT_EQ(world->set(standing.configuration, &standing.tau), Status::kOk);
    for (int j = 0; j < model.joint_count(); ++j) {
      const Joint& joint = model.joints[static_cast<std::size_t>(j)];
      (void)world->set_servo(j, {.q = standing.configuration.q[j], .qd = 0.0, .tau = standing.tau[j], .kp = joint.kp, .kd = joint.kd});
    }
    const auto foot = [&] { return world->link_in_world(model.soles[0].link).translation().y(); };
    for (int i = 0; i < 250; ++i) ASSERT_EQ(world->step(), Status::kOk);
    double before = 0.0;
    for (int i = 0; i < 500; ++i) {
      if (i == 250) before = foot();  // what yields is in place
      ASSERT_EQ(world->push(0, world->com(), {0.0, 60.0, 0.0}), Status::kOk);
      ASSERT_EQ(world->step(), Status::kOk);
    }
    EXPECT_GT(world->configuration().base.linear()(2, 2), 0.999);
    crept.push_back(foot() - before);
  }
  EXPECT_GT(crept[1], 1e-4);
  EXPECT_NEAR(crept[0], crept[1], 0.1 * crept[1]);
  EXPECT_LT(std::abs(crept[2]), 0.1 * crept[1]);
}

}  // namespace
}  // namespace twinbus
