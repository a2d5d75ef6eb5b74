// Joints that two motors turn over rods: their servos are limited at the motors, a parallelogram of joint torque instead of a box.
//
// While no motor is at its limit the joints have the lines of their JointLaw. Else they get the torque that PairSolve finds, and the
// solve is repeated until it is the one that the motors give at its own end speeds, with the Jacobian of the start of the step.

#pragma once

#include <cstdint>
#include <vector>

#include "robot/description/parallel_joints.h"
#include "sim/articulated/joint_law.h"
#include "sim/motors/pair_solve.h"

namespace twinbus::inline sim {

class MotorLimits {
 public:
  MotorLimits() = default;
  // Takes the joints' own limits of torque off.  joints: one a joint of the model.
  MotorLimits(const Model& model, std::vector<JointLaw>& joints);

  bool empty() const noexcept { return pairs_.empty(); }
  // After JointLaw::begin() of all joints.
  void begin(const std::vector<JointLaw>& joints, const Eigen::VectorXd& q) noexcept;
  // Pairs whose torques are not those of their end speeds; approach() gives them better ones.  speed(joint): at the end [rad/s].
  template <class Speed>
  int wrong(const std::vector<JointLaw>& joints, Speed&& speed) const noexcept {
    int count = 0;
    for (const Pair& pair : pairs_) {
      const Eigen::Vector2d qd = speeds_of(pair, speed);
      count += pair.solve.settled(applied(joints, pair, qd), qd) ? 0 : 1;
    }
    return count;
  }
  template <class Speed>
  void approach(std::vector<JointLaw>& joints, Speed&& speed) noexcept {
    for (Pair& pair : pairs_) approach(joints, pair, speeds_of(pair, speed));
  }
  // Mixed with which pairs are limited.
  std::uint64_t pattern(std::uint64_t pattern) const noexcept;

 private:
  struct Pair {
    ParallelJoints of;
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();
    PairSolve solve;
  };
  template <class Speed>
  static Eigen::Vector2d speeds_of(const Pair& pair, Speed&& speed) noexcept {
    return {speed(static_cast<std::size_t>(pair.of.joints[0])), speed(static_cast<std::size_t>(pair.of.joints[1]))};
  }
  static Eigen::Vector2d applied(const std::vector<JointLaw>& joints, const Pair& pair, const Eigen::Vector2d& qd) noexcept;
  static void approach(std::vector<JointLaw>& joints, Pair& pair, const Eigen::Vector2d& qd) noexcept;

  std::vector<Pair> pairs_;
};

}  // namespace twinbus::sim
