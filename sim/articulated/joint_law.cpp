#include "sim/articulated/joint_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/world/coulomb_friction.h"

namespace twinbus::inline sim {

JointLaw::JointLaw(const Joint& joint, const WorldConfig& config)
    : lower_(-std::numeric_limits<double>::infinity()),
      upper_(std::numeric_limits<double>::infinity()),
      limit_(joint.effort > 0.0 && std::isfinite(joint.effort) ? joint.effort : 0.0),
      damping_(joint.damping * config.friction_scale),
      friction_(coulomb_friction(joint, config)),
      backlash_(config.backlash),
      stick_(friction_ > 0.0 ? kStickSpeed : std::numeric_limits<double>::infinity()),
      stick_gain_(friction_ / kStickSpeed) {
  if (joint.kind == JointKind::kContinuous) return;
  lower_ = joint.lower;
  upper_ = joint.upper;
}

void JointLaw::set_tau(double tau) noexcept {
  tau_ = std::isfinite(tau) ? std::clamp(tau, -limit_, limit_) : 0.0;
  play_ = flank();
}

void JointLaw::approach(double qd_end) noexcept {
  Pieces next = pieces_at(qd_end);
  if (next.servo * pieces_.servo < 0) next.servo = 0;
  if (next.friction * pieces_.friction < 0) next.friction = 0;
  if (next.stop * pieces_.stop < 0) next.stop = 0;
  pieces_ = next;
}

void JointLaw::approach_by_one(double qd_end) noexcept {
  const Pieces before = pieces_;
  approach(qd_end);
  if (pieces_.stop != before.stop) {
    pieces_ = {before.servo, before.friction, pieces_.stop};
  } else if (pieces_.friction != before.friction) {
    pieces_.servo = before.servo;
  }
}

double JointLaw::torque_at(double q, double qd) const noexcept {
  const ServoTarget& t = target_;
  const double asked = t.kp * (t.q - q) + t.kd * (t.qd - qd) + t.tau;
  return std::clamp(asked, -limit_, limit_) - damping_ * qd;
}

double JointLaw::flank() const noexcept {
  return 0.5 * backlash_ * std::clamp(tau_ / kPlayTorque, -1.0, 1.0);
}

}  // namespace twinbus::sim
