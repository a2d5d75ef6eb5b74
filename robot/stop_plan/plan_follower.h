// The law with which a source follows a stop plan: keeps a robot on its feet that nobody steers.
//
//     e = DCM measured - DCM planned, both relative to the soles that carry; without force sensors h (tilt + rate / omega)
//     p = p_plan + (1 + k/omega) e + k_i integral e            cut to what the soles can carry (sole_share.h)
//
// What p asks of each sole beyond the plan, force and moment, becomes a pose of the sole (it gives way as a spring), and what
// the sensors say is still missed moves the ankles and the difference of the legs' lengths (admittance).  Each leg follows by
// one damped 6 x 6 solve of its coordinates (robot/kinematics/leg_motion.h) and carries the force difference by -J^T.  The
// gains are those of the controller's own stabilizer.

#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "robot/description/model.h"
#include "robot/estimation/estimator.h"
#include "robot/kinematics/leg_motion.h"
#include "robot/stop_plan/sole_share.h"
#include "robot/stop_plan/stop_plan.h"

namespace twinbus::inline robot {

class PlanFollower {
 public:
  // model must outlive this.
  explicit PlanFollower(const Model& model);

  // Begins to follow; robot: has taken the state of the present tick.
  void start(const StopPlan& plan, std::int64_t tick, const Estimator& robot) noexcept;
  // Adds what balance asks beyond the plan to the legs' set-points of this tick.
  void balance(const StopPlan& plan, std::int64_t tick, const Estimator& robot, PlanJoints& set_points) noexcept;

  double dcm_error() const noexcept { return error_; }  // [m]

 private:
  struct Foot {
    std::array<int, 7> bus_joint{};
    Eigen::Vector2d turning = Eigen::Vector2d::Ones();  // stiffness, roll and pitch [N m/rad]
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();   // of the sole, in its frame [m]
    double stiffness = 1.0;                             // [N/m]
    // Sole axes.
    Eigen::Vector2d bend_slow = Eigen::Vector2d::Zero(), bend = bend_slow;  // feed-forward [rad]
    Eigen::Vector2d admitted = Eigen::Vector2d::Zero();                     // [rad]
    double sink_slow = 0.0, sink = 0.0;                                     // [m]
    // Frame of the plan.
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();        // that the ground is taken to have [rad]
    Eigen::Vector3d force = Eigen::Vector3d::Zero();        // beyond the plan [N]
    Eigen::Vector2d moment = Eigen::Vector2d::Zero();       // in sole axes [N m]
    std::array<double, 7> moved{};                          // of the joints [rad]
  };
  struct Load {
    Eigen::Vector3d force;   // plan's frame [N]
    Eigen::Vector2d moment;  // sole axes [N m]
  };
  Eigen::Vector2d error(const StopPlan& plan, const PlanBalance& p, const Estimator& robot, Eigen::Vector2d& com) noexcept;
  void admit(std::size_t f, const PlanBalance& p, const Load& wanted, double share, const SolePlace& sole,
             const Estimator& robot, double ramp) noexcept;
  void move_leg(std::size_t f, const SolePlace& sole, const Estimator& robot, PlanJoints& set_points) noexcept;

  const Model* model_;
  double weight_ = 0.0;      // of the robot [N]
  std::array<Foot, 2> feet_;
  std::optional<std::array<LegMotion, 2>> legs_;
  double cosine_ = 1.0, sine_ = 0.0;  // heading of the plan's frame in the estimator's world
  double since_ = 0.0;                // [s] of following
  double lift_ = 0.0;                 // of the left foot over the right one [m]
  double error_ = 0.0;
  Eigen::Vector2d integral_ = Eigen::Vector2d::Zero();
};

}  // namespace twinbus::robot
