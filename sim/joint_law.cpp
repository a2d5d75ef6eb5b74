#include "sim/joint_law.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace twinbus {

namespace {

// So stiff that a stop is passed by less than 1e-9 rad at any torque a robot has.
constexpr double kStopGain = 1e11;  // [N m s/rad]
// A joint set beyond its stop comes back by this share of the excess per step, not faster than so.
constexpr double kStopShare = 0.2;
constexpr double kStopReturn = 2.0;   // [rad/s or m/s]
constexpr double kStopGuess = 1e-12;  // a joint so near its stop is expected to lean on it [rad]

double stop_bound(double room, double rate) {
  return room >= 0.0 ? room * rate : std::max(kStopShare * room * rate, -kStopReturn);
}

}  // namespace

JointLaw::JointLaw(const Joint& joint, const WorldConfig& config)
    : lower_(-std::numeric_limits<double>::infinity()),
      upper_(std::numeric_limits<double>::infinity()),
      limit_(joint.effort > 0.0 && std::isfinite(joint.effort) ? joint.effort : 0.0),
      damping_(joint.damping * config.friction_scale),
      friction_(joint.friction * config.friction_scale + config.joint_friction),
      backlash_(config.backlash) {
  if (joint.kind == JointKind::kContinuous) return;
  lower_ = joint.lower;
  upper_ = joint.upper;
}

void JointLaw::set_tau(double tau) noexcept {
  tau_ = std::isfinite(tau) ? std::clamp(tau, -limit_, limit_) : 0.0;
  play_ = flank();
}

void JointLaw::begin(double q, double qd, double h) noexcept {
  const ServoTarget& t = target_;
  servo_.force = t.kp * (t.q - q - play_) + t.kd * t.qd + t.tau;
  servo_.gain = h * t.kp + t.kd;
  const double rate = 1.0 / h;
  high_bound_ = stop_bound(upper_ - q, rate);
  low_bound_ = -stop_bound(q - lower_, rate);
  pieces_ = pieces_at(qd);
  if (upper_ - q <= kStopGuess && qd >= 0.0) pieces_.stop = 1;
  if (q - lower_ <= kStopGuess && qd <= 0.0) pieces_.stop = -1;
}

JointRow JointLaw::row() const noexcept {
  JointRow row = servo_;
  if (pieces_.servo != 0) row = {.force = pieces_.servo * limit_, .gain = 0.0};
  row.gain += damping_;
  if (pieces_.friction != 0) {
    row.force -= pieces_.friction * friction_;
  } else {
    row.gain += friction_ / kStickSpeed;
  }
  if (pieces_.stop != 0) {
    row.force += kStopGain * (pieces_.stop > 0 ? high_bound_ : low_bound_);
    row.gain += kStopGain;
  }
  return row;
}

JointLaw::Pieces JointLaw::pieces_at(double qd) const noexcept {
  const double asked = servo_.force - servo_.gain * qd;
  Pieces pieces;
  pieces.servo = asked > limit_ ? 1 : (asked < -limit_ ? -1 : 0);
  if (friction_ > 0.0) pieces.friction = qd > kStickSpeed ? 1 : (qd < -kStickSpeed ? -1 : 0);
  pieces.stop = qd > high_bound_ ? 1 : (qd < low_bound_ ? -1 : 0);
  return pieces;
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

void JointLaw::finish(double qd, double share) noexcept {
  tau_ = pieces_.servo != 0 ? pieces_.servo * limit_
                            : std::clamp(servo_.force - servo_.gain * qd, -limit_, limit_);
  if (backlash_ > 0.0) play_ += share * kPlayRate * (flank() - play_);
}

double JointLaw::torque_at(double q, double qd) const noexcept {
  const ServoTarget& t = target_;
  const double asked = t.kp * (t.q - q) + t.kd * (t.qd - qd) + t.tau;
  return std::clamp(asked, -limit_, limit_) - damping_ * qd;
}

double JointLaw::flank() const noexcept {
  return 0.5 * backlash_ * std::clamp(tau_ / kPlayTorque, -1.0, 1.0);
}

}  // namespace twinbus
