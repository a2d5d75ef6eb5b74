// Servo, rotor, friction and stops of one joint against closed formulas.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>

#include "both_engines.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "sim/engine/make_world.h"
#include "sim/world/world.h"
#include "test_models.h"

namespace twinbus {
namespace {

using test::kPendulumInertia;

constexpr double kStep = 0.002;  // [s]
constexpr ServoTarget kTarget{.q = 1.0, .qd = 0.5, .tau = 3.0, .kp = 4000.0, .kd = 50.0};

WorldConfig fixed() {
  WorldConfig config;
  config.fixed_base = true;
  config.step = kStep;
  return config;
}

// One step of backward Euler of the pendulum's servo; gravity at the start, as everywhere in ODE.
double implicit_speed(double q, double qd, const ServoTarget& t, double rotor) {
  const double gravity = -2.0 * kGravity * 0.5 * std::sin(q);
  const double inertia = kPendulumInertia + rotor;
  const double servo = t.kp * (t.q - q) + t.kd * t.qd + t.tau;
  return (inertia * qd + kStep * (gravity + servo)) / (inertia + kStep * (t.kd + kStep * t.kp));
}

// The law of kTarget at the end of a step that begins at q and ends with this speed.
double end_law(double q, double next) {
  return kTarget.kp * (kTarget.q - q - kStep * next) + kTarget.kd * (kTarget.qd - next) + kTarget.tau;
}

// Angular momentum of the arm about the hinge, with the lever that the arm has at that attitude [N
// m s].  A body of ODE moves on in a straight line during a step, so after a step its velocity is
// not quite the one that its new lever and its turning rate would give.
double momentum_about_hinge(const World& world, const Eigen::Vector3d& lever) {
  const Eigen::Vector3d com = world.link_in_world(1) * Eigen::Vector3d(0, 0, -0.5);
  return 0.02 * world.angular_velocity(1).y() + 2.0 * lever.cross(world.point_velocity(1, com)).y();
}

class Servo : public ::testing::TestWithParam<std::tuple<Engine, double>> {  // rotor inertia
 protected:
  static double rotor() { return std::get<1>(GetParam()); }
  static bool is_ode() { return std::get<0>(GetParam()) == Engine::kOde; }
  static std::unique_ptr<World> make(const Model& model, WorldConfig config) {
    config.engine = std::get<0>(GetParam());
    return make_world(model, config);
  }
  // A pendulum with this rotor that starts at q [rad] and -0.7 rad/s, with its servo on the way to kTarget.
  std::unique_ptr<World> on_the_way(double q) {
    model_.joints[0].rotor_inertia = rotor();
    auto world = make(model_, fixed());
    Configuration start(model_);
    start.q[0] = q;
    start.qd[0] = -0.7;
    EXPECT_EQ(world->set(start), Status::kOk);
    EXPECT_EQ(world->set_servo(0, kTarget), Status::kOk);
    return world;
  }

