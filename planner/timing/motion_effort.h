// The efforts that a timed arm motion asks of its joints: inverse dynamics at its knots while
// everything else of the robot stands still, and what the joints' own damping D and friction F take.
//
//     tau = g + a + D qd + F sign(qd),     f times slower:  g + F sign(qd) + D qd / f + a / f^2
//
// g: what holds the arm still, a: what else moves it (accelerations, centrifugal and Coriolis forces).

#pragma once

#include <vector>

#include "planner/timing/path_timing.h"
#include "robot/dynamics/gravity_load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/pair_torque.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

class MotionEffort {
 public:
  // joints: model indices of the columns; the others, and the base, stay as in posture. model must
  // outlive this.
  MotionEffort(const Model& model, const Configuration& posture, const std::vector<int>& joints);

  // How many times slower the motion must be, at least 1, so that no joint of it is asked for more
  // than its effort limit (and half a percent less, for what is between knots). 0: somewhere on the
  // way a joint cannot even hold the arm, or creep against its friction; see weak_joint.
  double slower(const TimedPath& path);

  // Can every joint hold the arm there?  If not, weak_joint is the one that needs most of its limit.  share: of the limits that may
  // be used; a joint that has less left moves slowly.
  static constexpr double kAll = 0.995;  // at knots: between them the effort strays a little
  bool holds(const JointPoint& q, double share = kAll);
  // And creep from there along step, forwards and backwards, against its friction?
  bool creeps(const JointPoint& q, const JointPoint& step, double share = kAll);

  // The speed at which damping and friction alone leave a joint a part of its effort limit, or its velocity limit where
  // that is less [rad/s or m/s]; 0 if friction takes all.
  static double lasting_speed(const Joint& joint);

  bool rubs() const { return rubs_; }  // is it friction that is too much for weak_joint?
  int weak_joint() const { return weak_joint_; }  // model index
  double largest() const { return largest_; }     // |effort| / limit of the path last given

 private:
  void efforts(const JointPoint& q, const JointPoint& qd, const JointPoint& qdd,
               Eigen::VectorXd& tau);

  const Model* model_;
  PairTorque torque_;
  std::vector<int> joints_;
  Configuration there_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  GravityLoad load_;
  Eigen::VectorXd qdd_, moving_, still_;
  int weak_joint_ = -1;
  bool rubs_ = false;
  double largest_ = 0.0;
};

}  // namespace twinbus::planner
