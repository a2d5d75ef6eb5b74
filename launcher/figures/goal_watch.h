// How many of a scene's arm goals the arm came to: its path done and, half a second later, the hand within 5 mm of its goal, or
// the joints within 0.01 rad (or m) of theirs.

#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline launcher {

// A goal that the arm did not come to.
struct MissedGoal {
  enum class Why { kNoPath, kNotBegun, kUnderWay, kOff };

  int number = 0;  // of the goals that were asked, from 1 on
  ArmGoal goal{};
  Why why = Why::kNoPath;
  double off = 0.0;  // half a second after its path [m], of joints [rad] or [m]; of kOff alone
};

class GoalWatch {
 public:
  static constexpr double kFar = 0.005;      // of a hand, at most [m]
  static constexpr double kFarJoint = 0.01;  // of a joint, at most [rad] or [m]

  // Another goal, and where its path ends these joints; no joints: it was refused.
  void ask(const ArmGoal& goal, std::vector<int> joints, Eigen::VectorXd end) {
    missed_ = missed();  // the one before has no more time
    ++asked_;
    goal_ = goal;
    if (joints.empty()) missed_.push_back({asked_, goal, MissedGoal::Why::kNoPath, 0.0});
    joints_ = std::move(joints);
    end_ = std::move(end);
    moves_ = false;
    done_ = std::nan("");
  }

  // Each tick; hand_in_ground(side): where that hand is.
  template <class HandInGround>
  void add(double time, const ControllerStatus& status, const Configuration& now, HandInGround hand_in_ground) {
    if (joints_.empty()) return;
    moves_ = moves_ || (status.arm_path_id == goal_.goal_id && status.arm_state == kFollowing);
    if (moves_ && status.arm_state == kDone && std::isnan(done_)) done_ = time;
    if (!(time >= done_ + kSettled)) return;
    const double far = off(now, hand_in_ground);
    const bool of_hand = goal_.kind != ArmGoalKind::kJoints;
    double& most = of_hand ? hand_off_ : joint_off_;
    most = std::max(most, far);
    if (far <= (of_hand ? kFar : kFarJoint)) {
      ++reached_;
    } else {
      missed_.push_back({asked_, goal_, MissedGoal::Why::kOff, far});
    }
    joints_.clear();
  }

  int asked() const { return asked_; }
  int reached() const { return reached_; }
  // So far; the last one too if its path has not come to its end.
  std::vector<MissedGoal> missed() const {
    std::vector<MissedGoal> all = missed_;
    if (!joints_.empty()) all.push_back({asked_, goal_, moves_ ? MissedGoal::Why::kUnderWay : MissedGoal::Why::kNotBegun, 0.0});
    return all;
  }
  double hand_off() const { return hand_off_; }    // at most, of goals to which a path was done [m]
  double joint_off() const { return joint_off_; }  // [rad] or [m]

 private:
  static constexpr int kFollowing = 1, kDone = 2;  // arm_state
  static constexpr double kSettled = 0.5;          // [s]

  // [m] of a hand, [rad] or [m] of a joint.
  template <class HandInGround>
  double off(const Configuration& now, HandInGround hand_in_ground) const {
    if (goal_.kind != ArmGoalKind::kJoints) {
      const Eigen::Vector3d asked(goal_.position[0], goal_.position[1], goal_.position[2]);
      return (hand_in_ground(goal_.side) - asked).norm();
    }
    double most = 0.0;
    for (std::size_t k = 0; k < joints_.size(); ++k)
      most = std::max(most, std::abs(now.q[joints_[k]] - end_[static_cast<Eigen::Index>(k)]));
    return most;
  }

  ArmGoal goal_;
  std::vector<int> joints_;
  Eigen::VectorXd end_;
  bool moves_ = false;
  double done_ = std::nan("");  // when [s]
  int asked_ = 0, reached_ = 0;
  double hand_off_ = 0.0, joint_off_ = 0.0;
  std::vector<MissedGoal> missed_;
};

}  // namespace twinbus::launcher
