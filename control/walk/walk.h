// Walking: one tick from the estimate to the set-points of the legs and torques of all joints.
//
// All in the estimator's world.  measure -> pattern (footholds, reference) -> stabilizer (ZMP, who carries it) -> feet
// (poses asked of the soles) -> whole-body inverse kinematics -> recursive Newton-Euler with the shared wrenches.
// Unlike standing balance the legs are position-controlled: a foot in the air must go where it was sent.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "control/walk/footsteps.h"
#include "control/walk/ground_follow.h"
#include "control/joint/min_jerk.h"
#include "control/walk/walk_feet.h"
#include "control/walk/walk_gains.h"
#include "control/walk/walk_pattern.h"
#include "control/walk/walk_stabilizer.h"
#include "control/legs/behavior.h"
#include "control/legs/whole_body_ik.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"
#include "lcmtypes/msg/step_list.h"

namespace twinbus::inline control {

class Walk final : public Behavior {
 public:
  // Throws std::runtime_error with one sentence when the robot cannot walk.
  Walk(const Model& model, const WalkGains& gains);

  const char* why_no_walk(const Estimator& estimator) const noexcept override;
  const char* caution(const Estimator& estimator) const noexcept override;
  // Standing on both feet.
  void start(const Estimator& estimator) noexcept override;
  void rebase() noexcept override { stabilizer_.rebase(); }

  // vx, vy, wz [m/s, m/s, rad/s]; cut to what the robot can, and where landings find the ground rough to a share of its fastest.
  // One whose feet feel nothing walks at two fifths of its fastest at most, and on flat ground only: where it is found not to be
  // flat the robot stops for good.
  void want(const Eigen::Vector3d& velocity) noexcept override;
  const char* why_stopped() const noexcept override;
  // Footsteps from where it stands.  Null, or a sentence that lives for ever: why not.
  const char* follow(const StepList& list) noexcept;
  // The shortest stop that catches the robot.
  void halt() noexcept { pattern_.halt(); }
  void leave_walk(bool at_once, bool tidy, bool again) noexcept override;

  void update(const Estimator& estimator, const Eigen::VectorXd& q_given, double dt) noexcept override;

  // Ahead of the robot by dt [s], as the model says it will be; without its joints.
  void foresee(double dt) noexcept;
  // The joints of what was foreseen; q_given as above.
  void foresee_joints(const Eigen::VectorXd& q_given, int rounds) noexcept;
  // These set-points [joint_count] were in force meanwhile: the soles are where they put them, and come into the plan from
  // there as after a landing.
  void take_over(const Eigen::VectorXd& q, const Eigen::VectorXd& qd) noexcept;

  // On both feet.
  bool resting() const noexcept override;
  bool moves() const noexcept override { return true; }
  bool stopped(const Estimator&) const noexcept override { return false; }  // it is left first
  bool follows_measured() const noexcept override { return false; }

  const WalkPattern& pattern() const noexcept { return pattern_; }
  const WalkStabilizer& stabilizer() const noexcept { return stabilizer_; }
  const Gait& gait() const noexcept { return pattern_.gait(); }
  // World, for the status.
  const Eigen::Vector3d& com() const noexcept { return com_; }
  const Eigen::Vector3d& com_velocity() const noexcept { return com_velocity_; }
  const Eigen::Vector2d& dcm() const noexcept { return dcm_; }
  Eigen::Vector3d com_reference() const noexcept;
  Eigen::Vector3d reference_velocity() const noexcept;      // of the centre of mass
  Eigen::Vector3d reference_acceleration() const noexcept;
  const Configuration& posture() const noexcept { return ik_.configuration(); }  // as the joints are sent
  const std::vector<ExternalWrench>& wrenches() const noexcept { return wrench_; }  // of the soles, as shared
  double omega() const noexcept;                                                   // of the pendulum [1/s]
  double carried_mass() const noexcept { return load_ * mass_; }                   // [kg]
  std::array<double, 2> foot_forces() const noexcept override { return {wanted_[0].force, wanted_[1].force}; }
  Eigen::Vector3d most_velocity() const noexcept override { return gait().most_velocity; }
  BehaviorReport report(const Estimator& estimator) const noexcept override;

 private:
  void measure(const Estimator& estimator, double dt, bool fresh) noexcept;
  std::array<bool, 2> touching(const Estimator& estimator) const noexcept;
  void watch_ground(double dt) noexcept;
  void share_load() noexcept;
  // Shares the load, then moves the feet; measured_base: null when it is where it was asked to be.
  void load_feet(const Eigen::Isometry3d* measured_base, double dt) noexcept;
  void feed_forward(double dt) noexcept;
  double vertical_acceleration() const noexcept {
    return height_.acceleration() + ground_.acceleration();
  }
  Eigen::Matrix3d attitude() const noexcept;

  const Model* model_;
  WalkGains gains_;
  WalkPattern pattern_;
  WalkStabilizer stabilizer_;
  WalkFeet feet_;
  WholeBodyIk ik_;
  InverseDynamics dynamics_;
  double mass_;
  double load_ = 1.0;  // what the feet carry, of the robot's own weight

  Eigen::Vector3d com_ = Eigen::Vector3d::Zero(), com_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d dcm_ = Eigen::Vector2d::Zero();
  std::array<Foothold, 2> measured_feet_;
  std::array<FootLoad, 2> wanted_, measured_;
  MinJerk height_, first_;  // of the centre of mass; 1 -> 0: share of the first tilt still held
  GroundFollow ground_;
  double shift_ = 0.0;  // of heights, from the estimator's to those of the footholds [m]
  Eigen::Vector3d first_turn_ = Eigen::Vector3d::Zero();
  double heading_ = 0.0;
  bool fresh_ = true, resumes_ = false;
  bool feels_ = true, steep_ = false;
  double unfelt_ = 0.0;  // no force has been felt for so long [s]
  double tilt_ = 0.0;    // of the standing soles of feet that feel nothing, smoothed [rad]
};

}  // namespace twinbus::control
