// Makes the stop plan behind every command: where the robot goes if this controller falls silent (lcmtypes/msg/stop_plan.h).
//
// A copy of the motion is run ahead on its own model: it goes on for 50 ms, so that a short silence is not seen, then makes
// its shortest stop.  A plan is begun every 20 ms and made a few knots a tick, so that no tick costs much; each piece goes
// out when it is ready.  Of a robot that stands still a plan says no more than that, is one piece long and begun every 40 ms:
// with it the source waits for a late controller instead of stopping for good.  The walks that the last plans began from are kept: with them a controller that was silent finds out
// where its robot has been led meanwhile.

#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "control/loop/arm_forecast.h"
#include "control/walk/walk.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/pair_torque.h"
#include "robot/stop_plan/stop_plan.h"

namespace twinbus::inline control {

// What moves the robot in a tick that has been answered.
struct PlannedMotion {
  const Walk* walk = nullptr;  // null: it does not walk
  const Posture& posture;
  const ArmFollow& arm;
  const Eigen::VectorXd& q_given;  // [joint_count]: of the joints that walking does not move
  const JointCommand& command;
  std::int64_t joints = 0;  // bit per joint whose way is known beforehand
  std::int64_t follow = 0;  // those of them that balance and go on as they are measured: they are braked
  // To where, and with which torques, those that follow are led instead, [joint_count]: feet in the air come down.  Null: nowhere.
  const Eigen::VectorXd* down = nullptr;
  const Eigen::VectorXd* down_torque = nullptr;
  bool rests = false;       // nothing moves: a short plan, to stay there
  bool steered = false;     // somebody steers the robot; else no plan
};

class StopPlanner {
 public:
  // walk: any, null when the robot cannot.  first_number: of the plans.  Allocates; the model must outlive this.
  StopPlanner(const Model& model, const Walk* walk, std::int32_t first_number);

  // Once per answered tick, after its command was made.
  void advance(const PlannedMotion& motion) noexcept;
  // The plan under way is not sent any further.
  void drop() noexcept {
    making_ = false;
    age_ = every_resting_;
  }
  // Fills a piece that is ready to be sent; false when there is none.
  bool take(StopPlanPiece& out) noexcept;

  // The walk of a plan of ours, run ahead to a tick as the plan does; null when it is not known any more.
  const Walk* walk_at(std::int32_t number, std::int64_t tick) noexcept;
  // That plan.
  const StopPlan* plan(std::int32_t number) const noexcept;

 private:
  static constexpr std::size_t kKept = 4;
  struct Begun {
    std::optional<Walk> walk;  // empty when the robot cannot
    Eigen::VectorXd q_given;
    StopPlan plan;
    bool walks = false;
  };
  struct Knot {
    Eigen::VectorXd q;
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), acceleration = velocity;  // of the centre of mass
    std::array<Eigen::Vector3d, 2> force, torque;                                // of the soles
  };
  void begin(const PlannedMotion& motion) noexcept;
  bool make_knot() noexcept;
  bool write_joints(int k) noexcept;
  bool write_balance(int k) noexcept;
  bool write_torque(int k) noexcept;
  void keep(int k) noexcept;
  Knot& knot(int k) noexcept { return knot_[static_cast<std::size_t>(k) % knot_.size()]; }
  std::size_t find(std::int32_t number) const noexcept;  // kKept: none

  const Model& model_;
  PairTorque torque_;
  std::int64_t every_, every_resting_, spacing_, step_, going_on_;  // [ticks]
  std::array<Begun, kKept> begun_;
  std::size_t now_ = 0;  // the plan that is being made
  std::int32_t number_;
  bool making_ = false, halted_ = false;
  int knots_ = 0, done_ = 0, sent_ = 0;  // made, with torques, pieces sent
  std::int64_t age_ = 0;                 // ticks since the last one was begun
  std::optional<Walk> ahead_, resumed_;
  std::int32_t resumed_number_ = -1;
  std::int64_t resumed_tick_ = 0;
  ArmForecast arm_;
  JointCommand command_;       // that the plan continues
  PerJoint<double> started_{};  // the posture then
  PerJoint<double> rate_{};     // of the commands, smoothed [rad/s]
  std::int64_t follow_ = 0;
  bool down_ = false;
  Eigen::VectorXd down_q_, down_torque_;  // [joint_count]
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  // of the plan's frame
  double heading_ = 0.0, cosine_ = 1.0, sine_ = 0.0;
  std::array<Knot, 3> knot_;
  Eigen::VectorXd q_given_, qdd_, tau_;
  Configuration configuration_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  std::vector<ExternalWrench> wrench_;
};

}  // namespace twinbus::control
