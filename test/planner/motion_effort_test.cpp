#include "planner/timing/motion_effort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "common/math/index.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

std::vector<int> first_arm() { return hrp1s().hands.front().joints; }

// The whole arm swings by half a radian in a third of a second.
TimedPath swing(const Configuration& start, const std::vector<int>& joints) {
  JointPoint from(static_cast<int>(joints.size()));
  for (int k = 0; k < from.size(); ++k) from[k] = start.q[joints[at(k)]];
  const JointPoint rest = JointPoint::Zero(from.size());
  const JointPoint to = from + JointPoint::Constant(from.size(), 0.5);
  const JointPoint middle = 0.5 * (from + to), fast = 2.2 * (to - from) / 0.33;
  return {{0.0, from, rest}, {0.165, middle, 0.7 * fast}, {0.33, to, rest}};
}

// |effort| / limit of the hardest joint, by the dynamics of a model that knows the limits.
double hardest(const Model& model, const Configuration& start, const std::vector<int>& joints,
               const TimedPath& path) {
  MotionEffort effort(model, start, joints);
  effort.slower(path);
  return effort.largest();
}

TEST(MotionEffort, AnEasyMotionIsLeftAsItIs) {
  const std::vector<int> joints = first_arm();
  TimedPath path = swing(standing(), joints);
  slow_down(path, 5.0);
  EXPECT_EQ(MotionEffort(hrp1s(), standing(), joints).slower(path), 1.0);
}

TEST(MotionEffort, AMotionThatIsTooHardJustMeetsTheLimitsWhenSlowed) {
  const Configuration start = standing();
  const std::vector<int> joints = first_arm();
  TimedPath path = swing(start, joints);
  TimedPath slow = path;
  slow_down(slow, 100.0);
  Model model = hrp1s();
  const double moving = hardest(model, start, joints, path),
               still = hardest(model, start, joints, slow);
  ASSERT_GT(moving, 2.0 * still);
  for (const int joint : joints) model.joints[at(joint)].effort *= 0.5 * (moving + still);
  MotionEffort effort(model, start, joints);
  const double slower = effort.slower(path);
  ASSERT_GT(slower, 1.0);
  slow_down(path, slower);
  EXPECT_NEAR(hardest(model, start, joints, path), 0.995, 1e-6);
  EXPECT_NEAR(effort.slower(path), 1.0, 1e-6);
}

TEST(MotionEffort, AJointThatCannotHoldTheArmIsNamed) {
  const Configuration start = standing();
  const std::vector<int> joints = first_arm();
  Model model = hrp1s();
  const int elbow = joints[3];
  model.joints[at(elbow)].effort = 0.1;
  MotionEffort effort(model, start, joints);
  EXPECT_EQ(effort.slower(swing(start, joints)), 0.0);
  EXPECT_EQ(effort.weak_joint(), elbow);
  MotionEffort still(model, start, joints);
  JointPoint there(static_cast<int>(joints.size()));
  for (int k = 0; k < there.size(); ++k) there[k] = start.q[joints[at(k)]] + 0.5;
  EXPECT_FALSE(still.holds(there));
  EXPECT_EQ(still.weak_joint(), elbow);
  EXPECT_TRUE(MotionEffort(hrp1s(), start, joints).holds(there));
}

// Of hrp1s, whose joints rub.
Model rubbing(const std::vector<int>& joints, double damping, double friction) {
  Model model = hrp1s();
  for (const int joint : joints) {
    model.joints[at(joint)].damping = damping * model.joints[at(joint)].effort;
    model.joints[at(joint)].friction = friction * model.joints[at(joint)].effort;
  }
  return model;
}

