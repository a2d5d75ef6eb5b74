#include "control/point_feet/step_gait.h"

#include <algorithm>
#include <cmath>

#include "robot/dynamics/inverse_dynamics.h"

namespace twinbus::inline control {

namespace {
constexpr double kPeriod = 2.5;     // times sqrt(h / g)
constexpr double kLift = 0.2;       // of the height
constexpr double kFroude = 0.9;     // fastest, of sqrt(g h)
constexpr double kSideways = 0.5;   // of it
constexpr double kSpin = 0.2;       // of sqrt(g / h)
constexpr double kFarthest = 0.45;  // of the height
constexpr double kCrawlFroude = 0.07, kCrawlTurn = 0.03;  // of a crawl, as above
constexpr double kSlower = 0.8;     // of what a crawl does at most: it trots no longer
constexpr double kClearly = 0.2;    // of a crawl's most: backwards, or forward again
constexpr double kLatest = 0.5;     // of a step: whose foot is farther on is sent up again by a trot that catches it
}  // namespace

StepGait::StepGait(const PointFeetBody& body, PointGait wanted) noexcept
    : omega_(std::sqrt(kGravity / body.height)),
      period_(kPeriod / omega_),
      lift_(kLift * body.height),
      farthest_(kFarthest * body.height),
      wanted_(body.two() ? PointGait::kTrot : wanted) {
  const double scale = std::sqrt(kGravity * body.height);
  most_ << kFroude * scale, kSideways * kFroude * scale, body.two() ? 0.0 : kSpin * omega_;  // two points cannot turn the robot
  most_crawl_ << kCrawlFroude * scale, kSideways * kCrawlFroude * scale, kCrawlTurn * omega_;
}

Eigen::Vector3d StepGait::possible(const Eigen::Vector3d& velocity) const noexcept {
  const Eigen::Vector3d& most = most_velocity();
  const Eigen::Vector3d asked = most.z() > 0.0 ? velocity : Eigen::Vector3d(velocity.x(), velocity.y(), 0.0);
  const double share = asked.cwiseQuotient(most.cwiseMax(1e-9)).norm();
  return share > 1.0 ? Eigen::Vector3d(asked / share) : asked;
}

void StepGait::limit(double fastest) noexcept {
  if (!(fastest > 0.0)) return;
  const double share = std::min(1.0, fastest / most_.x());
  most_ << fastest, share * most_.y(), share * most_.z();
  most_crawl_ = most_crawl_.cwiseMin(most_);
}

bool StepGait::crawls_at(const Eigen::Vector3d& velocity) const noexcept {
  if (wanted_ != PointGait::kBySpeed) return wanted_ == PointGait::kCrawl;
  return velocity.cwiseQuotient(most_crawl_).norm() <= (steps_ && !crawls_ ? kSlower : 1.0);
}

bool StepGait::backwards_at(const Eigen::Vector3d& velocity) const noexcept {
  const double clearly = kClearly * most_crawl_.x();
  return velocity.x() < (steps_ && crawls_ && backwards_ ? clearly : -clearly);
}

Eigen::Vector2d StepGait::from_capture_point(int leg, const Eigen::Vector2d& velocity, double width) const noexcept {
  const Eigen::Vector2d on = velocity * (step_time() / (std::exp(omega_ * step_time()) - 1.0));
  return -on + Eigen::Vector2d(0.0, (leg == 0 ? width : -width) * inward());
}

void StepGait::begin(int leg) noexcept {
  steps_ = true;
  ends_ = crawls_ = false;
  phase_ = leg == 1 || leg == 2 ? 0.5 : 0.0;
}

void StepGait::begin_crawl(bool backwards) noexcept {
  steps_ = crawls_ = true;
  backwards_ = backwards;
  ends_ = false;
  phase_ = 0.0;
}

void StepGait::trot_on() noexcept {
  const int leg = leg_of(quarter());
  const double done = swings(leg) ? std::min(swing_done(leg), kLatest) : 0.0;
  begin(leg);
  phase_ += done * swing_share();
}

// Pair 0 (front left, hind right) is in the air first.
double StepGait::phase_of(int leg) const noexcept {
  double p = phase_;
  if (crawls_) {  // its own begins as it leaves the ground
    int turn = 0;
    while (turn < 3 && leg_of(turn) != leg) ++turn;
    p -= 0.25 * (turn + kShift);
    if (p < 0.0 && p > -1e-9) p = 0.0;
  } else if (leg == 1 || leg == 2) {
    p += 0.5;
  }
  return p - std::floor(p);
}

bool StepGait::swings(int leg) const noexcept {
  if (!crawls_) return steps_ && phase_of(leg) < swing_share();
  return steps_ && leg_of(quarter()) == leg && in_quarter() >= kShift;
}

double StepGait::swing_done(int leg) const noexcept { return phase_of(leg) / swing_share(); }

double StepGait::stance_done(int leg) const noexcept {
  return steps_ ? (phase_of(leg) - swing_share()) / stance_share() : 0.5;
}

double StepGait::shift_left() const noexcept { return std::max(0.0, kShift - in_quarter()) * 0.25 * period(); }

double StepGait::step_left() const noexcept { return std::min(1.0 - kShift, 1.0 - in_quarter()) * 0.25 * period(); }

void StepGait::advance(double dt, bool may_lift) noexcept {
  if (!steps_) return;
  const bool stood = crawls_ ? in_quarter() < kShift : !swings(0) && !swings(1);
  if (ends_ && stood) {
    rest();
    return;
  }
  const double on = dt / period();
  if (crawls_ && stood && !may_lift && in_quarter() + 4.0 * on >= kShift) return;
  phase_ += on;
  if (phase_ >= 1.0) phase_ -= 1.0;
}

StepGait step_gait_of(const Model& model) {
  const Walking walking = model.walking;
  StepGait gait(PointFeetBody(model), walking.gait);
  gait.limit(walking.fastest);
  return gait;
}

}  // namespace twinbus::control
