#include "planner/timing/motion_effort.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/math/index.h"
#include "test/planner/reach_rig.h"

namespace twinbus {
namespace {

std::vector<int> arm_joints() { return hrp1s().hands.front().joints; }

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
  const std::vector<int> joints = arm_joints();
  TimedPath path = swing(standing(), joints);
  slow_down(path, 5.0);
  EXPECT_EQ(MotionEffort(hrp1s(), standing(), joints).slower(path), 1.0);
}

TEST(MotionEffort, AMotionThatIsTooHardJustMeetsTheLimitsWhenSlowed) {
  const Configuration start = standing();
  const std::vector<int> joints = arm_joints();
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
  const std::vector<int> joints = arm_joints();
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

}  // namespace
}  // namespace twinbus
