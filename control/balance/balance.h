// Standing on both feet: one tick from the estimate to torques that make the ground push as balance needs.
//
// Everything happens in the ground frame (midway between the soles, z up), so neither drift of heading nor of world
// position matters.  plan (com_motion) -> zero-moment point and lean (stabilizer, trunk_yield) -> wrench of each sole
// (wrench_share, foot_compliance) -> accelerations while the soles stand (standing_motion) -> recursive Newton-Euler.
// The set-points of the legs are where they are measured, one tick on: the torque is what is fed forward, and the servo
// gains hold a robot that shadows this one, or one that lost its controller.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "control/balance/arm_clearance.h"
#include "control/balance/balance_gains.h"
#include "control/balance/com_motion.h"
#include "control/legs/foot_compliance.h"
#include "control/balance/stabilizer.h"
#include "control/balance/standing_motion.h"
#include "control/balance/angular_momentum_lean.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"

namespace twinbus {

class Balance {
 public:
  // Why this robot cannot balance, or null.
  static const char* why_not(const Model& model) noexcept;
  // Throws std::runtime_error when why_not is not null.
  Balance(const Model& model, const BalanceGains& gains);

  // One call per tick in whatever mode, before update: velocities are low-passed all the time, for of one sample they
  // are noise, which a start would keep and whoever fades to these set-points would take for a motion.
  void watch(const Estimator& estimator, double dt) noexcept;
  // Another robot may be watched from now on.
  void forget() noexcept;
  // Begins where the robot is, with its velocity; motion is forgotten.
  void start(const Estimator& estimator) noexcept;
  // The same robot through another source: references and motion go on, filters and errors are
  // re-based.
  void rebase() noexcept;

  void request(Motion motion, double amplitude, double frequency) noexcept {
    motion_.request(motion, amplitude, frequency);
  }
  void stop_motion(double duration) noexcept { motion_.stop(duration); }
  void lean(const Eigen::Vector3d& offset) noexcept { motion_.lean(offset); }

  // For the next update, besides what else is asked: a way of the centre of mass from home (as ComMotion::follow), and a lean
  // of the base, roll and pitch [rad, rad/s].
  void follow(const Eigen::Vector3d& com, const Eigen::Vector3d& velocity, const Eigen::Vector3d& acceleration,
              const Eigen::Vector2d& lean, const Eigen::Vector2d& lean_rate) noexcept {
    motion_.follow(com, velocity, acceleration);
    lean_wanted_ = lean;
    lean_rate_wanted_ = lean_rate;
    lean_given_ = true;
  }

  void update(const Estimator& estimator, double dt) noexcept;

  // Set-points of the legs and torques of all joints, [joint_count].
  const Eigen::VectorXd& q() const noexcept { return q_; }
  const Eigen::VectorXd& qd() const noexcept { return qd_; }
  const Eigen::VectorXd& tau() const noexcept { return tau_; }
  // Of a joint that is not of a leg: what balance adds to its set-point [rad], [rad/s].
  double offset(int joint) const noexcept { return offset_[joint]; }
  double offset_rate(int joint) const noexcept { return offset_rate_[joint]; }
  bool is_leg(int joint) const noexcept { return leg_[static_cast<std::size_t>(joint)]; }
  // Servo gains of a joint.
  double kp(int joint) const noexcept { return kp_[joint]; }
  double kd(int joint) const noexcept { return kd_[joint]; }
  bool finite() const noexcept { return finite_; }
  // Standing still on purpose: no motion asked, nothing moves.
  bool resting() const noexcept;

  // For the status; ground frame.
  const Eigen::Vector3d& com() const noexcept { return com_; }
  const Eigen::Vector3d& com_velocity() const noexcept { return com_velocity_; }
  Eigen::Vector3d com_reference() const noexcept { return motion_.position(); }
  const Eigen::Vector2d& dcm() const noexcept { return dcm_; }
  const Stabilizer& stabilizer() const noexcept { return stabilizer_; }
  // Normal force asked of each sole [N].
  std::array<double, 2> foot_forces() const noexcept { return foot_forces_; }
  Motion motion() const noexcept { return motion_.motion(); }

 private:
  void measure(const Estimator& estimator) noexcept;
  void take_soles(const Estimator& estimator, double share) noexcept;
  void push_soles(const Estimator& estimator, double dt) noexcept;
  void feed_forward(const Estimator& estimator) noexcept;
  double omega() const noexcept;
  void find_waist() noexcept;
  Eigen::Vector3d momentum_rate(const Estimator& estimator,
                                const Eigen::Vector3d& turning) noexcept;
  void start_trunk(const Estimator& estimator) noexcept;

  const Model* model_;
  BalanceGains gains_;
  ComMotion motion_;
  Stabilizer stabilizer_;
  TrunkYield trunk_;
  ArmClearance arms_;
  FootCompliance foot_;
  StandingMotion standing_;
  InverseDynamics dynamics_;

  std::array<SoleOnGround, 2> soles_;
  MinJerk first_;  // 1 -> 0: how much of what was found at the start is still held
  Eigen::Vector3d first_turn_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d home_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d lean_wanted_ = Eigen::Vector2d::Zero(), lean_rate_wanted_ = Eigen::Vector2d::Zero();
  bool lean_given_ = false;

  Eigen::Vector3d com_ = Eigen::Vector3d::Zero(), com_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d dcm_ = Eigen::Vector2d::Zero(), spun_velocity_ = Eigen::Vector2d::Zero();
  Eigen::Vector3d turn_ = Eigen::Vector3d::Zero(), turn_rate_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero(),
                  angular_acceleration_ = Eigen::Vector3d::Zero();
  double mass_;
  std::array<double, 2> foot_forces_{};
  bool finite_ = true;
  Eigen::VectorXd q_, qd_, rates_, qdd_, tau_, kp_, kd_, offset_, offset_rate_;
  std::array<int, 2> waist_{-1, -1};  // joint that rolls, joint that pitches the trunk
  std::array<double, 2> waist_sign_{1.0, 1.0};
  std::vector<ExternalWrench> no_wrench_;
  std::vector<bool> leg_;
  std::vector<ExternalWrench> wrench_;
};

}  // namespace twinbus
