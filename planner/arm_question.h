// What an arm planner was asked, as it understands it.  For the files of ArmPlanner alone.

#pragma once

#include <string>
#include <vector>

#include "common/math/index.h"
#include "planner/arm_planner.h"
#include "planner/joint_turns.h"
#include "planner/search/free_space.h"
#include "planner/timing/motion_effort.h"

namespace twinbus::inline planner {

struct ArmPlanner::Question {
  const ArmGoal* goal = nullptr;
  const Configuration* start_posture = nullptr;
  const Hand* hand = nullptr;
  int base_link = 0;                                            // that the arm hangs on
  Eigen::Isometry3d target;                                     // of the hand frame, in base_link
  Eigen::Matrix3d base_in_world = Eigen::Matrix3d::Identity();  // how base_link is turned
  JointPoint start;
  JointTurns range;  // of the joints
  int carriers = 0;  // so many joints, the first ones, carry the arm
  JointPath goals;   // free postures that answer the goal
  JointPath nearly;  // and some that barely miss it
};

// The planned joints of a posture.
inline JointPoint pick(const Eigen::VectorXd& q, const std::vector<int>& joints) {
  JointPoint point(static_cast<int>(joints.size()));
  for (int k = 0; k < point.size(); ++k) point[k] = q[joints[at(k)]];
  return point;
}

// A base on the plane goes no farther from the straight way to the goal than the arm is long, and as it takes to go around things: the
// range of its x and y (arm_goals.cpp).
// target: in the frame of the link that the first joint moves on [m].
void stay_near(const Model& model, const Configuration& start, const std::vector<int>& joints, const Hand& hand,
               const Eigen::Vector3d& target, JointTurns& range);

inline std::string too_heavy(const Model& model, const MotionEffort& effort, const char* where) {
  return std::string(where) + " joint " + model.joints[at(effort.weak_joint())].name +
         (effort.rubs() ? " would need more than its effort limit to move the arm against its friction"
                        : " would need more than its effort limit to hold the arm");
}

}  // namespace twinbus::planner
