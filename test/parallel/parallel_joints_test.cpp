// Two joints that two motors turn over rods: closed forms against numeric ones, limits, and robot.yaml.

#include "robot/description/parallel_joints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "robot/parallel/drive_torque.h"
#include "test/error_of.h"
#include "test/parallel/parallel_biped.h"

namespace twinbus::test {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

const std::vector<ParallelJoints>& ankles() {
  static const std::vector<ParallelJoints> pairs = parallel_joints_of(parallel_biped());
  return pairs;
}
const ParallelJoints& right_ankle() { return ankles().front(); }

// A mechanism without symmetry: slanted axes, offset joints, cranks that are not alike.
RodDrive crooked() {
  SerialJoints joints;
  joints.first = Eigen::Translation3d(0.01, -0.02, -0.3) * Eigen::AngleAxisd(0.2, Vector3d::UnitZ());
  joints.second = Eigen::Translation3d(0.015, 0.0, -0.02) * Eigen::AngleAxisd(-0.1, Vector3d::UnitY());
  joints.first_axis = Vector3d(0.1, 1.0, 0.05).normalized();
  joints.second_axis = Vector3d(1.0, 0.1, -0.1).normalized();
  std::array<RodMotor, 2> motors;
  motors[0] = {.name = "a", .center = {0.01, 0.05, -0.1}, .axis = Vector3d(0.1, 1.0, 0.2).normalized(), .arm = {-0.05, 0.06, -0.12},
               .rod = {-0.06, 0.04, 0.01}, .torque = 40.0, .speed = 12.0, .lower = -1.2, .upper = 1.1};
  motors[1] = {.name = "b", .center = {0.0, -0.06, -0.15}, .axis = Vector3d(0.0, -1.0, 0.1).normalized(), .arm = {-0.06, -0.05, -0.16},
               .rod = {-0.05, -0.05, 0.02}, .torque = 55.0, .speed = 9.0, .lower = -1.0, .upper = 1.2};
  return {joints, motors};
}

std::vector<Vector2d> postures(const JointBox& box, int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Vector2d> all;
  for (int i = 0; i < count; ++i)
    all.emplace_back(box.lower + Vector2d(share(random), share(random)).cwiseProduct(box.upper - box.lower));
  return all;
}

// Where the ends of the rods are, written apart from the library: transforms alone.
double loop_error(const Model& model, const ParallelJoints& pair, const Vector2d& q, const Vector2d& motors) {
  double worst = 0.0;
  const Joint& first = model.joints[static_cast<std::size_t>(pair.joints[0])];
  const Joint& second = model.joints[static_cast<std::size_t>(pair.joints[1])];
  const Eigen::Isometry3d child = first.placement * Eigen::AngleAxisd(q[0], first.axis) * second.placement * Eigen::AngleAxisd(q[1], second.axis);
  for (int i = 0; i < 2; ++i) {
    const RodMotor& m = pair.drive.motor(i);
    const Vector3d arm = m.center + Eigen::AngleAxisd(motors[i], m.axis) * (m.arm - m.center);
    worst = std::max(worst, std::abs((child * m.rod - arm).norm() - pair.drive.rod_length(i)));
  }
  return worst;
}

TEST(RodDrive, TheMotorAnglesCloseBothLoopsInEveryPostureOfTheBox) {
  const ParallelJoints& pair = right_ankle();
  RodPosture p;
  ASSERT_TRUE(pair.drive.at(Vector2d::Zero(), p));
  EXPECT_LT(p.motors.norm(), 1e-12);
  for (const Vector2d& q : postures(pair.box, 300)) {
    ASSERT_TRUE(pair.drive.at(q, p));
    EXPECT_LT(loop_error(parallel_biped(), pair, q, p.motors), 1e-12);
  }
}

TEST(RodDrive, TheJacobianIsTheDerivativeOfTheMotorAngles) {
  const RodDrive crooked_drive = crooked();
  const JointBox small{{-0.4, -0.3}, {0.4, 0.3}};
  const std::vector<std::pair<const RodDrive*, JointBox>> cases = {{&right_ankle().drive, right_ankle().box}, {&crooked_drive, small}};
  for (const auto& [drive, box] : cases) {
    for (const Vector2d& q : postures(box, 200)) {
      RodPosture p, plus, minus;
      ASSERT_TRUE(drive->at(q, p));
      for (int j = 0; j < 2; ++j) {
        const Vector2d h = 1e-6 * Vector2d::Unit(j);
        ASSERT_TRUE(drive->at(q + h, plus) && drive->at(q - h, minus));
        EXPECT_LT((p.jacobian.col(j) - (plus.motors - minus.motors) / 2e-6).norm(), 1e-7);
      }
    }
  }
}

TEST(RodDrive, TheJointsOfMotorAnglesAreFoundAgain) {
  const RodDrive drive = crooked();
  RodPosture p, found;
  for (const Vector2d& q : postures({{-0.4, -0.3}, {0.4, 0.3}}, 200)) {
    ASSERT_TRUE(drive.at(q, p));
    Vector2d back = Vector2d::Zero();
    ASSERT_TRUE(drive.joints(p.motors, back, found));
    EXPECT_LT((back - q).norm(), 1e-11);
  }
  Vector2d kept(0.1, 0.1);
  found = p;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vector2d& none : {Vector2d(3.0, -3.0), Vector2d(nan, 0.0), Vector2d(p.motors[0], nan)}) {
    EXPECT_FALSE(drive.joints(none, kept, found));
    EXPECT_EQ(kept, Vector2d(0.1, 0.1));
    EXPECT_EQ(found.motors, p.motors);
    EXPECT_EQ(found.jacobian, p.jacobian);
  }
}

