// Torque of two joints whose motors are limited, in a step whose servos act at its end: a problem of two unknowns.
//
// The servos ask for force - gain qd+ of the joints' speeds at the end of the step; what the motors give of it is limit_at_motors()
// (robot/parallel/drive_torque.h).  A pass of an engine applies a torque and finds qd+, which is affine in it as long as contacts and
// stops stay as they are.  From pass to pass its derivative is learned (Broyden 1965, A class of methods for solving nonlinear
// simultaneous equations), and the next torque solves the limited law with it exactly, each motor below its limit or at it.

#pragma once

#include <Eigen/Core>

namespace twinbus::inline sim {

class PairSolve {
 public:
  static constexpr double kSettled = 1e-5;  // of the larger limit of the motors

  // A step begins.  jacobian: d motors / d joints at its start; limit: of the motors [N m]; force, gain: of the joints' servos.
  void begin(const Eigen::Matrix2d& jacobian, const Eigen::Vector2d& limit, const Eigen::Vector2d& force,
             const Eigen::Vector2d& gain) noexcept;
  // Whether the torque applied in a pass that ended with these speeds is what the motors give at them.
  bool settled(const Eigen::Vector2d& applied, const Eigen::Vector2d& qd) const noexcept;
  // The torque for the next pass, after one that was not settled.
  Eigen::Vector2d next(const Eigen::Vector2d& applied, const Eigen::Vector2d& qd) noexcept;
  // In this step the servos' own lines have been left.
  bool limited() const noexcept { return limited_; }

 private:
  Eigen::Matrix2d jacobian_ = Eigen::Matrix2d::Identity(), to_motors_ = Eigen::Matrix2d::Identity();
  Eigen::Vector2d limit_ = Eigen::Vector2d::Zero(), force_ = Eigen::Vector2d::Zero(), gain_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d mobility_ = Eigen::Matrix2d::Zero();  // d qd+ / d torque
  Eigen::Vector2d applied_ = Eigen::Vector2d::Zero(), qd_ = Eigen::Vector2d::Zero();  // of the pass before
  bool limited_ = false;
};

}  // namespace twinbus::sim
