#include "robot/dynamics/gravity_load.h"

#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline robot {

GravityLoad::GravityLoad(const Model& model)
    : model_(&model),
      torque_(model),
      kinematics_(model),
      dynamics_(model),
      still_(model),
      zero_(Eigen::VectorXd::Zero(model.joint_count())),
      tau_(zero_) {}

GravityLoad::Worst GravityLoad::of(const Configuration& posture, const std::vector<int>& joints) noexcept {
  still_.base = posture.base;
  still_.q = posture.q;
  kinematics_.update(still_);
  dynamics_.solve(kinematics_, still_, zero_, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {}, tau_);
  Worst worst;
  for (const int joint : joints) {
    if (!(model_->joints[at(joint)].effort > 0.0)) continue;  // the file has none
    const double share = torque_.share(joint, posture.q, tau_);
    if (worst.joint < 0 || share > worst.share) worst = {joint, share, std::abs(tau_[joint])};
  }
  return worst;
}

}  // namespace twinbus::robot
