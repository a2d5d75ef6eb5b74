#include "control/joint/posture.h"

#include <algorithm>
#include <cmath>

namespace twinbus {

namespace {
constexpr double kSpeedShare = 0.5;       // of a joint's velocity limit
constexpr double kPeakOfMinJerk = 1.875;  // largest speed over mean speed
}  // namespace

double Posture::inside(int bus_joint, double q) const noexcept {
  const Joint& joint = model_->joints[static_cast<std::size_t>(
      model_->bus_joints[static_cast<std::size_t>(bus_joint)])];
  return joint.kind == JointKind::kContinuous ? q : std::clamp(q, joint.lower, joint.upper);
}

void Posture::rest(const PerJoint<double>& q) noexcept {
  for (int j = 0; j < model_->bus_count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    joint_[k].rest(inside(j, q[k]));
    driven_[k] = false;
  }
}

void Posture::brake(const PerJoint<double>& q, const PerJoint<double>& qd,
                    double duration) noexcept {
  for (int j = 0; j < model_->bus_count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    joint_[k].aim_from(q[k], qd[k], 0.0, inside(j, q[k] + 0.5 * duration * qd[k]), duration);
    driven_[k] = false;
  }
}

void Posture::move(const PerJoint<double>& q, std::int64_t mask, double duration) noexcept {
  double longest = std::isfinite(duration) ? std::clamp(duration, 0.2, 120.0) : 2.0;
  for (int j = 0; j < model_->bus_count(); ++j) {
    if (((mask >> j) & 1) == 0) continue;
    const auto k = static_cast<std::size_t>(j);
    const double speed =
        kSpeedShare * model_->joints[static_cast<std::size_t>(model_->bus_joints[k])].velocity;
    const double way = std::abs(inside(j, q[k]) - joint_[k].position());
    if (speed > 0.0) longest = std::max(longest, kPeakOfMinJerk * way / speed);
  }
  for (int j = 0; j < model_->bus_count(); ++j) {
    if (((mask >> j) & 1) == 0) continue;
    const auto k = static_cast<std::size_t>(j);
    joint_[k].aim(inside(j, q[k]), longest);
  }
}

void Posture::set(int bus_joint, double q, double qd) noexcept {
  const auto k = static_cast<std::size_t>(bus_joint);
  joint_[k].rest(inside(bus_joint, q));
  driven_[k] = true;
  driven_rate_[k] = qd;
}

void Posture::advance(double dt) noexcept {
  for (int j = 0; j < model_->bus_count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    joint_[k].advance(dt);
    driven_[k] = false;
  }
}

bool Posture::moving() const noexcept {
  return std::any_of(joint_.begin(), joint_.begin() + model_->bus_count(),
                     [](const MinJerk& joint) { return joint.moving(); });
}

}  // namespace twinbus
