#include "robot/dynamics/pair_torque.h"

namespace twinbus::inline robot {

PairTorque::PairTorque(const Model& model) : model_(&model), pairs_(parallel_joints_of(model)) {
  for (const ParallelJoints& pair : pairs_)
    bus_.push_back({at(model.bus_index[at(pair.joints[0])]), at(model.bus_index[at(pair.joints[1])])});
}

double PairTorque::share(int joint, const Eigen::VectorXd& q, const Eigen::VectorXd& tau) const noexcept {
  const ParallelJoints* pair = with(joint);
  RodPosture posture;
  if (pair != nullptr && pair->drive.at(pair->of(q), posture)) {
    const Eigen::Vector2d motors = posture.jacobian.transpose().inverse() * pair->of(tau);
    return (motors.cwiseAbs().array() / pair->drive.torque_limits().array()).maxCoeff();
  }
  const double limit = model_->joints[at(joint)].effort;
  return limit > 0.0 ? std::abs(tau[joint]) / limit : 0.0;
}

double PairTorque::effort_in(int joint, const Eigen::VectorXd& q) const noexcept {
  const ParallelJoints* pair = with(joint);
  RodPosture posture;
  if (pair == nullptr || !pair->drive.at(pair->of(q), posture)) return model_->joints[at(joint)].effort;
  return torque_box(pair->drive, posture)[joint == pair->joints[0] ? 0 : 1];
}

}  // namespace twinbus::robot
