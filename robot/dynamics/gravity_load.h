// What joints carry of the robot's own weight while it rests.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "robot/description/model.h"
#include "robot/dynamics/inverse_dynamics.h"
#include "robot/dynamics/pair_torque.h"
#include "robot/kinematics/kinematics.h"

namespace twinbus::inline robot {

class GravityLoad {
 public:
  struct Worst {
    int joint = -1;       // -1: none has an effort limit
    double share = 0.0;   // of its effort limit that it needs
    double effort = 0.0;  // that it needs [N m or N]
  };

  explicit GravityLoad(const Model& model);
  // Of these joints the one that needs most of its limit, in a posture at rest on a fixed base.
  Worst of(const Configuration& posture, const std::vector<int>& joints) noexcept;
  // What a joint carried in that posture [N m or N].
  double effort(int joint) const noexcept { return tau_[joint]; }

 private:
  const Model* model_;
  PairTorque torque_;
  Kinematics kinematics_;
  InverseDynamics dynamics_;
  Configuration still_;
  Eigen::VectorXd zero_, tau_;
};

}  // namespace twinbus::robot