// The largest |tau + D qd + F sign(qd)| / limit of the joints at the knots, from the dynamics of a model that does not rub.
double hardest_against_drag(const Model& model, const Configuration& start, const std::vector<int>& joints, const TimedPath& path) {
  Kinematics kinematics(model);
  InverseDynamics dynamics(model);
  Configuration there = start;
  Eigen::VectorXd qdd_all = Eigen::VectorXd::Zero(model.joint_count()), tau = qdd_all;
  JointPoint q, qd, qdd;
  double most = 0.0;
  for (const Knot& knot : path) {
    sample(path, knot.time, q, qd, qdd);
    for (int k = 0; k < q.size(); ++k) {
      there.q[joints[at(k)]] = q[k];
      there.qd[joints[at(k)]] = qd[k];
      qdd_all[joints[at(k)]] = qdd[k];
    }
    kinematics.update(there);
    dynamics.solve(kinematics, there, qdd_all, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {}, tau);
    for (int k = 0; k < q.size(); ++k) {
      const Joint& joint = model.joints[at(joints[at(k)])];
      const double rub = std::abs(qd[k]) < 1e-9 ? 0.0 : std::copysign(joint.friction, qd[k]);
      most = std::max(most, std::abs(tau[joints[at(k)]] + joint.damping * qd[k] + rub) / joint.effort);
    }
  }
  return most;
}

TEST(MotionEffort, DampingAndFrictionTakeOfTheEffortsThatAMotionMayAskFor) {
  const Configuration start = standing();
  const std::vector<int> joints = first_arm();
  TimedPath asked = swing(start, joints);
  slow_down(asked, 0.4);
  for (const auto& [damping, friction] : {std::pair{1.0, 0.0}, {0.0, 0.9}, {0.5, 0.5}, {2.0, 0.7}}) {
    const Model model = rubbing(joints, damping, friction);
    ASSERT_GT(hardest_against_drag(model, start, joints, asked), 1.0) << damping << ", " << friction;
    MotionEffort effort(model, start, joints);
    const double slower = effort.slower(asked);
    TimedPath path = asked;
    slow_down(path, slower);
    EXPECT_NEAR(hardest_against_drag(model, start, joints, path), 0.995, 1e-6) << damping << ", " << friction << ": " << slower;
    EXPECT_GE(slower, MotionEffort(hrp1s(), start, joints).slower(asked));
  }
}

TEST(MotionEffort, AJointWhoseFrictionTakesAllIsNamed) {
  const Configuration start = standing();
  const std::vector<int> joints = first_arm();
  Model model = hrp1s();
  const int elbow = joints[3];
  model.joints[at(elbow)].friction = 2.0 * model.joints[at(elbow)].effort;
  MotionEffort effort(model, start, joints);
  EXPECT_EQ(effort.slower(swing(start, joints)), 0.0);
  EXPECT_EQ(effort.weak_joint(), elbow);
  EXPECT_TRUE(effort.rubs()) << "it can hold the arm";
  JointPoint there(static_cast<int>(joints.size()));
  for (int k = 0; k < there.size(); ++k) there[k] = start.q[joints[at(k)]];
  JointPoint step = JointPoint::Constant(there.size(), 0.1);
  EXPECT_TRUE(effort.holds(there));
  EXPECT_FALSE(effort.creeps(there, step));
  step[3] = 0.0;
  EXPECT_TRUE(effort.creeps(there, step));
}

TEST(MotionEffort, TheLastingSpeedLeavesAPartOfTheEffort) {
  Joint joint;
  joint.velocity = 7.0;
  joint.effort = 15.0;
  EXPECT_EQ(MotionEffort::lasting_speed(joint), 7.0);
  joint.damping = 3.0;
  joint.friction = 10.0;
  const double speed = MotionEffort::lasting_speed(joint);
  EXPECT_GT(speed, 1.0);
  EXPECT_LT(joint.damping * speed + joint.friction, 15.0);
  joint.friction = 15.0;
  EXPECT_EQ(MotionEffort::lasting_speed(joint), 0.0);
  joint.damping = 0.003;
  joint.friction = 0.0;
  EXPECT_EQ(MotionEffort::lasting_speed(joint), 7.0);
}

}  // namespace
}  // namespace twinbus
