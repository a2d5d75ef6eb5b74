#include "control/joint/posture.h"

#include <algorithm>
#include <cmath>

#include "common/math/index.h"
#include "robot/kinematics/brake.h"

namespace twinbus::inline control {

namespace {
constexpr double kSpeedShare = 0.5;       // of a joint's velocity limit
constexpr double kPeakOfMinJerk = 1.875;  // largest speed over mean speed
constexpr double kShortest = 0.2;         // of a way [s]
constexpr double kShows = 0.05;    // that a new way leads on from a joint that is held, so that a guard sees where to [s]
constexpr double kClearFor = 0.5;  // the guard must be content before a joint goes on [s]
constexpr int kMostBlocks = 3;     // without going on in between: then the way is given up
constexpr double kGoesOn = 0.05;   // a joint that came so far since it was held last [rad or m]
constexpr double kArrived = 1e-6;  // from where it goes [rad or m]
}  // namespace

double Posture::inside(int bus_joint, double q) const noexcept {
  const Joint& joint = model_->joints[static_cast<std::size_t>(
      model_->bus_joints[static_cast<std::size_t>(bus_joint)])];
  return joint.kind == JointKind::kContinuous ? q : std::clamp(q, joint.lower, joint.upper);
}

// To get there at a share of the velocity limit.
double Posture::least_time(int bus_joint, double q) const noexcept {
  const auto k = at(bus_joint);
  const double speed = kSpeedShare * model_->joints[at(model_->bus_joints[k])].velocity;
  return speed > 0.0 ? kPeakOfMinJerk * std::abs(inside(bus_joint, q) - joint_[k].position()) / speed : 0.0;
}

void Posture::rest(const PerJoint<double>& q) noexcept {
  asked_ = waiting_ = braked_ = 0;
  for (int j = 0; j < model_->bus_count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    joint_[k].rest(inside(j, q[k]));
    driven_[k] = false;
  }
}

void Posture::brake(const PerJoint<double>& q, const PerJoint<double>& qd,
                    double duration) noexcept {
  asked_ = waiting_ = braked_ = 0;
  for (int j = 0; j < model_->bus_count(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    joint_[k].aim_from(q[k], qd[k], 0.0, inside(j, q[k] + 0.5 * duration * qd[k]), duration);
    driven_[k] = false;
  }
}

void Posture::move(const PerJoint<double>& q, std::int64_t mask, double duration) noexcept {
  double longest = std::isfinite(duration) ? std::clamp(duration, kShortest, 120.0) : 2.0;
  for (int j = 0; j < model_->bus_count(); ++j) {
    if ((mask & bit(j)) != 0) longest = std::max(longest, least_time(j, q[at(j)]));
  }
  for (int j = 0; j < model_->bus_count(); ++j) {
    if ((mask & bit(j)) == 0) continue;
    MinJerk& joint = joint_[at(j)];
    const double to = inside(j, q[at(j)]), held_towards = way_[at(j)].held_towards;
    const bool was_held = (braked_ & bit(j)) != 0;
    // On towards what it is held for it leads no further.
    const bool same = was_held && held_towards * (to - joint.position()) > 0.0;
    way_[at(j)] = {.shown = same ? kShows : 0.0, .held_towards = held_towards};
    if (was_held) {
      joint.aim_from(joint.position(), driven_rate_[at(j)], 0.0, to, longest);
    } else {
      joint.aim(to, longest);
    }
    asked_ |= bit(j);
    for (std::int64_t* bits : {&waiting_, &given_up_, &braked_}) *bits &= ~bit(j);
  }
}

// Where it was put last, as fast as it was: what holds it brings it to rest.
void Posture::hold(int bus_joint, double q, double qd) noexcept {
  Way& way = way_[at(bus_joint)];
  MinJerk& joint = joint_[at(bus_joint)];
  const std::int64_t it = bit(bus_joint);
  if ((asked_ & it) != 0 && way.shown < kShows && (waiting_ & it) == 0) return;
  const bool on_its_way = joint.moving() && std::abs(joint.target() - joint.position()) > kArrived;
  if (on_its_way && (asked_ & it) != 0 && (waiting_ & it) == 0) {
    way.to = joint.target();
    way.left = joint.time_left();
    way.held_towards = way.to - joint.position();
    if (std::abs(q - way.held_at) > kGoesOn) way.blocks = 0;
    way.held_at = q;
    if (++way.blocks < kMostBlocks) {
      waiting_ |= it;
      held_.waits |= it;
    } else {
      asked_ &= ~it;
      given_up_ |= it;
      held_.given_up |= it;
    }
  }
  way.clear_for = 0.0;
  joint.rest(inside(bus_joint, q));
  driven_[at(bus_joint)] = true;
  driven_rate_[at(bus_joint)] = qd;
  braked_ |= it;
}

// It comes to rest first where it is still fast.
void Posture::let_go(int bus_joint, double dt) noexcept {
  Way& way = way_[at(bus_joint)];
  MinJerk& joint = joint_[at(bus_joint)];
  const std::int64_t it = bit(bus_joint);
  if ((braked_ & it) != 0) {
    braked_ &= ~it;
    const double q = joint.position(), qd = driven_rate_[at(bus_joint)];
    const double time = std::abs(qd) / brake_deceleration(model_->joints[at(model_->bus_joints[at(bus_joint)])]);
    if (time > dt) joint.aim_from(q, qd, 0.0, inside(bus_joint, q + 0.5 * qd * time), time);
  }
  if ((waiting_ & it) == 0 || (way.clear_for += dt) < kClearFor) return;
  waiting_ &= ~it;
  joint.aim(way.to, std::max({kShortest, way.left, least_time(bus_joint, way.to)}));
}

void Posture::yield(std::int64_t mask, const PerJoint<double>& q, const PerJoint<double>& qd, double dt) noexcept {
  for (int j = 0; j < model_->bus_count() && (mask | braked_ | asked_) != 0; ++j) {
    way_[at(j)].shown += dt;
    if ((mask & bit(j)) != 0) {
      hold(j, q[at(j)], qd[at(j)]);
    } else if (((braked_ | waiting_) & bit(j)) != 0) {
      let_go(j, dt);
    }
  }
}

void Posture::set(int bus_joint, double q, double qd) noexcept {
  const auto k = static_cast<std::size_t>(bus_joint);
  asked_ &= ~bit(bus_joint);
  waiting_ &= ~bit(bus_joint);
  braked_ &= ~bit(bus_joint);
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
  for (int j = 0; j < model_->bus_count(); ++j) {
    const bool brakes = (braked_ & bit(j)) != 0 && driven_rate_[at(j)] != 0.0;
    if (brakes || joint_[at(j)].moving()) return true;
  }
  return false;
}

}  // namespace twinbus::control
