// Standing and stepping on point feet, four or two: one tick from the estimate to set-points and torques of all joints.
//
// The trunk is pushed to where it is to be by a force and a moment about its centre of mass,
//     F = m (g + kp (p_ref - p) + kd (v_ref - v)),     M = I (kp e + kd (w_ref - w)),
// which the feet that stand share (point_force_share); torques are those of recursive Newton-Euler with these forces.  Servos
// hold standing feet where they stand with a share of their gains, and lead a foot in the air to its foothold (step_gait).
// All in the estimator's world, z up.  Standing, it sways and squats as others do (com_motion); pushed too hard, standing or in a
// crawl, it trots until it stands again.

#pragma once

#include <Eigen/Geometry>
#include <array>

#include "control/balance/com_motion.h"
#include "control/legs/behavior.h"
#include "control/point_feet/crawl_pattern.h"
#include "control/point_feet/point_force_share.h"
#include "control/point_feet/point_feet_body.h"
#include "control/point_feet/step_gait.h"
#include "robot/description/model.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline control {

class PointFeet final : public Behavior {
 public:
  // Throws std::runtime_error with one sentence (why_no_point_feet).  The gait is that of robot.yaml.
  explicit PointFeet(const Model& model);

  // At least three feet stand, one of two; any foot stands.
  bool may_start(const Estimator& estimator) const noexcept override;
  bool stands(const Estimator& estimator) const noexcept override;
  // On all feet.
  void start(const Estimator& estimator) noexcept override;
  void rebase() noexcept override { fresh_ = true; }
  void resume() noexcept override { resumes_ = true; }

  // In a walk it steps as long as a velocity is asked; else it stands, and steps only so as not to fall.
  void walk(bool on) noexcept override;
  void leave_walk(bool at_once, bool tidy, bool again) noexcept override;
  void want(const Eigen::Vector3d& velocity) noexcept override;
  void request(Motion motion, double amplitude, double frequency) noexcept override {
    motion_.request(motion, amplitude, frequency);
  }
  void stop_motion(double duration) noexcept override { motion_.stop(duration); }
  void lean(const Eigen::Vector3d& offset) noexcept override { motion_.lean(offset); }

  void update(const Estimator& estimator, const Eigen::VectorXd& q_given, double dt) noexcept override;

  // On all four feet; of two, it steps in place.
  bool resting() const noexcept override;
  bool moves() const noexcept override { return body_.two() || !resting(); }
  bool stepping() const noexcept { return gait_.steps(); }

  // Joints and torques of the nominal stance, [joint_count].
  const Eigen::VectorXd& stance() const noexcept { return stance_; }
  const Eigen::VectorXd& stance_torque() const noexcept { return stance_torque_; }

  const PointFeetBody& body() const noexcept { return body_; }
  const StepGait& gait() const noexcept { return gait_; }
  Motion motion() const noexcept override { return motion_.motion(); }
  Eigen::Vector3d most_velocity() const noexcept override { return gait_.most_velocity(); }
  BehaviorReport report(const Estimator& estimator) const noexcept override;
  const PointForces& forces() const noexcept { return forces_; }

 private:
  struct Leg {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();   // of the ground that it presses, measured, world [m]
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero();  // where it stands, or left the ground
    Eigen::Vector3d target = Eigen::Vector3d::Zero();  // where it is to come down
    Eigen::Vector3d way = Eigen::Vector3d::Zero();     // from where it is to its set-point, and
    Eigen::Vector3d fading = Eigen::Vector3d::Zero();  // how much of it is left of the phase before
    bool swings = false, led = false;                  // now; a tick ago
  };

  void measure(const Estimator& estimator, double dt) noexcept;
  void decide(double dt) noexcept;
  void begin_steps(double dt) noexcept;
  void begin_gait(bool crawls, bool backwards) noexcept;
  bool may_rest() const noexcept;
  FourPoints anchors() const noexcept;
  void move_reference(double dt) noexcept;
  void stand_still() noexcept;
  Eigen::Vector3d home(double& yaw) const noexcept;
  void place_feet(double dt) noexcept;
  void push(const Estimator& estimator) noexcept;
  void lead_legs(const Estimator& estimator, double dt) noexcept;
  void lead(const Estimator& estimator, std::size_t leg, const Eigen::Vector3d& way, const Eigen::Vector3d& rate) noexcept;

  const Model* model_;
  PointFeetBody body_;
  StepGait gait_;
  CrawlPattern crawl_;
  PointForceShare share_;
  InverseDynamics dynamics_;
  ComMotion motion_;  // of the centre of mass, from home, heading of the feet
  std::array<Leg, 4> legs_;
  Eigen::Vector3d wanted_ = Eigen::Vector3d::Zero(), velocity_wanted_ = Eigen::Vector3d::Zero();  // vx, vy, wz
  Eigen::Vector3d reference_ = Eigen::Vector3d::Zero(), reference_velocity_ = Eigen::Vector3d::Zero(),
                  reference_acceleration_ = Eigen::Vector3d::Zero();  // of the centre of mass, world
  MinJerk height_, first_;  // while it steps; 1 -> 0: share of the first tilt still held
  Eigen::Vector3d first_turn_ = Eigen::Vector3d::Zero();
  double yaw_reference_ = 0.0, yaw_ = 0.0, ground_ = 0.0;
  Eigen::Vector3d com_ = Eigen::Vector3d::Zero(), velocity_ = Eigen::Vector3d::Zero(), omega_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d base_ = Eigen::Matrix3d::Identity(), base_reference_ = Eigen::Matrix3d::Identity();
  PointForces forces_;
  int lifts_ = -1;  // of two feet the one that presses before it is lifted first
  Eigen::Vector2d trim_ = Eigen::Vector2d::Zero();  // added to the velocity that footholds of two feet are for, heading [m/s]
  Eigen::Vector2d pressed_ = Eigen::Vector2d::Zero();  // between the feet, by what each may carry
  bool stays_ = false;  // asked for a velocity of the other gait: this one ends first
  bool walks_ = false, halts_ = false, fresh_ = true, resumes_ = false;
  double quiet_ = 0.0;  // the asked velocity is zero for so long [s]
  Eigen::VectorXd leg_kp_, leg_kd_, stance_, stance_torque_;
};

}  // namespace twinbus::control
