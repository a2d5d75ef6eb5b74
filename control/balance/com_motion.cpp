#include "control/balance/com_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twinbus::inline control {

namespace {
constexpr double kMostAmplitude = 0.10;    // [m]
constexpr double kMostFrequency = 1.5;     // [Hz]
constexpr double kMostAcceleration = 1.5;  // [m/s^2]: a ZMP 100 mm away, a seventh of gravity
constexpr double kRamp = 1.5;              // [s] to the amplitude asked
constexpr double kLeanRate = 5.0;          // [rad/s] of the critically damped follower
// A stick that is thrown over asks for this at most: no foot may become so light that it slips.
constexpr double kLeanSpeed = 0.15;  // [m/s]
constexpr double kBack = 1.0;  // from a way that is given no more [s]
constexpr double kTwoPi = 6.283185307179586;

double sensible(double frequency) noexcept {
  return frequency > 0.0 ? std::clamp(frequency, 0.02, kMostFrequency) : 0.5;
}
}  // namespace

void ComMotion::start(const Eigen::Vector3d& home, const Eigen::Vector3d& position,
                      const Eigen::Vector3d& velocity, double duration) noexcept {
  way_x_.aim_from(position.x(), velocity.x(), 0.0, home.x(), duration);
  way_y_.aim_from(position.y(), velocity.y(), 0.0, home.y(), duration);
  way_z_.aim_from(position.z(), velocity.z(), 0.0, home.z(), duration);
  amplitude_.rest(0.0);
  frequency_.rest(0.5);
  motion_ = next_motion_ = Motion::kNone;
  phase_ = 0.0;
  lean_.setZero();
  lean_rate_.setZero();
  lean_target_.setZero();
  lean_wanted_.setZero();
  given_.setZero();
  given_rate_.setZero();
  given_acceleration_.setZero();
  back_ = {};
  is_given_ = was_given_ = false;
  evaluate();
}

double ComMotion::possible(double amplitude, double frequency) noexcept {
  const double f = sensible(frequency);
  const double a = std::min(std::abs(amplitude), kMostAmplitude);
  return std::min(a, kMostAcceleration / (kTwoPi * kTwoPi * f * f));
}

void ComMotion::request(Motion motion, double amplitude, double frequency) noexcept {
  if (!std::isfinite(amplitude) || !std::isfinite(frequency)) return;
  const double f = sensible(frequency);
  const bool forward = motion == Motion::kSway && amplitude < 0.0;
  const double a = motion == Motion::kNone ? 0.0 : possible(amplitude, frequency);
  next_motion_ = motion;
  next_amplitude_ = a;
  next_frequency_ = f;
  next_forward_ = forward;
  const bool same = motion == motion_ && forward == forward_;
  if (motion_ == Motion::kNone || same) {
    motion_ = motion;
    forward_ = forward;
    if (amplitude_.position() == 0.0) {
      phase_ = 0.0;
      frequency_.rest(f);
    } else {
      frequency_.aim(f, kRamp);
    }
    amplitude_.aim(a, kRamp);
  } else {
    amplitude_.aim(0.0, kRamp);  // one motion ends before the next begins
  }
}

void ComMotion::stop(double duration) noexcept {
  next_motion_ = Motion::kNone;
  next_amplitude_ = 0.0;
  lean_target_.setZero();
  if (amplitude_.target() != 0.0) amplitude_.aim(0.0, duration);
}

void ComMotion::advance(double dt) noexcept {
  way_x_.advance(dt);
  way_y_.advance(dt);
  way_z_.advance(dt);
  amplitude_.advance(dt);
  frequency_.advance(dt);
  phase_ = std::remainder(phase_ + dt * kTwoPi * frequency_.position(), kTwoPi);
  if (!amplitude_.moving() && amplitude_.position() == 0.0 && motion_ != Motion::kNone) {
    motion_ = Motion::kNone;
    if (next_motion_ != Motion::kNone) {
      motion_ = next_motion_;
      forward_ = next_forward_;
      phase_ = 0.0;
      frequency_.rest(next_frequency_);
      amplitude_.aim(next_amplitude_, kRamp);
    }
  }
  const Eigen::Vector3d way = lean_target_ - lean_wanted_;
  const double farthest = dt * kLeanSpeed;
  const double distance = way.norm();
  lean_wanted_ = distance > farthest ? lean_wanted_ + farthest / distance * way : lean_target_;
  lean_acceleration_ =
      kLeanRate * kLeanRate * (lean_wanted_ - lean_) - 2.0 * kLeanRate * lean_rate_;
  lean_rate_ += dt * lean_acceleration_;
  lean_ += dt * lean_rate_;
  lead_back(dt);
  evaluate();
}

// Nobody gives a way any more: back to home from where it was left.
void ComMotion::lead_back(double dt) noexcept {
  const bool was_given = std::exchange(was_given_, std::exchange(is_given_, false));
  if (was_given_) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto d = static_cast<Eigen::Index>(i);
    if (was_given) back_[i].aim_from(given_[d], given_rate_[d], given_acceleration_[d], 0.0, kBack);
    back_[i].advance(dt);
    given_[d] = back_[i].position();
    given_rate_[d] = back_[i].velocity();
    given_acceleration_[d] = back_[i].acceleration();
  }
}

void ComMotion::evaluate() noexcept {
  position_ = {way_x_.position(), way_y_.position(), way_z_.position()};
  velocity_ = {way_x_.velocity(), way_y_.velocity(), way_z_.velocity()};
  acceleration_ = {way_x_.acceleration(), way_y_.acceleration(), way_z_.acceleration()};
  position_ += lean_ + given_;
  velocity_ += lean_rate_ + given_rate_;
  acceleration_ += lean_acceleration_ + given_acceleration_;
  const double w = kTwoPi * frequency_.position();
  const double wd = kTwoPi * frequency_.velocity();
  const double s = std::sin(phase_);
  const double c = std::cos(phase_);
  const double a = amplitude_.position();
  const double ad = amplitude_.velocity();
  const double add = amplitude_.acceleration();
  if (motion_ == Motion::kSway) {
    const int axis = forward_ ? 0 : 1;
    position_[axis] += a * s;
    velocity_[axis] += ad * s + a * w * c;
    acceleration_[axis] += add * s + 2.0 * ad * w * c + a * (wd * c - w * w * s);
  } else if (motion_ == Motion::kSquat) {
    position_.z() -= a * (1.0 - c);
    velocity_.z() -= ad * (1.0 - c) + a * w * s;
    acceleration_.z() -= add * (1.0 - c) + 2.0 * ad * w * s + a * (wd * s + w * w * c);
  }
}

bool ComMotion::resting() const noexcept {
  return motion_ == Motion::kNone && !way_x_.moving() && !way_y_.moving() && !way_z_.moving() &&
         lean_rate_.norm() < 1e-3 && given_rate_.norm() < 1e-3 && !is_given_ && !was_given_;
}

}  // namespace twinbus::control
