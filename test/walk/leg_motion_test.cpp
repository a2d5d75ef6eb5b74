// Legs of five and of seven joints: what their soles do when all six coordinates of a sole are asked for.

#include "robot/kinematics/leg_motion.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "common/math/index.h"
#include "common/math/pose_math.h"
#include "control/legs/leg_reach.h"
#include "control/legs/whole_body_ik.h"
#include "control/walk/footsteps.h"
#include "robot/description/load.h"

namespace twinbus {
namespace {

std::string text_of(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

RobotTexts biped() {
  const std::string folder = robot_folder("biped12");
  return {folder, text_of(folder + "/robot.yaml"), text_of(folder + "/biped12.urdf"), text_of(folder + "/biped12.srdf")};
}

std::string without(const std::string& text, const std::string& pattern) { return std::regex_replace(text, std::regex(pattern), ""); }

// A joint of each leg is welded.
Model welded(const std::string& joint) {
  RobotTexts texts = biped();
  texts.urdf = std::regex_replace(texts.urdf, std::regex("(<joint name=\"[RL]LEG_" + joint + "\" type=\")revolute"), "$1fixed");
  texts.yaml = without(without(texts.yaml, ",\\s*[RL]LEG_" + joint), "[RL]LEG_" + joint + ",\\s*");
  texts.srdf = without(texts.srdf, "<joint name=\"[RL]LEG_" + joint + "\"[^>]*/>");
  return load_robot_texts(texts);
}

// Each thigh turns about its length in its middle.
Model seven_joints() {
  RobotTexts texts = biped();
  for (const std::string side : {"R", "L"}) {
    const std::string thigh = side + "LEG_THIGH", knee = side + "LEG_KNEE", hip = side + "LEG_HIP_P";
    const std::regex at_knee("(<joint name=\"" + knee + "\"[^>]*><parent link=\")" + hip + "(\"[^\\n]*\\n\\s*<origin xyz=\"0 0 )-0.3");
    texts.urdf = std::regex_replace(texts.urdf, at_knee, "$1" + thigh + "$2-0.15");
    texts.urdf.insert(texts.urdf.find("</robot>"),
                      "<link name='" + thigh + "'><inertial><mass value='0.5'/>"
                      "<inertia ixx='0.001' iyy='0.001' izz='0.001' ixy='0' ixz='0' iyz='0'/></inertial></link>"
                      "<joint name='" + thigh + "' type='revolute'><parent link='" + hip + "'/><child link='" + thigh + "'/>"
                      "<origin xyz='0 0 -0.15'/><axis xyz='0 0 1'/>"
                      "<limit lower='-0.8' upper='0.8' effort='120' velocity='6'/></joint>");
    texts.yaml = std::regex_replace(texts.yaml, std::regex(knee), thigh + ", " + knee);
  }
  return load_robot_texts(texts);
}

struct Standing {
  explicit Standing(const Model& m) : model(m), ik(m), start(m, "half_sitting"), now(m) {
    now.update(start);
    for (int f = 0; f < 2; ++f) soles[at(f)] = sole(f);
    com = now.com();
    ik.start(start);
  }
  Eigen::Isometry3d sole(int f) const { return now.link_in_world(model.soles[at(f)].link) * model.soles[at(f)].frame; }
  void solve(int rounds) {
    ik.solve(com, Eigen::Matrix3d::Identity(), soles, start.q, rounds);
    now.update(ik.configuration());
  }
  double miss() const {
    double worst = (now.com() - com).norm();
    for (int f = 0; f < 2; ++f) {
      worst = std::max({worst, (sole(f).translation() - soles[at(f)].translation()).norm(),
                        rotation_vector(sole(f).linear() * soles[at(f)].linear().transpose()).norm()});
    }
    return worst;
  }
  const Model& model;
  WholeBodyIk ik;
  Configuration start;
  Kinematics now;
  std::array<Eigen::Isometry3d, 2> soles;
  Eigen::Vector3d com;
};

TEST(LegMotion, FiveJointsGiveUpTheAxisThatTheMissingOneTurned) {
  EXPECT_EQ(free_axis(welded("ANKLE_R"), 0), 0);
  EXPECT_EQ(free_axis(welded("ANKLE_P"), 1), 1);
  EXPECT_EQ(free_axis(welded("HIP_Y"), 0), 2);
  EXPECT_EQ(free_axis(load_robot("biped12"), 0), -1);
  EXPECT_EQ(free_axis(seven_joints(), 0), -1);
}

TEST(LegMotion, FiveJointsHoldPlacePitchAndYawAndTheRollFollows) {
  const Model model = welded("ANKLE_R");
  Standing robot(model);
  robot.com += Eigen::Vector3d(0.02, 0.04, 0.0);
  robot.soles[0].translation() += Eigen::Vector3d(0.10, 0.03, 0.04);
  robot.soles[0].linear() = rotation_z(0.2) * rotation_of({0.0, 0.1, 0.0}) * robot.soles[0].linear();
  robot.solve(20);
  EXPECT_LT((robot.now.com() - robot.com).norm(), 1e-6);
  for (int f = 0; f < 2; ++f) {
    const Eigen::Isometry3d is = robot.sole(f), asked = robot.soles[at(f)];
    EXPECT_LT((is.translation() - asked.translation()).norm(), 1e-6) << f;
    EXPECT_LT((is.linear().col(0) - asked.linear().col(0)).norm(), 1e-6) << f;  // forward: pitch and yaw
    EXPECT_GT((is.linear().col(1) - asked.linear().col(1)).norm(), 0.02) << f;  // as the leg leans
  }
}

TEST(LegMotion, SevenJointsFollowBothSolesAndComeBackToTheirPosture) {
  const Model model = seven_joints();
  Standing robot(model);
  const Eigen::Vector3d com = robot.com, foot = robot.soles[1].translation();
  const Eigen::Matrix3d flat = robot.soles[1].linear();
  Eigen::VectorXd last = robot.start.q;
  double worst = 0.0, fastest = 0.0;
  constexpr int kTicks = 6000;  // ten rounds, then rest
  for (int i = 0; i < kTicks; ++i) {
    const double t = 0.002 * std::min(i, kTicks / 2), turn = 2.0 * 3.141592653589793 * t / 0.6;
    robot.com = com + 0.03 * Eigen::Vector3d(std::sin(turn), 1.0 - std::cos(turn), 0.0);
    robot.soles[1].translation() = foot + Eigen::Vector3d(0.08 * std::sin(turn), 0.0, 0.03 * (1.0 - std::cos(turn)));
    robot.soles[1].linear() = rotation_z(0.3 * std::sin(turn)) * flat;
    robot.solve(1);
    worst = std::max(worst, robot.miss());
    fastest = std::max(fastest, (robot.ik.configuration().q - last).cwiseAbs().maxCoeff() / 0.002);
    last = robot.ik.configuration().q;
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(fastest, 6.0);
  EXPECT_LT((last - robot.start.q).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(LegMotion, LegsThatCannotTurnWalkStraightAsFastAsTheyCan) {
  const Model model = welded("HIP_Y");
  const Gait gait = gait_of(model, model.walking, 0.01);
  EXPECT_EQ(gait.most_velocity.z(), 0.0);
  const Eigen::Vector3d fast = gait.possible({9.0, 0.0, 0.5});
  EXPECT_NEAR(fast.x(), gait.most_velocity.x(), 1e-12);
  EXPECT_EQ(fast.z(), 0.0);
  EXPECT_EQ(gait.possible({0.1, 0.0, 0.2}), Eigen::Vector3d(0.1, 0.0, 0.0));
  EXPECT_EQ(Gait::share_of({0.1, 0.0, 0.0}, {0.2, 0.1, 0.0}), 0.5);
  // The hip throws the foot, not the knee.
  EXPECT_NEAR(leg_reach(model, 0).swing.x() / leg_reach(load_robot("biped12"), 0).swing.x(), 1.0, 0.1);
}

TEST(LegMotion, AJointOfBothLegsMakesNoLegs) {
  Model model = load_robot("biped12");
  EXPECT_EQ(leg_chain(model, 0).count, 6);
  model.soles[1] = model.soles[0];
  EXPECT_EQ(leg_chain(model, 0).count, 0);
  EXPECT_THROW(LegMotion(model, 0), std::runtime_error);
}

}  // namespace
}  // namespace twinbus
