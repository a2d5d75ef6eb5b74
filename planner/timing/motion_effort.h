// The efforts that a timed arm motion asks of its joints: inverse dynamics at its knots while
// everything else of the robot stands still.

#pragma once

#include <vector>

#include "planner/timing/path_timing.h"
#include "robot/dynamics/gravity_load.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/kinematics/kinematics.h"
#include "robot/description/model.h"

namespace twinbus::inline planner {

class MotionEffort {
 public:
  // joints: model indices of the columns; the others, and the base, stay as in posture. model must
  // outlive this.
  MotionEffort(const Model& model, const Configuration& posture, const std::vector<int>& joints);

  // How many times slower the motion must be, at least 1, so that no joint of it is asked for more
  // than its effort limit (and half a percent less, for what is between knots). What moves slower
  // by f needs g + (tau - g) / f^2, g being what holds it still. 0: somewhere on the way a joint
  // cannot even do that; see weak_joint.
  double slower(const TimedPath& path);

  // Can every joint hold the arm there?  If not, weak_joint is the one that needs most of its limit.  share: of the limits that may
  // be used; a joint that has less left moves slowly.
  static constexpr double kAll = 0.995;  // at knots: between them the effort strays a little
  bool holds(const JointPoint& q, double share = kAll);

  int weak_joint() const { return weak_joint_; }  // model index
  double largest() const { return largest_; }     // |effort| / limit of the path last given

 private:
  void efforts(const JointPoint& q, const JointPoint& qd, const JointPoint& qdd,
               Eigen::VectorXd& tau);

  const Model* model_;
  std::vector<int> joints_;
  Configuration there_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  GravityLoad load_;
  Eigen::VectorXd qdd_, moving_, still_;
  int weak_joint_ = -1;
  double largest_ = 0.0;
};

}  // namespace twinbus::planner
