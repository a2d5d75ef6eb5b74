// Joints that two motors turn over rods, in the simulated world: against the loop itself (cranks, rods and all), and limited at the
// motors instead of at the joints.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "test/sim/both_engines.h"
#include "common/allocation/no_alloc.h"
#include "robot/description/load.h"
#include "robot/description/parallel_joints.h"
#include "robot/parallel/drive_torque.h"
#include "sim/motors/motor_limits.h"
#include "test/parallel/parallel_biped.h"

namespace twinbus {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kStep = 0.0005;  // [s]
constexpr double kTorque = 0.8;  // limit of a motor [N m]

// A foot on a shank that stands still; with_cranks: cranks are links, rods are loops, and each motor turns its crank.
std::string ankle_urdf(bool with_cranks) {
  const auto link = [](const std::string& name, double mass, double inertia, const std::string& com) {
    const std::string i = std::to_string(inertia);
    return "<link name='" + name + "'><inertial><origin xyz='" + com + "'/><mass value='" + std::to_string(mass) + "'/><inertia ixx='" + i +
           "' iyy='" + i + "' izz='" + i + "' ixy='0' ixz='0' iyz='0'/></inertial></link>\n";
  };
  const auto joint = [](const std::string& name, const std::string& parent, const std::string& child, const std::string& at,
                        const std::string& axis, double effort) {
    return "<joint name='" + name + "' type='revolute'><parent link='" + parent + "'/><child link='" + child + "'/><origin xyz='" + at +
           "'/><axis xyz='" + axis + "'/><limit lower='-1' upper='1' velocity='30' effort='" + std::to_string(effort) + "'/></joint>\n";
  };
  std::string text = "<robot name='ankle'>\n" + link("shank", 2.0, 0.02, "0 0 0") + link("between", 0.2, 0.0002, "0 0 0") +
                     link("foot", 1.2, 0.004, "0 0 -0.05") + joint("pitch", "shank", "between", "0 0 -0.3", "0 1 0", 100.0) +
                     joint("roll", "between", "foot", "0.01 0 -0.01", "1 0 0", 100.0);
  if (with_cranks) {
    text += link("crank_a", 0.001, 0.000001, "0 0 0") + link("crank_b", 0.001, 0.000001, "0 0 0") +
            joint("motor_a", "shank", "crank_a", "0 0.05 -0.1", "0 1 0", kTorque) +
            joint("motor_b", "shank", "crank_b", "0 -0.05 -0.12", "0 1 0", kTorque);
  }
  return text + "</robot>\n";
}

// The rods: 0.2 m and 0.18 m, cranks of 5 cm and 4 cm.
constexpr const char* kPair =
    "parallel_joints:\n"
    "  - joints: [pitch, roll]\n    parent: shank\n    child: foot\n    motors:\n"
    "      - {name: a, crank: [0, 0.05, -0.1], axis: [0, 1, 0], arm: [-0.05, 0.05, -0.1], rod: [-0.055, 0.05, 0.01], torque: 0.8, speed: 30, range: [-1.2, 1.2]}\n"
    "      - {name: b, crank: [0, -0.05, -0.12], axis: [0, 1, 0], arm: [-0.04, -0.05, -0.12], rod: [-0.05, -0.045, 0.01], torque: 0.8, speed: 30, range: [-1.2, 1.2]}\n";

Model serial_ankle() {
  return load_robot_texts({.folder = "/nowhere", .yaml = std::string("urdf: ankle.urdf\nbase: fixed\n") + kPair, .urdf = ankle_urdf(false), .srdf = ""});
}

Model looped_ankle(const ParallelJoints& pair) {
  const auto loop = [&](const std::string& crank, int motor, const std::string& arm, const std::string& rod) {
    return "  - {link: " + crank + ", point: [" + arm + "], to: foot, at: [" + rod + "], length: " + std::to_string(pair.drive.rod_length(motor)) +
           ", stiffness: 1e+8, damping: 1e+3}\n";
  };
  return load_robot_texts({.folder = "/nowhere",
                           .yaml = "urdf: ankle.urdf\nbase: fixed\nloops:\n" + loop("crank_a", 0, "-0.05, 0, 0", "-0.055, 0.05, 0.01") +
                                   loop("crank_b", 1, "-0.04, 0, 0", "-0.05, -0.045, 0.01"),
                           .urdf = ankle_urdf(true),
                           .srdf = ""});
}

WorldConfig hung(const Model& model) {
  WorldConfig config;
  config.fixed_base = true;
  config.step = kStep;
  for (const Loop& loop : model.loops) {
    Tie tie;
    tie.a = {model.find_link(loop.link), -1, loop.point};
    tie.b = {model.find_link(loop.to), -1, loop.at};
    tie.stiffness = loop.stiffness;
    tie.damping = loop.damping;
    tie.length = loop.length;
    config.ties.push_back(tie);
  }
  return config;
}

Vector2d motor_torques(double time) { return {0.15 * std::cos(25.0 * time), 0.12 * std::cos(17.0 * time + 0.5)}; }

struct Both {
  Model serial = serial_ankle();
  std::vector<ParallelJoints> pairs = parallel_joints_of(serial);
  Model looped = looped_ankle(pairs.front());
  std::unique_ptr<World> tree = make_world(serial, hung(serial)), loop = make_world(looped, hung(looped));
  int motors[2] = {looped.find_joint("motor_a"), looped.find_joint("motor_b")};