TEST(RodDrive, CranksThatAreParallelToTheFootGiveTheAnglesOfAParallelogram) {
  // Pitch alone moves a parallelogram in a plane: both motors turn as the joint does.
  RodPosture p;
  for (const double pitch : {-0.9, -0.3, 0.2, 0.5}) {
    ASSERT_TRUE(right_ankle().drive.at({pitch, 0.0}, p));
    EXPECT_NEAR(p.motors[0], pitch, 1e-12);
    EXPECT_NEAR(p.motors[1], pitch, 1e-12);
    EXPECT_NEAR(p.jacobian(0, 0), 1.0, 1e-12);
    EXPECT_NEAR(p.crank_sine.minCoeff(), std::cos(pitch + 0.3), 2e-3);
  }
}

TEST(DriveRange, TheBoxIsInsideTheMotorsRangesAndCannotBeWider) {
  const ParallelJoints& pair = right_ankle();
  RodPosture p;
  for (const Vector2d& q : postures(pair.box, 1000)) {
    EXPECT_TRUE(usable(pair.drive, q, p)) << not_used_for(pair.drive, q);
    EXPECT_EQ(not_used_for(pair.drive, q), "");
  }
  const Model plain = load_robot("biped12");
  int drawn_in = 0;
  for (int i = 0; i < 2; ++i) {
    const Joint& before = plain.joints[static_cast<std::size_t>(pair.joints[static_cast<std::size_t>(i)])];
    for (const bool upper : {false, true}) {
      const double end = (upper ? pair.box.upper : pair.box.lower)[i], limit = upper ? before.upper : before.lower;
      if (end == limit) continue;
      ++drawn_in;
      JointBox wider = pair.box;
      (upper ? wider.upper : wider.lower)[i] += (limit - end) * 0.02 + (upper ? 0.004 : -0.004);
      // What is lost first is at the ends of the other joint.
      bool all = true;
      for (int k = 0; k <= 16; ++k) {
        Vector2d q = wider.lower + k / 16.0 * (wider.upper - wider.lower);
        q[i] = (upper ? wider.upper : wider.lower)[i];
        all = all && usable(pair.drive, q, p);
      }
      EXPECT_FALSE(all) << i << upper;
    }
  }
  EXPECT_GT(drawn_in, 0);
}

