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
#include "control/legs/behavior.h"
#include "control/legs/foot_compliance.h"
#include "control/balance/stabilizer.h"
#include "control/balance/standing_motion.h"
#include "control/balance/angular_momentum_lean.h"
#include "robot/estimation/estimator.h"
#include "robot/description/model.h"

namespace twinbus::inline control {

class Balance final : public Behavior {
 public:
  // Why this robot cannot balance, or null.
  static const char* why_not(const Model& model) noexcept;
  // Throws std::runtime_error when why_not is not null.
  Balance(const Model& model, const BalanceGains& gains);

  // One call per tick in whatever mode, before update: velocities are low-passed all the time, for of one sample they
  // are noise, which a start would keep and whoever fades to these set-points would take for a motion.
  void watch(const Estimator& estimator, double dt) noexcept;
  void forget() noexcept override;
  void start(const Estimator& estimator) noexcept override;
  void rebase() noexcept override;

  void request(Motion motion, double amplitude, double frequency) noexcept override {
    motion_.request(motion, amplitude, frequency);
  }
  void stop_motion(double duration) noexcept override { motion_.stop(duration); }
  void lean(const Eigen::Vector3d& offset) noexcept override { motion_.lean(offset); }

  // For the next update, besides what else is asked: a way of the centre of mass from home (as ComMotion::follow), and a lean
  // of the base, roll and pitch [rad, rad/s].
  void follow(const Eigen::Vector3d& com, const Eigen::Vector3d& velocity, const Eigen::Vector3d& acceleration,
              const Eigen::Vector2d& lean, const Eigen::Vector2d& lean_rate) noexcept {
    motion_.follow(com, velocity, acceleration);
    lean_wanted_ = lean;
    lean_rate_wanted_ = lean_rate;
    lean_given_ = true;
  }

  void update(const Estimator& estimator, const Eigen::VectorXd& q_given, double dt) noexcept override;

  void offset(int joint, double& q, double& qd) const noexcept override {
    q += offset_[joint];
    qd += offset_rate_[joint];
  }
  bool resting() const noexcept override;
  // With the ZMP well inside the support polygon.
  bool stopped(const Estimator& estimator) const noexcept override;

  std::array<double, 2> foot_forces() const noexcept override { return foot_forces_; }
  Motion motion() const noexcept override { return motion_.motion(); }
  BehaviorReport report(const Estimator& estimator) const noexcept override;

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
  double stands_ahead_ = 0.0;  // of the middle of the soles, at home [m]
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
  Eigen::VectorXd rates_, offset_, offset_rate_;
  std::array<int, 2> waist_{-1, -1};  // joint that rolls, joint that pitches the trunk
  std::array<double, 2> waist_sign_{1.0, 1.0};
  std::vector<ExternalWrench> no_wrench_;
};

}  // namespace twinbus::control
