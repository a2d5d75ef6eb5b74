// What moves the legs of a robot on its feet and keeps it upright: standing on two feet (balance), walking on them (walk), two or four
// point feet (point_feet).  The controller's modes have one that is active, or none.

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "lcmtypes/msg/messages.h"
#include "robot/description/model.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline control {

// Ground frame (midway between the feet, z up): [m], [m/s].
struct BehaviorReport {
  Eigen::Vector3d com, com_velocity, com_reference;
  Eigen::Vector2d dcm, zmp_reference;
};

class Behavior {
 public:
  virtual ~Behavior() = default;

  // Whether the robot is upright with its feet on the ground; whether a foot carries it at all.
  virtual bool may_start(const Estimator& estimator) const noexcept {
    return estimator.tilt() < kMayTilt && estimator.loaded(0) && estimator.loaded(1);
  }
  virtual bool stands(const Estimator& estimator) const noexcept { return estimator.loaded(0) || estimator.loaded(1); }
  // Begins where the robot is, with its velocity; what was asked is forgotten.
  virtual void start(const Estimator& estimator) noexcept = 0;
  // Why a robot on its feet cannot walk from here, and what to know of a walk that can; null or a string that lives for ever.
  virtual const char* why_no_walk(const Estimator&) const noexcept { return nullptr; }
  virtual const char* caution(const Estimator&) const noexcept { return nullptr; }
  // Another robot may be watched from now on.
  virtual void forget() noexcept {}
  // The same robot through another source: references go on, filters and errors are re-based.
  virtual void rebase() noexcept = 0;
  // The same robot, led by somebody else meanwhile: it goes on from where its feet are.
  virtual void resume() noexcept {}

  // Requests; what a behavior does not do, it leaves.  Velocity: vx, vy, wz [m/s, m/s, rad/s]; offset of the centre of mass [m].
  virtual void walk(bool) noexcept {}
  virtual void want(const Eigen::Vector3d&) noexcept {}
  virtual void request(Motion, double, double) noexcept {}
  virtual void stop_motion(double) noexcept {}
  virtual void lean(const Eigen::Vector3d&) noexcept {}
  // Walks no more, towards resting().  at_once: the shortest stop; tidy: the feet side by side; again: it was asked before.
  virtual void leave_walk(bool, bool, bool) noexcept {}

  // q_given [joint_count]: of the joints that are not of a leg.
  virtual void update(const Estimator& estimator, const Eigen::VectorXd& q_given, double dt) noexcept = 0;
  bool finite() const noexcept { return finite_; }
  // Stands on its feet on purpose, and nothing moves.
  virtual bool resting() const noexcept = 0;
  // Moves the robot, as a stop plan sees it; rests so that a balanced stop has ended.
  virtual bool moves() const noexcept { return !resting(); }
  virtual bool stopped(const Estimator&) const noexcept { return resting(); }
  // Why it walks no farther of itself, or null; a string that lives for ever.
  virtual const char* why_stopped() const noexcept { return nullptr; }

  // Set-points and gains of the legs, torques of all joints, [joint_count].
  const Eigen::VectorXd& q() const noexcept { return q_; }
  const Eigen::VectorXd& qd() const noexcept { return qd_; }
  const Eigen::VectorXd& tau() const noexcept { return tau_; }
  const Eigen::VectorXd& kp() const noexcept { return kp_; }
  const Eigen::VectorXd& kd() const noexcept { return kd_; }
  bool is_leg(int joint) const noexcept { return leg_[static_cast<std::size_t>(joint)]; }
  // Added to the set-point of a joint that is not of a leg [rad, rad/s].
  virtual void offset(int, double&, double&) const noexcept {}
  // The set-points of the legs are where they are measured.
  virtual bool follows_measured() const noexcept { return true; }

  virtual Motion motion() const noexcept { return Motion::kNone; }
  // Of a walk: vx, vy, wz; zero when it does not walk.
  virtual Eigen::Vector3d most_velocity() const noexcept { return Eigen::Vector3d::Zero(); }
  // Normal force asked of each of two soles [N].
  virtual std::array<double, 2> foot_forces() const noexcept { return {}; }
  virtual BehaviorReport report(const Estimator& estimator) const noexcept = 0;

 protected:
  static constexpr double kMayTilt = 0.35;  // [rad]

  // Gains as in robot.yaml, no leg yet.
  explicit Behavior(const Model& model)
      : q_(Eigen::VectorXd::Zero(model.joint_count())), qd_(q_), qdd_(q_), tau_(q_), kp_(q_), kd_(q_),
        leg_(model.joints.size(), false) {
    for (int j = 0; j < model.joint_count(); ++j) {
      kp_[j] = model.joints[static_cast<std::size_t>(j)].kp;
      kd_[j] = model.joints[static_cast<std::size_t>(j)].kd;
    }
  }
  Behavior(const Behavior&) = default;
  Behavior& operator=(const Behavior&) = default;

  void look_for_nan() noexcept { finite_ = q_.allFinite() && qd_.allFinite() && tau_.allFinite(); }

  Eigen::VectorXd q_, qd_, qdd_, tau_, kp_, kd_;
  std::vector<bool> leg_;
  std::vector<ExternalWrench> wrench_;  // of the feet
  bool finite_ = true;
};

}  // namespace twinbus::control