TEST(DriveRange, SpeedsOfTheJointsAskNoMotorForMoreThanItsLimitAtRest) {
  const ParallelJoints& pair = right_ankle();
  const Joint& pitch = parallel_biped().joints[static_cast<std::size_t>(pair.joints[0])];
  const Joint& roll = parallel_biped().joints[static_cast<std::size_t>(pair.joints[1])];
  RodPosture p;
  ASSERT_TRUE(pair.drive.at(Vector2d::Zero(), p));
  double most = 0.0;
  for (const double sign : {1.0, -1.0}) most = std::max(most, (p.jacobian * Vector2d(pitch.velocity, sign * roll.velocity)).cwiseAbs().maxCoeff());
  EXPECT_NEAR(most, 16.0, 1e-9);
  // In every posture of the box, where it is slower.
  const Vector2d slow = speed_box(pair.drive, pair.box, {pitch.velocity, roll.velocity});
  EXPECT_LT(slow[0], pitch.velocity);
  for (const Vector2d& q : postures(pair.box, 1000)) {
    ASSERT_TRUE(pair.drive.at(q, p));
    for (const double sign : {1.0, -1.0}) EXPECT_LE((p.jacobian * Vector2d(slow[0], sign * slow[1])).cwiseAbs().maxCoeff(), 16.0 * 1.01);
  }
}

TEST(DriveTorque, TorquesOfTheJointsAreThoseOfTheMotorsByVirtualWork) {
  const RodDrive drive = crooked();
  for (const Vector2d& q : postures({{-0.4, -0.3}, {0.4, 0.3}}, 100)) {
    RodPosture p;
    ASSERT_TRUE(drive.at(q, p));
    const Vector2d motors(7.0, -4.0), speeds(0.3, 0.8);
    const Vector2d joints = p.jacobian.transpose() * motors;
    EXPECT_NEAR(joints.dot(speeds), motors.dot(p.jacobian * speeds), 1e-12);
    const LimitedTorque free = limit_at_motors(p.jacobian, drive.torque_limits(), joints);
    EXPECT_FALSE(free.limited);
    EXPECT_LT((free.motors - motors).norm(), 1e-12);
    EXPECT_EQ(free.tau, joints);
  }
}

TEST(DriveTorque, ThePairIsLimitedByAParallelogramAndNotByABox) {
  const ParallelJoints& pair = right_ankle();
  RodPosture p;
  ASSERT_TRUE(pair.drive.at(Vector2d::Zero(), p));
  const Vector2d limit = pair.drive.torque_limits(), alone = torque_alone(pair.drive, p), both = torque_box(pair.drive, p);
  const auto limited = [&](const Vector2d& tau) { return limit_at_motors(p.jacobian, limit, tau); };
  // One joint alone has all of both motors; both joints at once have half of it each, and no more.
  for (const Vector2d& tau : {Vector2d(alone[0], 0.0), Vector2d(0.0, alone[1]), both, Vector2d(both[0], -both[1])})
    EXPECT_FALSE(limited(0.999 * tau).limited);
  EXPECT_TRUE(limited(0.999 * alone).limited);
  EXPECT_TRUE(limited(1.001 * both).limited || limited({1.001 * both[0], -1.001 * both[1]}).limited);
  EXPECT_LT(limited(alone).tau[0], 0.75 * alone[0]);
  EXPECT_NEAR(limited({2.0 * alone[0], 0.0}).tau[0], alone[0], 1e-9);
  for (const Vector2d& asked : postures({{-500, -500}, {500, 500}}, 200)) {
    const LimitedTorque cut = limited(asked);
    EXPECT_LE((cut.motors.cwiseAbs() - limit).maxCoeff(), 1e-12);
    EXPECT_LT((p.jacobian.transpose() * cut.motors - cut.tau).norm(), 1e-9);
  }
}

