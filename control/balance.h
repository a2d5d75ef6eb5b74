// Standing on both feet: one tick from the estimate to leg set-points with feed-forward torque.
//
// Everything happens in the ground frame (midway between the soles, z up), so neither drift of
// heading nor of world position matters.  plan (com_motion) -> DCM feedback (stabilizer) -> load of
// each sole (wrench_share) -> where the soles are sent so that they carry it (foot_compliance) ->
// whole-body inverse kinematics -> recursive Newton-Euler with the shared contact wrenches.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "control/balance_gains.h"
#include "control/com_motion.h"
#include "control/foot_compliance.h"
#include "control/stabilizer.h"
#include "control/trunk_yield.h"
#include "control/whole_body_ik.h"
#include "robot/dynamics.h"
#include "robot/estimator.h"
#include "robot/model.h"

namespace twinbus {

class Balance {
 public:
  // Why this robot cannot balance, or null.
  static const char* why_not(const Model& model) noexcept;
  // Throws std::runtime_error when why_not is not null.
  Balance(const Model& model, const BalanceGains& gains);

  // Begins where the robot is, with its velocity; motion is forgotten.
  void start(const Estimator& estimator) noexcept;
  // The same robot through another source: references and motion go on, filters and errors are
  // re-based.
  void rebase(const Estimator& estimator) noexcept;

  void request(Motion motion, double amplitude, double frequency) noexcept {
    motion_.request(motion, amplitude, frequency);
  }
  void stop_motion(double duration) noexcept { motion_.stop(duration); }
  void lean(const Eigen::Vector3d& offset) noexcept { motion_.lean(offset); }

  // q_given, qd_given [joint_count]: of the joints that are not of a leg; the others are ignored.
  void update(const Estimator& estimator, const Eigen::VectorXd& q_given, double dt) noexcept;

  // Set-points of all joints, [joint_count]; of those given, only tau is news.
  const Eigen::VectorXd& q() const noexcept { return q_; }
  const Eigen::VectorXd& qd() const noexcept { return qd_; }
  const Eigen::VectorXd& tau() const noexcept { return tau_; }
  bool is_leg(int joint) const noexcept { return ik_.is_leg(joint); }
  // Servo gains of a joint.
  double kp(int joint) const noexcept { return kp_[joint]; }
  double kd(int joint) const noexcept { return kd_[joint]; }
  bool finite() const noexcept { return finite_; }
  // Standing still on purpose: no motion asked, nothing moves.
  bool resting() const noexcept;

  // For the status; ground frame.
  const Eigen::Vector3d& com() const noexcept { return com_; }
  const Eigen::Vector3d& com_velocity() const noexcept { return com_velocity_; }
  Eigen::Vector3d com_reference() const noexcept;
  const Eigen::Vector2d& dcm() const noexcept { return dcm_; }
  const Stabilizer& stabilizer() const noexcept { return stabilizer_; }
  Motion motion() const noexcept { return motion_.motion(); }

 private:
  void measure(const Estimator& estimator, double dt, bool fresh) noexcept;
  void take_soles(const Estimator& estimator, double share) noexcept;
  void load_soles(const Estimator& estimator, double dt) noexcept;
  std::array<Eigen::Isometry3d, 2> sole_targets() const noexcept;
  void feed_forward(double dt) noexcept;
  double omega() const noexcept;

  const Model* model_;
  BalanceGains gains_;
  ComMotion motion_;
  Stabilizer stabilizer_;
  TrunkYield trunk_;
  FootCompliance foot_;
  WholeBodyIk ik_;
  InverseDynamics dynamics_;

  std::array<SoleOnGround, 2> soles_;
  std::array<double, 2> first_height_{};  // what start() found, fades out
  std::array<Eigen::Vector3d, 2> first_turn_{};
  Eigen::Vector3d first_base_turn_ = Eigen::Vector3d::Zero();
  MinJerk first_;  // 1 -> 0
  Eigen::Vector3d home_ = Eigen::Vector3d::Zero();

  Eigen::Vector3d com_ = Eigen::Vector3d::Zero(), com_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d momentum_ = Eigen::Vector2d::Zero(), dcm_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d tilt_ = Eigen::Vector2d::Zero(), tilt_rate_ = Eigen::Vector2d::Zero();  // roll, pitch of the base
  double mass_;
  bool fresh_ = true, finite_ = true;
  Configuration last_;  // of the inverse kinematics, a tick ago
  Eigen::VectorXd q_, qd_, qdd_, tau_, kp_, kd_;
  std::vector<ExternalWrench> wrench_;
  Configuration motion_state_;  // for the inverse dynamics
  Kinematics motion_kinematics_;
};

}  // namespace twinbus
