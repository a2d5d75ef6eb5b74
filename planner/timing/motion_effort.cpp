#include "planner/timing/motion_effort.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"

namespace twinbus::inline planner {

namespace {

constexpr double kCreep = 0.001;    // a joint that goes slower may rub with any part of its friction [rad/s or m/s]
constexpr double kSlope = 1e-6;    // of a step: a joint that stands
constexpr double kLasting = 0.8;   // of what friction leaves of the effort limit, for damping at the joint's full speed

double friction_at(const Joint& joint, double qd) { return joint.friction * std::clamp(qd / kCreep, -1.0, 1.0); }

// The largest s with |still + s thick + s^2 hard| <= limit from 0 to s; |still| < limit.
double largest_share(double still, double thick, double hard, double limit) {
  double least = 1e9;
  for (const double side : {-limit, limit}) {
    // s from 2 c / (b + sqrt(b^2 + 4 a c)), which is exact where a or b is small: a s^2 + b s = c, all seen from that side.
    const double sign = std::copysign(1.0, side);
    const double a = sign * hard, b = sign * thick, c = sign * (side - still);
    const double root = b * b + 4.0 * a * c;
    if (!(root >= 0.0)) continue;  // turns back before
    const double below = b + std::sqrt(root);
    if (below > 0.0) least = std::min(least, 2.0 * c / below);
  }
  return least;
}

}  // namespace

MotionEffort::MotionEffort(const Model& model, const Configuration& posture,
                           const std::vector<int>& joints)
    : model_(&model),
      torque_(model),
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
  rubs_ = false;
  return false;
}

bool MotionEffort::creeps(const JointPoint& q, const JointPoint& step, double share) {
  if (!holds(q, share)) return false;
  for (int k = 0; k < q.size(); ++k) {
    const Joint& joint = model_->joints[at(joints_[at(k)])];
    if (!(joint.friction > 0.0 && joint.effort > 0.0) || std::abs(step[k]) < kSlope) continue;
    if (std::abs(load_.effort(joints_[at(k)])) + joint.friction < share * joint.effort) continue;
    weak_joint_ = joints_[at(k)];
    rubs_ = true;
    return false;
  }
  return true;
}

double MotionEffort::lasting_speed(const Joint& joint) {
  if (!(joint.damping > 0.0 && joint.effort > 0.0)) return joint.velocity;
  return std::clamp(kLasting * (joint.effort - joint.friction) / joint.damping, 0.0, joint.velocity);
}

double MotionEffort::slower(const TimedPath& path) {
  double most = 1.0;     // f^2, of joints without damping and friction
  double dragged = 1.0;  // f, of the others
  largest_ = 0.0;
  JointPoint q, qd, qdd;
  const JointPoint rest = JointPoint::Zero(static_cast<int>(joints_.size()));
  const auto drag = [&](const Joint& joint, int k) { return joint.damping * qd[k] + friction_at(joint, qd[k]); };
  for (const Knot& knot : path) {
    sample(path, knot.time, q, qd, qdd);
    efforts(q, qd, qdd, moving_);
    bool beyond = false;
    for (int k = 0; k < qd.size(); ++k) {
      const Joint& joint = model_->joints[at(joints_[at(k)])];
      const double limit = torque_.effort_in(joints_[at(k)], there_.q);
      if (!(limit > 0.0)) continue;  // the file has none
      const double effort = std::abs(moving_[joints_[at(k)]] + drag(joint, k));
      largest_ = std::max(largest_, effort / limit);
      beyond = beyond || !(effort <= kAll * limit);
    }
    if (!beyond) continue;
    efforts(q, rest, rest, still_);
    for (int k = 0; k < qd.size(); ++k) {
      const Joint& joint = model_->joints[at(joints_[at(k)])];
      const double limit = kAll * torque_.effort_in(joints_[at(k)], there_.q);
      if (!(limit > 0.0)) continue;
      const double hold = still_[joints_[at(k)]], move = moving_[joints_[at(k)]] - hold;
      const double rub = friction_at(joint, qd[k]), thick = joint.damping * qd[k];
      rubs_ = std::abs(hold) < limit;
      if (!(std::abs(hold) < limit && std::abs(hold + rub) < limit)) {
        weak_joint_ = joints_[at(k)];
        return 0.0;
      }
      if (std::abs(rub) + std::abs(thick) > 0.0)
        dragged = std::max(dragged, 1.0 / largest_share(hold + rub, thick, move, limit));
      else
        most = std::max(most, std::abs(move) / (limit - std::copysign(1.0, move) * hold));
    }
  }
  return std::max(std::sqrt(most), dragged);
}

}  // namespace twinbus::planner
