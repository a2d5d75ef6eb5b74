// Which mode the robot is in, how it gets from one to another and through a stop, and what the mode
// asks of every joint.
//
// A mode that cannot be entered falls back to hold and says why.  Whatever changes here, the set-points
// may step: control_loop blends them over.

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "control/balance/balance.h"
#include "control/balance/pose_check.h"
#include "control/balance/squat_check.h"
#include "control/joint/posture.h"
#include "control/joint/set_point.h"
#include "control/legs/behavior.h"
#include "control/legs/static_torque.h"
#include "control/loop/arm_follow.h"
#include "control/loop/fall_protection.h"
#include "control/motion/motion_follow.h"
#include "control/loop/pose_way.h"
#include "control/loop/stop_planner.h"
#include "control/point_feet/point_feet.h"
#include "control/point_feet/point_feet_body.h"
#include "control/walk/walk.h"
#include "lcmtypes/msg/messages.h"
#include "lcmtypes/msg/robot_io.h"
#include "robot/description/model.h"
#include "robot/estimation/estimator.h"

namespace twinbus::inline control {

constexpr double kStopTime = 0.4;  // in which a balanced stop ends a motion, and a sway or squat makes room for one [s]

// The tick that is being answered.
struct Moment {
  const RobotState& state;
  const Estimator& estimator;  // has taken the state
  const SetPoint* last;        // put out a tick ago; null: nothing yet that the robot obeys
};

class Modes {
 public:
  // Throws std::runtime_error when the robot's soles and legs contradict each other.
  Modes(const Model& model, const BalanceGains& gains, const WalkGains& walk);

  // Forgets everything and enters a mode.
  void start(Mode first, const Moment& now) noexcept;
  // The same robot speaks through another source.
  void rebase() noexcept;
  // The robot was led by somebody else: its legs go on from where they are.
  void resume() noexcept {
    if (active_ != nullptr) active_->resume();
  }
  // A robot that cannot be caught any more braces itself; one that lies on the ground is let go.
  void watch_for_a_fall(const Moment& now) noexcept;
  // asked: the highest stop heard since the last tick.  True while the gate obeys nobody, and at the
  // tick it obeys again: then what was put out before counts no more, the robot is followed.
  // for_switch: another source is to take over once the robot stands as robots are left, feet side by side.
  // plan_runs: the robot follows a stop plan to its end, and obeys nobody before.
  bool follow_stop(StopKind asked, bool for_switch, bool plan_runs, const Moment& now) noexcept;
  void obey(const ModeRequest& request, const Moment& now) noexcept;
  // Of the centre of mass, while balancing [m].
  void lean(const Eigen::Vector3d& offset) noexcept {
    if (active_ != nullptr) active_->lean(mode_ == Mode::kWalk ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : offset);
  }
  // Velocity to walk at, while in mode walk: vx, vy, wz [m/s, m/s, rad/s].
  void walk(const Eigen::Vector3d& velocity) noexcept {
    if (walks() && !after_rest_ && !stopping_) active_->want(velocity);
  }
  // Footsteps instead of a velocity; refused with a sentence.
  void walk_steps(const StepList& list) noexcept;
  // A path while there is nothing to move with is not taken.
  void add_path(const ArmPathPiece& piece) noexcept;
  void cancel_path() noexcept { arm_.cancel(); }
  // A motion begins when its first frames are there, once the robot stands; refused with a sentence.
  void add_motion(const MotionPiece& piece) noexcept { motion_.add(piece); }
  bool plays() const noexcept { return motion_.active(); }

  // What the mode asks of every joint.  mask: bit per joint that the guard held a tick ago.
  void want(const Moment& now, std::int64_t mask, double dt, SetPoint& set_point) noexcept;
  // Whether the set-points may have stepped since the last call.
  bool take_change() noexcept { return std::exchange(changed_, false); }
  // What people should be told once, or null; a string that lives for ever.
  // of_path, when given: it says why an arm path is not followed.
  const char* take_sentence(bool* of_path = nullptr) noexcept {
    if (of_path != nullptr) *of_path = sentence_ != nullptr && sentence_ == path_refusal_;
    return std::exchange(sentence_, nullptr);
  }
  // Joints that a guard held on their way.
  Posture::Held take_held() noexcept { return posture_.take_held(); }

