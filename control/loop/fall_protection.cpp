#include "control/loop/fall_protection.h"

#include <algorithm>
#include <cmath>

#include "robot/kinematics/leg_chain.h"
#include "control/legs/leg_reach.h"
#include "common/math/index.h"

namespace twinbus::inline control {

namespace {
constexpr double kLost = 0.45;     // [rad]: caught pushes stay below half of it
constexpr double kLeans = 0.15;    // least tilt at which its rate counts [rad]
constexpr double kAhead = 0.2;     // [s]
constexpr double kKneeBend = 1.5;  // of a robot that has no pose for it [rad]
constexpr double kArmTime = 0.3;   // [s] to the pose; joints as slow as they are take longer
constexpr double kStiffness = 0.15, kDamping = 0.5;  // shares of the gains
constexpr double kStill = 0.2;                       // of the trunk [rad/s]
}  // namespace

Brace::Brace(const Model& model) : model_(&model) {
  const int pose = model.find_pose("brace");
  for (int k = 0; k < model.bus_count() && pose >= 0; ++k) {
    q_[at(k)] = model.poses[at(pose)].q[at(model.bus_joints[at(k)])];
    mask_ |= bit(k);
  }
  for (int foot = 0; foot < 2 && pose < 0; ++foot) {
    if (model.soles[at(foot)].link < 0 || !leg_chain(model, foot).balances()) continue;
    const LegReach reach = leg_reach(model, foot);
    for (int k = 0; k < model.bus_count(); ++k) {
      if (model.bus_joints[at(k)] != reach.knee) continue;
      q_[at(k)] = reach.straight + reach.bends * kKneeBend;
      mask_ |= bit(k);
    }
  }
}

bool Brace::is_lost(const Estimator& estimator) noexcept {
  const Configuration& now = estimator.configuration();
  const Eigen::Vector3d up = now.base.linear().col(2);
  const double tilt = std::acos(std::clamp(up.z(), -1.0, 1.0));
  if (tilt < kLeans) return false;
  // cos(tilt)' = (omega x up)_z
  const double rate = -now.base_angular_velocity.cross(up).z() / std::sin(tilt);
  return tilt + kAhead * rate > kLost;
}

void Brace::start(const SetPoint* last, const RobotState& state, Posture& posture) noexcept {
  time_ = quiet_ = 0.0;
  if (last != nullptr) {
    posture.brake(last->q, last->qd, kArmTime);
  } else {
    posture.rest(state.q);
  }
  posture.move(q_, mask_, kArmTime);
}

void Brace::update(const Estimator& estimator, const Posture& posture, double dt,
                   SetPoint& set_point) noexcept {
  time_ += dt;
  const double turns = estimator.configuration().base_angular_velocity.norm();
  quiet_ = turns < kStill ? quiet_ + dt : 0.0;
  for (int k = 0; k < model_->bus_count(); ++k) {
    const Joint& joint = model_->joints[at(model_->bus_joints[at(k)])];
    set_point.q[at(k)] = posture.q(k);
    set_point.qd[at(k)] = posture.qd(k);
    set_point.tau[at(k)] = 0.0;
    set_point.kp[at(k)] = kStiffness * joint.kp;
    set_point.kd[at(k)] = kDamping * joint.kd;
  }
}

}  // namespace twinbus::control