  Both() {
    EXPECT_EQ(tree->set(Configuration(serial)), Status::kOk);
    EXPECT_EQ(loop->set(Configuration(looped)), Status::kOk);
  }
  Vector2d tree_q() const { return pairs.front().of(tree->configuration().q); }
  Vector2d loop_q() const {
    return {loop->configuration().q[looped.find_joint("pitch")], loop->configuration().q[looped.find_joint("roll")]};
  }
  RodPosture posture(const Vector2d& q) const {
    RodPosture p;
    EXPECT_TRUE(pairs.front().drive.at(q, p));
    return p;
  }
  void drive_tree(const Vector2d& tau) {
    for (int i = 0; i < 2; ++i) {
      ASSERT_EQ(tree->set_servo(pairs.front().joints[static_cast<std::size_t>(i)], {.q = 0, .qd = 0, .tau = tau[i], .kp = 0, .kd = 0}), Status::kOk);
    }
  }
  void drive_loop(const Vector2d& tau) {
    for (int i = 0; i < 2; ++i) ASSERT_EQ(loop->set_servo(motors[i], {.q = 0, .qd = 0, .tau = tau[i], .kp = 0, .kd = 0}), Status::kOk);
  }
};

TEST(MotorLimits, TheSameMotorTorquesMoveTheFootOfTheTreeAndOfTheLoopItselfAlike) {
  Both both;
  double moved = 0.0, apart = 0.0, closed = 0.0;
  for (int i = 0; i < 1200; ++i) {
    const Vector2d tau = motor_torques(i * kStep);
    both.drive_tree(both.posture(both.tree_q()).jacobian.transpose() * tau);
    both.drive_loop(tau);
    ASSERT_EQ(both.tree->step(), Status::kOk);
    ASSERT_EQ(both.loop->step(), Status::kOk);
    moved = std::max(moved, both.loop_q().cwiseAbs().maxCoeff());
    apart = std::max(apart, (both.tree_q() - both.loop_q()).cwiseAbs().maxCoeff());
    // The cranks of the loop are where the closed form says.
    const RodPosture p = both.posture(both.loop_q());
    for (int k = 0; k < 2; ++k) closed = std::max(closed, std::abs(both.loop->configuration().q[both.motors[k]] - p.motors[k]));
  }
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(apart, 0.01 * moved);
  EXPECT_LT(closed, 2e-3);
}

TEST(MotorLimits, MotorsAtTheirLimitsMoveBothAlikeToo) {
  Both both;
  double moved = 0.0, apart = 0.0;
  int limited = 0;
  for (int i = 0; i < 300; ++i) {
    // More than the motors have, in turn: the joints of the tree ask, the motors of the loop are asked for the same.
    const Vector2d asked(i % 100 < 50 ? 6.0 : -6.0, i % 60 < 30 ? 2.0 : -2.0);
    both.drive_tree(asked);
    both.drive_loop(both.posture(both.loop_q()).jacobian.transpose().inverse() * asked);
    const RodPosture p = both.posture(both.tree_q());
    ASSERT_EQ(both.tree->step(), Status::kOk);
    ASSERT_EQ(both.loop->step(), Status::kOk);
    const Vector2d given(both.tree->tau(both.pairs.front().joints[0]), both.tree->tau(both.pairs.front().joints[1]));
    const Vector2d motors = p.jacobian.transpose().inverse() * given;
    EXPECT_LE(motors.cwiseAbs().maxCoeff(), kTorque * (1.0 + 1e-5));
    limited += motors.cwiseAbs().maxCoeff() > kTorque * (1.0 - 1e-5) ? 1 : 0;
    moved = std::max(moved, both.loop_q().cwiseAbs().maxCoeff());
    apart = std::max(apart, (both.tree_q() - both.loop_q()).cwiseAbs().maxCoeff());
  }
  EXPECT_EQ(limited, 300);
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(apart, 0.02 * moved);
}

class LimitedServo : public test::BothEngines {};
TWINBUS_FOR_BOTH_ENGINES(LimitedServo);

// Stiff servos of a foot that is far from its target: a parallelogram, not a box, with one joint asked and with both.
TEST_P(LimitedServo, BothJointsAtOnceHaveLessThanEachAlone) {
  const Model model = serial_ankle();
  const ParallelJoints pair = parallel_joints_of(model).front();
  RodPosture p;
  ASSERT_TRUE(pair.drive.at(Vector2d::Zero(), p));
  const Vector2d alone = torque_alone(pair.drive, p), none = Vector2d::Zero();
  const auto given = [&](const Vector2d& target) {
    WorldConfig config = hung(model);
    const auto world = make_hung(model, config);
    for (int i = 0; i < 2; ++i)
      EXPECT_EQ(world->set_servo(pair.joints[static_cast<std::size_t>(i)], {.q = target[i], .qd = 0, .tau = 0, .kp = 2000, .kd = 20}), Status::kOk);
    EXPECT_EQ(world->step(), Status::kOk);
    const Vector2d tau(world->tau(pair.joints[0]), world->tau(pair.joints[1]));
    EXPECT_LE((p.jacobian.transpose().inverse() * tau).cwiseAbs().maxCoeff(), kTorque * 1.001);
    return tau;
  };
  EXPECT_LT(given(none).norm(), 1.0);
  const Vector2d far = given({0.3, 0.9}), first = given({0.5, 0.0});
  EXPECT_GT(first[0], 0.7 * alone[0]);
  EXPECT_LT(far[0], 0.7 * first[0]);
  // Of a box both would have all: the corner that the motors do not have.
  EXPECT_GT((p.jacobian.transpose().inverse() * alone).cwiseAbs().maxCoeff(), 1.5 * kTorque);
}

TEST_P(LimitedServo, AStiffServoThatLeansOnItsLimitsComesToRestWithoutAllocation) {
  const Model model = serial_ankle();
  const ParallelJoints pair = parallel_joints_of(model).front();
  WorldConfig config = hung(model);
  config.step = 0.002;
  const auto world = make_hung(model, config);
  const Vector2d target(0.3, -0.15);
  for (int i = 0; i < 2; ++i)
    ASSERT_EQ(world->set_servo(pair.joints[static_cast<std::size_t>(i)], {.q = target[i], .qd = 0, .tau = 0, .kp = 6000, .kd = 120}), Status::kOk);
  const NoAlloc guard;
  for (int i = 0; i < 1500; ++i) ASSERT_EQ(world->step(), Status::kOk);
  if (!is_ode()) {
    EXPECT_EQ(guard.count(), 0);
  }
  EXPECT_LT((pair.of(world->configuration().q) - target).norm(), 2e-3);
  EXPECT_LT(pair.of(world->configuration().qd).norm(), 1e-3);
}

TEST(MotorLimits, RobotsWithoutTheKeyAreAsTheyWere) {
  const Model plain = load_robot("biped12");
  EXPECT_TRUE(parallel_joints_of(plain).empty());
  std::vector<JointLaw> joints;
  EXPECT_TRUE(MotorLimits(plain, joints).empty());
}

}  // namespace
}  // namespace twinbus