 private:
  Model model_ = test::pendulum(1e5);
};

// At the speeds of robots the joint alone tells the whole story.
TEST_P(Servo, IsBackwardEulerOfThePendulum) {
  const auto world_owner = on_the_way(0.95);
  World& world = *world_owner;
  double q = 0.95, qd = -0.7;
  for (int i = 0; i < 200; ++i) {
    const double next = implicit_speed(q, qd, kTarget, rotor());
    ASSERT_EQ(world.step(), Status::kOk);
    // The torque it reports is the law at the end of the step.
    const double tau = end_law(q, next);
    ASSERT_NEAR(world.configuration().qd[0], next, 1e-4 * (1.0 + std::abs(next))) << i;
    EXPECT_NEAR(world.tau(0), tau, 1e-3 * (1.0 + std::abs(tau))) << i;
    q = world.configuration().q[0];
    qd = world.configuration().qd[0];
  }
}

// At any speed: over a step the momentum about the hinge changes by gravity at its start and by the
// law at its end, and the rotor takes its share.
TEST_P(Servo, IsExactlyBackwardEuler) {
  const auto world_owner = on_the_way(0.4);
  World& world = *world_owner;
  double fastest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double q = world.configuration().q[0], qd = world.configuration().qd[0];
    const Eigen::Vector3d lever = world.link_in_world(1).linear() * Eigen::Vector3d(0, 0, -0.5);
    const double before = momentum_about_hinge(world, lever) + rotor() * qd;
    ASSERT_EQ(world.step(), Status::kOk);
    const double next = world.configuration().qd[0];
    const double after =
        is_ode() ? momentum_about_hinge(world, lever) + rotor() * next
                 : before + (kPendulumInertia + rotor()) * (next - qd);  // joints are its state
    const double law = end_law(q, next);
    const double gravity = -2.0 * kGravity * 0.5 * std::sin(q);
    ASSERT_NEAR(after - before, kStep * (gravity + law), 1e-6 * (1.0 + std::abs(kStep * law))) << i;
    EXPECT_NEAR(world.tau(0), law, 1e-6 * (1.0 + std::abs(law))) << i;
    fastest = std::max(fastest, std::abs(next));
  }
  EXPECT_GT(fastest, 3.0);
}
INSTANTIATE_TEST_SUITE_P(RotorInertia, Servo,
                         ::testing::Combine(::testing::Values(Engine::kArticulated, Engine::kOde),
                                            ::testing::Values(0.0, 0.5, 12.0)));

class ServoTest : public test::BothEngines {
 protected:
  // At rest where its servo wants it.
  static std::unique_ptr<World> held(const Model& model, const WorldConfig& config, const ServoTarget& target) {
    Configuration start(model);
    start.q[0] = target.q;
    auto world = make_at(start, model, config);
    EXPECT_EQ(world->set_servo(0, target), Status::kOk);
    return world;
  }
};
TWINBUS_FOR_BOTH_ENGINES(ServoTest);

TEST_P(ServoTest, TorqueWithoutGainsAcceleratesByTauOverInertia) {
  for (const double rotor : {0.0, 2.0}) {
    Model model = test::pendulum();
    model.joints[0].rotor_inertia = rotor;
    const auto world_owner = make(model, fixed());
    World& world = *world_owner;
    ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
    ASSERT_EQ(world.set_servo(0, {.q = 0, .qd = 0, .tau = 5.0, .kp = 0, .kd = 0}), Status::kOk);
    ASSERT_EQ(world.step(), Status::kOk);
    EXPECT_NEAR(world.configuration().qd[0], kStep * 5.0 / (kPendulumInertia + rotor), 1e-7);
    EXPECT_DOUBLE_EQ(world.tau(0), 5.0);
  }
}

TEST_P(ServoTest, NeverExceedsItsEffortAndStillPullsWithAllOfIt) {
  for (const double rotor : {0.0, 1.0}) {
    Model model = test::pendulum(8.0);  // gravity asks for up to 9.81 N m
    model.joints[0].rotor_inertia = rotor;
    const auto world_owner = held(model, fixed(), {.q = 1.5, .qd = 0, .tau = 0, .kp = 5000.0, .kd = 10.0});
    World& world = *world_owner;
    double qd = 0.0, q = 1.5;
    ASSERT_EQ(world.step(), Status::kOk);
    for (int i = 0; i < 400; ++i) {
      q = world.configuration().q[0];
      qd = world.configuration().qd[0];
      ASSERT_EQ(world.step(), Status::kOk);
      ASSERT_LE(std::abs(world.tau(0)), 8.0);
      if (world.tau(0) == 8.0) {  // saturated: the torque really acts
        const double expected =
            qd + kStep * (8.0 - 9.81 * std::sin(q)) / (kPendulumInertia + rotor);
        ASSERT_NEAR(world.configuration().qd[0], expected, 1e-4);
      }
    }
    EXPECT_LT(world.configuration().q[0], 1.2) << "overloaded, it must give way";
  }
}

TEST_P(ServoTest, StopsStopThoughTheServoPushes) {
  Model model = test::pendulum(300.0);
  model.joints[0].lower = -0.5;
  model.joints[0].upper = 0.8;
  const auto world_owner = make(model, fixed());
  World& world = *world_owner;
  for (const double asked : {2.0, -2.0}) {
    ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
    ASSERT_EQ(world.set_servo(0, {.q = asked, .qd = 0, .tau = 0, .kp = 2000.0, .kd = 20.0}),
              Status::kOk);
    double highest = 0.0, lowest = 0.0;
    for (int i = 0; i < 1000; ++i) {
      ASSERT_EQ(world.step(), Status::kOk);
      highest = std::max(highest, world.configuration().q[0]);
      lowest = std::min(lowest, world.configuration().q[0]);
      ASSERT_LE(std::abs(world.tau(0)), 300.0);
    }
    EXPECT_LT(highest, 0.8 + 1e-3);
    EXPECT_GT(lowest, -0.5 - 1e-3);
    EXPECT_NEAR(world.configuration().q[0], asked > 0 ? 0.8 : -0.5, 1e-3);
    EXPECT_NEAR(world.configuration().qd[0], 0.0, 1e-3);
  }
}

TEST_P(ServoTest, ARangeBeyondHalfATurnHasItsStopsWhereTheyBelong) {
  Model model = test::pendulum();
  model.joints[0].lower = -3.6;
  model.joints[0].upper = 1.6;
  const auto world_owner = make(model, fixed());
  World& world = *world_owner;
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  ASSERT_EQ(world.set_servo(0, {.q = -3.5, .qd = 0, .tau = 0, .kp = 2000.0, .kd = 100.0}),
            Status::kOk);
  for (int i = 0; i < 1500; ++i) ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_NEAR(world.configuration().q[0], -3.5, 0.01);
}

TEST_P(ServoTest, AContinuousJointCountsTurns) {
  Model model = test::pendulum();
  model.joints[0].kind = JointKind::kContinuous;
  model.joints[0].lower = -std::numeric_limits<double>::infinity();
  model.joints[0].upper = std::numeric_limits<double>::infinity();
  const auto world_owner = make(model, fixed());
  World& world = *world_owner;
  ASSERT_EQ(world.set(Configuration(model)), Status::kOk);
  for (int i = 0; i < 3000; ++i) {
    const double q = 4.0 * i * kStep;
    ASSERT_EQ(world.set_servo(0, {.q = q, .qd = 4.0, .tau = 0, .kp = 4000.0, .kd = 100.0}),
              Status::kOk);
    ASSERT_EQ(world.step(), Status::kOk);
  }
  EXPECT_NEAR(world.configuration().q[0], 24.0, 0.1);
}

TEST_P(ServoTest, ASliderIsServoedAndStopped) {
  const Model model = test::slider();
  const auto own_owner = make(model, fixed());
  World& own = *own_owner;
  ASSERT_EQ(own.set(Configuration(model)), Status::kOk);
  ASSERT_EQ(own.set_servo(0, {.q = 0.1, .qd = 0, .tau = 2.0 * kGravity, .kp = 2000.0, .kd = 200.0}),
            Status::kOk);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(own.step(), Status::kOk);
  EXPECT_NEAR(own.configuration().q[0], 0.1, 1e-4);
  EXPECT_NEAR(own.tau(0), 2.0 * kGravity, 0.01);
  ASSERT_EQ(own.set_servo(0, {.q = 1.0, .qd = 0, .tau = 0.0, .kp = 2000.0, .kd = 200.0}),
            Status::kOk);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(own.step(), Status::kOk);
  EXPECT_NEAR(own.configuration().q[0], 0.3, 1e-3);
}

TEST_P(ServoTest, FrictionBringsASwingToRest) {
  Model model = test::pendulum();
  model.joints[0].friction = 1.0;
  const auto world_owner = make(model, fixed());
  World& world = *world_owner;
  Configuration start(model);
  start.qd[0] = 2.0;
  ASSERT_EQ(world.set(start), Status::kOk);
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_NEAR(world.configuration().qd[0], 0.0, 0.01);
}

TEST_P(ServoTest, PlayLetsTheServoSideLeadByHalfOfIt) {
  const Model model = test::pendulum();
  WorldConfig config = fixed();
  config.backlash = 0.002;
  const auto world_owner = held(model, config, {.q = 0.8, .qd = 0, .tau = 0, .kp = 10000.0, .kd = 200.0});
  World& world = *world_owner;
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(world.step(), Status::kOk);
  EXPECT_GT(world.tau(0), 2.0);
  EXPECT_NEAR(world.encoder(0) - world.configuration().q[0], 0.001, 1e-5);
}

}  // namespace
}  // namespace twinbus
