#include "control/point_feet/step_gait.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus {

namespace {
constexpr double kPeriod = 2.5;     // times sqrt(h / g)
constexpr double kLift = 0.2;       // of the height
constexpr double kFroude = 0.9;     // fastest, of sqrt(g h)
constexpr double kSideways = 0.5;   // of it
constexpr double kTurn = 0.2;       // of sqrt(g / h)
constexpr double kFarthest = 0.45;  // of the height
}  // namespace

StepGait::StepGait(const PointFeetBody& body) noexcept
    : omega_(std::sqrt(kGravity / body.height)),
      period_(kPeriod / omega_),
      lift_(kLift * body.height),
      farthest_(kFarthest * body.height) {
  const double fastest = kFroude * std::sqrt(kGravity * body.height);
  most_ << fastest, kSideways * fastest, body.two() ? 0.0 : kTurn * omega_;  // two points cannot turn the robot
}

Eigen::Vector3d StepGait::possible(const Eigen::Vector3d& velocity) const noexcept {
  const Eigen::Vector3d asked = most_.z() > 0.0 ? velocity : Eigen::Vector3d(velocity.x(), velocity.y(), 0.0);
  const double share = asked.cwiseQuotient(most_.cwiseMax(1e-9)).norm();
  return share > 1.0 ? Eigen::Vector3d(asked / share) : asked;
}

void StepGait::limit(double fastest) noexcept {
  if (!(fastest > 0.0)) return;
  const double share = std::min(1.0, fastest / most_.x());
  most_ << fastest, share * most_.y(), share * most_.z();
}

Eigen::Vector2d StepGait::from_capture_point(int leg, const Eigen::Vector2d& velocity, double width) const noexcept {
  const Eigen::Vector2d on = velocity * (step_time() / (std::exp(omega_ * step_time()) - 1.0));
  return -on + Eigen::Vector2d(0.0, (leg == 0 ? width : -width) * inward());
}

void StepGait::begin(int leg) noexcept {
  steps_ = true;
  ends_ = false;
  phase_ = leg == 1 || leg == 2 ? 0.5 : 0.0;
  periods_ = 0;
}

// Pair 0 (front left, hind right) is in the air first.
double StepGait::phase_of(int leg) const noexcept {
  const bool other = leg == 1 || leg == 2;
  const double p = phase_ + (other ? 0.5 : 0.0);
  return p - std::floor(p);
}

bool StepGait::swings(int leg) const noexcept { return steps_ && phase_of(leg) < 1.0 - kDuty; }

double StepGait::swing_done(int leg) const noexcept { return phase_of(leg) / (1.0 - kDuty); }

double StepGait::stance_done(int leg) const noexcept { return steps_ ? (phase_of(leg) - (1.0 - kDuty)) / kDuty : 0.5; }

void StepGait::advance(double dt) noexcept {
  if (!steps_) return;
  const bool stood = !swings(0) && !swings(1);
  if (ends_ && stood) {
    rest();
    return;
  }
  phase_ += dt / period_;
  if (phase_ >= 1.0) {
    phase_ -= 1.0;
    ++periods_;
  }
}

}  // namespace twinbus