  Mode mode() const noexcept { return mode_; }
  const ArmFollow& arm() const noexcept { return arm_; }
  // What moves the legs, or null; the next two: where it is of that kind.
  const Behavior* behavior() const noexcept { return active_; }
  const Walk* walk() const noexcept { return active_ == walk_.get() ? walk_.get() : nullptr; }
  const PointFeet* point_feet() const noexcept { return active_ == point_feet_.get() ? point_feet_.get() : nullptr; }
  // What a walk that goes on may be asked for: vx, vy, wz; zero when there is none.
  Eigen::Vector3d most_velocity() const noexcept {
    return walks() ? active_->most_velocity() : Eigen::Vector3d(Eigen::Vector3d::Zero());
  }
  // Any walk of this robot, walking or not; null when it cannot.
  const Walk* any_walk() const noexcept { return walk_.get(); }
  // What moves the robot, for the stop plan behind a command.
  PlannedMotion motion(const JointCommand& command) const noexcept;
  // The robot has been led on meanwhile as this walk was foreseen, by these set-points [joint_count]: walking goes on there.
  void resume_walk(const Walk& foreseen, const Eigen::VectorXd& q, const Eigen::VectorXd& qd) noexcept;
  // Normal force asked of each foot, left and right [N].
  std::array<double, 2> foot_forces() const noexcept {
    return active_ != nullptr ? active_->foot_forces() : std::array<double, 2>{};
  }
  bool stopping() const noexcept { return stopping_; }  // commands carry the flag
  // Bit per joint whose set-point is where it is measured.
  std::int64_t measured() const noexcept { return active_ != nullptr && active_->follows_measured() ? legs_ : 0; }

 private:
  bool may_balance(const Moment& now) const noexcept;
  bool stands(const Moment& now) const noexcept;
  void enter(Mode next, const Moment& now) noexcept;
  void enter_balance(const Moment& now) noexcept;
  void enter_hold(const Moment& now, bool at_measured) noexcept;
  const char* why_no_pose(const ModeRequest& request, const Moment& now) noexcept;
  void look_ahead(const Moment& now) noexcept;
  void forget_pose() noexcept;
  void enter_pose(const ModeRequest& request, const Moment& now) noexcept;
  void enter_walk(const Moment& now) noexcept;
  // Walks no more: once the robot stands, `next` is obeyed.  at_once: the shortest stop; tidy: the feet side by side.
  void leave_walk(const ModeRequest& next, bool at_once, bool tidy) noexcept;
  // A behavior takes the legs; from joints that were let go, the posture is where they are.
  void begin(Behavior* behavior, const Moment& now) noexcept;
  bool walks() const noexcept { return active_ != nullptr && mode_ == Mode::kWalk; }
  // Nothing moves the legs.
  void let_legs_go() noexcept {
    active_ = nullptr;
    after_rest_.reset();
  }
  void set_legs(SetPoint& set_point) const noexcept;
  void request_motion(const ModeRequest& request, const Moment& now) noexcept;
  void end_brace(const Moment& now) noexcept;
  const char* why_no_motion(const Moment& now) noexcept;
  void play(const Moment& now, std::int64_t mask, double dt) noexcept;
  void begin_motion(const Moment& now) noexcept;
  void look_along(const Moment& now) noexcept;
  void go_back() noexcept;
  void end_motion(const Moment& now) noexcept;
  void stop_playing() noexcept;
  void follow_body() noexcept;
  bool put_off(const ModeRequest& request) noexcept;
  PerJoint<double> joints_of(const Posture& posture) const noexcept;
  void brake(Posture& posture, double duration) const noexcept;
  void move_legs(const Moment& now, double dt) noexcept;
  void damp(const RobotState& state, SetPoint& set_point) const noexcept;

  const Model& model_;
  std::unique_ptr<Balance> balance_;      // null when the robot cannot, as those below
  std::unique_ptr<Walk> walk_;
  std::unique_ptr<PointFeet> point_feet_;  // of a robot on point feet
  Behavior* standing_ = nullptr;          // balance_ or point_feet_
  Behavior* walker_ = nullptr;            // walk_ or point_feet_
  Behavior* active_ = nullptr;            // moves the legs; null: nothing does
  std::optional<ModeRequest> after_rest_; // it walks no more: obeyed once it rests
  std::unique_ptr<SquatCheck> squat_;     // as balance_
  std::unique_ptr<PoseCheck> pose_;       // as balance_
  PoseWay way_;
  bool looks_ahead_ = false;  // along the way to asked_pose_, which begins when it is free
  ModeRequest asked_pose_;
  std::string no_walk_;                // why not
  Posture posture_;
  ArmFollow arm_;
  MotionFollow motion_;
  PerJoint<double> stood_{};   // before the motion, bus order
  double waited_ = 0.0;        // for the guard, on the way to its first frame [s]
  ModeRequest after_motion_;   // obeyed when it has ended
  Posture braked_;             // how the joints would come to rest, while it plays
  Brace brace_;
  StaticTorque static_torque_;
  Mode mode_ = Mode::kNone, mode_before_stop_ = Mode::kNone;
  bool changed_ = false, stopping_ = false, held_by_gate_ = false, bracing_ = false;
  std::int64_t legs_ = 0;          // bit per bus joint that balance and walking move
  std::vector<int> followers_;     // joints that mimic another
  PerJoint<double> kp_{}, kd_{};   // of joints that nothing else is asked of
  Eigen::VectorXd q_given_, tau_;  // [joint_count]
  const char* sentence_ = nullptr;
  const char* path_refusal_ = nullptr;  // of a path, last
};

}  // namespace twinbus::control
