#include "planner/timing/motion_effort.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline planner {

MotionEffort::MotionEffort(const Model& model, const Configuration& posture,
                           const std::vector<int>& joints)
    : model_(&model),
      joints_(joints),
      there_(posture),
      kinematics_(model),
      dynamics_(model),
      load_(model),
      qdd_(Eigen::VectorXd::Zero(model.joint_count())),
      moving_(qdd_),
      still_(qdd_) {
  there_.qd.setZero();
  there_.base_velocity.setZero();
  there_.base_angular_velocity.setZero();
}

void MotionEffort::efforts(const JointPoint& q, const JointPoint& qd, const JointPoint& qdd,
                           Eigen::VectorXd& tau) {
  for (int k = 0; k < q.size(); ++k) {
    const int joint = joints_[at(k)];
    there_.q[joint] = q[k];
    there_.qd[joint] = qd[k];
    qdd_[joint] = qdd[k];
  }
  kinematics_.update(there_);
  dynamics_.solve(kinematics_, there_, qdd_, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), {},
                  tau);
}

bool MotionEffort::holds(const JointPoint& q, double share) {
  for (int k = 0; k < q.size(); ++k) there_.q[joints_[at(k)]] = q[k];
  const GravityLoad::Worst worst = load_.of(there_, joints_);
  if (worst.joint < 0 || worst.share < share) return true;
  weak_joint_ = worst.joint;
  return false;
}

double MotionEffort::slower(const TimedPath& path) {
  double most = 1.0;  // f^2
  largest_ = 0.0;
  JointPoint q, qd, qdd;
  const JointPoint rest = JointPoint::Zero(static_cast<int>(joints_.size()));
  for (const Knot& knot : path) {
    sample(path, knot.time, q, qd, qdd);
    efforts(q, qd, qdd, moving_);
    bool beyond = false;
    for (const int joint : joints_) {
      const double limit = model_->joints[at(joint)].effort;
      if (!(limit > 0.0)) continue;  // the file has none
      largest_ = std::max(largest_, std::abs(moving_[joint]) / limit);
      beyond = beyond || !(std::abs(moving_[joint]) <= kAll * limit);
    }
    if (!beyond) continue;
    efforts(q, rest, rest, still_);
    for (const int joint : joints_) {
      const double limit = kAll * model_->joints[at(joint)].effort;
      if (!(limit > 0.0)) continue;
      const double hold = still_[joint], move = moving_[joint] - hold;
      if (!(std::abs(hold) < limit)) {
        weak_joint_ = joint;
        return 0.0;
      }
      most = std::max(most, std::abs(move) / (limit - std::copysign(1.0, move) * hold));
    }
  }
  return std::sqrt(most);
}

}  // namespace twinbus::planner