TEST(DriveTorque, ServosOfTheMotorsGiveTheTorqueOfThoseOfTheJointsAndBack) {
  const RodDrive drive = crooked();
  const Vector2d now(0.1, -0.05), still = Vector2d::Zero();
  RodPosture p;
  ASSERT_TRUE(drive.at(now, p));
  const PairServo joints{.q = {0.13, -0.02}, .qd = {0.5, -0.2}, .tau = {3.0, -2.0}, .kp = {900.0, 700.0}, .kd = {20.0, 15.0}};
  PairServo motors, back;
  ASSERT_TRUE(servo_of_motors(drive, joints, now, p, motors));
  EXPECT_TRUE((motors.kp.array() >= 0.0).all() && (motors.kd.array() >= 0.0).all());
  const Vector2d given = p.jacobian.transpose() * (motors.kp.cwiseProduct(motors.q - p.motors) + motors.tau);
  const Vector2d wanted = joints.kp.cwiseProduct(joints.q - now) + joints.tau;
  EXPECT_LT((given - wanted).norm(), 1e-9 * wanted.norm());
  ASSERT_TRUE(servo_of_joints(drive, motors, now, still, p, back));
  EXPECT_LT((back.q - joints.q).norm(), 1e-9);
  EXPECT_LT((back.qd - joints.qd).norm(), 1e-9);
  const Vector2d damped = p.jacobian.transpose() * motors.kd.cwiseProduct(motors.qd);
  EXPECT_LT((back.kp.cwiseProduct(back.q - now) + back.kd.cwiseProduct(back.qd) + back.tau - wanted - damped).norm(), 1e-8 * wanted.norm());
  PairServo far = joints;
  far.q = {0.0, 1.5};  // the rods of the ankle do not reach so far
  EXPECT_FALSE(servo_of_motors(right_ankle().drive, far, now, p, motors));
}

TEST(ParallelJoints, TheJointsHaveTheLimitsOfTheirMotors) {
  const Model& model = parallel_biped();
  ASSERT_EQ(ankles().size(), 2u);
  const Model plain = load_robot("biped12");
  EXPECT_NE(model.hash, plain.hash);
  EXPECT_TRUE(parallel_joints_of(plain).empty());
  const ParallelJoints& pair = right_ankle();
  EXPECT_TRUE(pair.driver_of_motors);
  const Joint& pitch = model.joints[static_cast<std::size_t>(pair.joints[0])];
  EXPECT_EQ(pitch.name, "RLEG_ANKLE_P");
  EXPECT_NEAR(pitch.effort, 180.0, 1e-9);         // two motors of 90 N m, 1 : 1
  EXPECT_NEAR(pitch.rotor_inertia, 0.02, 1e-12);  // two of 0.01
  EXPECT_EQ(pair_with(ankles(), pair.joints[1]), &pair);
  EXPECT_EQ(pair_with(ankles(), model.find_joint("RLEG_KNEE")), nullptr);
}

// A speed of 0 in a URDF is none: the pair's own share it, and the joint that has a limit keeps most of it.
TEST(ParallelJoints, AJointWithoutASpeedOfItsOwnTakesLittleOfThatOfItsPartner) {
  const Model plain = load_robot("biped12");
  std::string urdf = plain.urdf_text;
  const std::size_t joint = urdf.find("<joint name=\"RLEG_ANKLE_R\""), speed = urdf.find("velocity=\"", joint) + 10;
  ASSERT_LT(speed, urdf.find("</joint>", joint));
  urdf.replace(speed, urdf.find('"', speed) - speed, "0");
  const Model model = load_robot_texts(
      {.folder = plain.folder, .yaml = plain.yaml_text + parallel_ankles_text(), .urdf = urdf, .srdf = plain.srdf_text});
  const auto speed_of = [](const Model& robot, const char* name) { return robot.joints[static_cast<std::size_t>(robot.find_joint(name))].velocity; };
  EXPECT_GT(speed_of(model, "RLEG_ANKLE_P"), 0.5 * speed_of(parallel_biped(), "RLEG_ANKLE_P"));
  EXPECT_LT(speed_of(model, "RLEG_ANKLE_R"), 16.5);  // of its motors, 1 : 1
}

std::string refusal(std::string from, const std::string& to) {
  std::string text = parallel_ankles_text();
  const std::size_t at = text.find(from);
  if (at == std::string::npos) return "the test's text has no " + from;
  text.replace(at, from.size(), to);
  return error_of([&] { (void)biped12_with(text); });
}

TEST(ParallelJoints, HostileTextsAreRefusedWithLineKeyAndRemedy) {
  const std::vector<std::array<std::string, 3>> cases = {
      {"[RLEG_ANKLE_P, RLEG_ANKLE_R]", "[RLEG_ANKLE_R, RLEG_ANKLE_P]", "in series"},
      {"[RLEG_ANKLE_P, RLEG_ANKLE_R]", "[RLEG_ANKLE_P]", "two joints"},
      {"[RLEG_ANKLE_P, RLEG_ANKLE_R]", "[RLEG_ANKLE_P, RLEG_ANKLE_P]", "twice"},
      {"[RLEG_ANKLE_P, RLEG_ANKLE_R]", "[RLEG_ANKLE_P, RLEG_ANKLE_X]", "RLEG_ANKLE_"},
      {"[LLEG_ANKLE_P, LLEG_ANKLE_R]\n    parent: LLEG_KNEE\n    child: LLEG_ANKLE_R",
       "[RLEG_ANKLE_P, RLEG_ANKLE_R]\n    parent: RLEG_KNEE\n    child: RLEG_ANKLE_R", "another pair"},
      {"parent: RLEG_KNEE", "parent: RLEG_HIP_P", "does not carry"},
      {"parent: RLEG_KNEE", "parent: NOWHERE", "NOWHERE"},
      {"child: RLEG_ANKLE_R", "child: RLEG_KNEE", "is not moved by"},
      {"driver: motors", "driver: firmware", "driver"},
      {"name: RLEG_ROD_OUT", "name: RLEG_ROD_IN", "first motor"},
      {"axis: [0, 1, 0]", "axis: [0, 0, 0]", "direction"},
      {"axis: [0, 1, 0]", "axis: [0, .nan, 0]", "axis"},
      {"arm: [-0.0478, 0.05, -0.0852]", "arm: [0, 0.06, -0.1]", "1 mm"},
      {"arm: [-0.0478, 0.05, -0.0852]", "arm: [-0.0478, 0.05, -0.2852]", "no length"},
      {"rod: [-0.0478, 0.05, 0.0148]", "rod: [-0.0478, 0.05]", "rod"},
      {"rod: [-0.0478, 0.05, 0.0148]", "rod: [-0.0478, 50, 0.0148]", "10 m"},
      {"torque: 90", "torque: 0", "torque"},
      {"torque: 90", "torq: 90", "torq"},
      {"speed: 16", "speed: -1", "speed"},
      {"range: [-1.3, 1.3]", "range: [0.1, 1.3]", "hold 0"},
      {"range: [-1.3, 1.3]", "range: [-4, 1.3]", "pi"},
      {"range: [-1.3, 1.3]", "range: [-1e-3, 1e-3]", "nothing is left"},
  };
  for (const auto& [from, to, expected] : cases) {
    const std::string error = refusal(from, to);
    EXPECT_NE(error.find(expected), std::string::npos) << to << ": " << error;
    EXPECT_NE(error.find("robot.yaml:"), std::string::npos) << to << ": " << error;
  }
}

TEST(ParallelJoints, ASingularGeometryIsRefused) {
  // Crank and rod in line: the motor is at its dead centre.
  std::string error = refusal("arm: [-0.0478, 0.05, -0.0852]", "arm: [-0.0143, 0.05, -0.1556]");
  EXPECT_NE(error.find("nearly in line"), std::string::npos) << error;
  // Both rods in one plane with the roll axis: no motor rolls the foot.
  std::string text = parallel_ankles_text();
  for (const std::string side : {" 0.05,", " -0.05,"}) {
    for (std::size_t at = text.find(side); at != std::string::npos; at = text.find(side)) text.replace(at, side.size(), " 0,");
  }
  error = error_of([&] { (void)biped12_with(text); });
  EXPECT_NE(error.find("both rods pull the same way"), std::string::npos) << error;
}

}  // namespace
}  // namespace twinbus::test
